// The library's objects. Made by generate.py from ../api.json: do not edit.
#if NETSTANDARD2_1_OR_GREATER || NETCOREAPP2_1_OR_GREATER || UNITY_2021_2_OR_NEWER
#define CONTDYN_SPANS
#endif
using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;

namespace Contdyn
{
    /// <summary>What a call of the C library returns.</summary>
    public enum Status
    {
        Ok = 0,
        /// <summary>a pointer that may not be null is null</summary>
        ErrorNull = 1,
        /// <summary>the handle is of another kind of object</summary>
        ErrorHandle = 2,
        /// <summary>a number outside its valid range, or NaN or infinity where it has no meaning</summary>
        ErrorValue = 3,
        /// <summary>not one of the enumeration's values</summary>
        ErrorEnum = 4,
        /// <summary>an index, a range or a buffer length that does not fit the object</summary>
        ErrorRange = 5,
        /// <summary>a size that cannot be represented in memory</summary>
        ErrorSize = 6,
        /// <summary>the allocator returned null</summary>
        ErrorMemory = 7,
        /// <summary>the field is not switched on: see cd_*_enable_field</summary>
        ErrorDisabled = 8,
        /// <summary>what this object cannot do, or what was left out of this build: see cd_build_info</summary>
        ErrorUnsupported = 9,
        /// <summary>the state left the finite range during a step, or has not come back to it</summary>
        ErrorDiverged = 10,
        /// <summary>the bytes to load are damaged, or of a later version or another kind</summary>
        ErrorFormat = 11,
        /// <summary>the two objects, or the object and the bytes, differ in shape or precision</summary>
        ErrorMismatch = 12,
        /// <summary>steps were made, but an iterative solve ended short of its tolerance</summary>
        ErrorTolerance = 13,
        /// <summary>steps were made, but a callback gave numbers that it may not</summary>
        ErrorCallback = 14,
    }

    /// <summary>What an object stores its state in; chosen when it is made. Steps compute in double precision
    /// whatever it is, but for those that an object's header names.</summary>
    public enum Precision
    {
        Float32 = 0,
        Float64 = 1,
    }

    /// <summary>How a step advances the state by dt. CD_METHOD_IMPLICIT is the default, with lambda = 1/2. Bounds
    /// hold, and energy is kept, to rounding: in a step a node's position may be wrong by some 1e-15 of the
    /// distance that its velocity covers in dt, in a ring or with bend also by 1e-15 of the distance that it would
    /// fall in dt, which shows where dt is longer than 1e12 times the time of the fastest swing.</summary>
    public enum Method
    {
        /// <summary>Kass 1997, eq. 21: lambda = 1/2 keeps energy and is second order, lambda = 1 is backward Euler; for
        /// lambda &gt;= 1/2 bounded at every dt</summary>
        Implicit = 0,
        /// <summary>Kass 1997, eq. 13; without damping it grows at every dt</summary>
        ForwardEuler = 1,
        /// <summary>the new velocity moves the position, of water in its symmetric form (velocity Verlet); bounded up
        /// to cd_*_stable_dt</summary>
        SymplecticEuler = 2,
        /// <summary>two implicit stages with gamma = 1 - 1/sqrt(2) (SDIRK2): second order, and L-stable: motion too
        /// fast for dt dies out</summary>
        StiffSecond = 3,
    }

    /// <summary>How the two-dimensional system of a membrane's implicit step is solved.</summary>
    public enum Solver
    {
        /// <summary>rows, then columns: Kass 1997, section 9</summary>
        Alternating = 0,
        /// <summary>both at once, to a tolerance</summary>
        Coupled = 1,
        /// <summary>the first where that is right for the step, else the second</summary>
        Auto = 2,
    }

    /// <summary>How the total mass is dealt out to the nodes.</summary>
    public enum MassRule
    {
        /// <summary>every node the same: the notes' rule, first order in space</summary>
        Equal = 0,
        /// <summary>nodes on a border half as heavy as those inside: second order in space</summary>
        HalfEnds = 1,
    }

    /// <summary>The instructions that steps are made of. All give the same bits as long as all numbers are finite;
    /// how far infinity and NaN spread in steps that end with CD_ERROR_DIVERGED may differ. A new object has the
    /// fastest that its processor runs.</summary>
    public enum Kernels
    {
        /// <summary>what every processor of the target has: SSE2 on x86-64, NEON on AArch64, and on WebAssembly SIMD128
        /// where that was built with -msimd128</summary>
        Plain = 0,
        Avx2 = 1,
        /// <summary>the parts F and DQ of AVX-512</summary>
        Avx512 = 2,
    }

    /// <summary>What holds a node. The values are also those of the field CD_PIN.</summary>
    public enum Node
    {
        Free = 0,
        /// <summary>infinite mass, at rest</summary>
        Pinned = 1,
        /// <summary>infinite mass, moves with the velocity written to it</summary>
        Driven = 2,
        /// <summary>border nodes only: free, with the impedance sqrt(stiffness mass) that sends no echo back</summary>
        Matched = 3,
        /// <summary>infinite mass; each call of cd_*_step moves it to where CD_TARGET is, evenly, and there it stays
        /// until CD_TARGET is written again. Without that field as CD_NODE_DRIVEN: it stands still where no velocity
        /// has been written</summary>
        Posed = 4,
    }

    /// <summary>What a collider of ropes and cloth is.</summary>
    public enum Shape
    {
        None = 0,
        Plane = 1,
        Capsule = 2,
        Bed = 3,
        Callback = 4,
    }

    /// <summary>What becomes of places outside of an object that it is sampled at.</summary>
    public enum Outside
    {
        /// <summary>CD_ERROR_VALUE, and nothing is told of the other places either</summary>
        Refused = 0,
        /// <summary>they stand for the nearest place in the object; only NaN is refused</summary>
        Nearest = 1,
    }

    /// <summary>Per-node and per-spring data; each object's header lists those that it has. They are in one list,
    /// since a field that several objects have means the same in each. All hold numbers, pins and masks too, for
    /// one read and one write.</summary>
    public enum Field
    {
        Position = 0,
        Velocity = 1,
        Force = 2,
        Mass = 3,
        Stiffness = 4,
        Bend = 5,
        Pin = 6,
        Target = 7,
        StiffnessU = 8,
        StiffnessV = 9,
        Mask = 10,
        Depth = 11,
        Bed = 12,
        Surface = 13,
        VelocityX = 14,
        VelocityY = 15,
        Source = 16,
        Pressure = 17,
        ForceX = 18,
        ForceY = 19,
        WallX = 20,
        WallY = 21,
        RestLength = 22,
        Tension = 23,
        Wind = 24,
        Strength = 25,
        Strain = 26,
        RestLengthU = 27,
        RestLengthV = 28,
        TensionU = 29,
        TensionV = 30,
        StrainU = 31,
        StrainV = 32,
        BreakingStrainU = 33,
        BreakingStrainV = 34,
        RestAngle = 35,
    }

    /// <summary>The kinds of objects.</summary>
    public enum Kind
    {
        Chain = 1,
        Membrane = 2,
        Water = 3,
    }

    /// <summary>The two ends of a chain.</summary>
    public enum End
    {
        First = 0,
        Last = 1,
    }

    /// <summary>The four edges of a membrane. A corner belongs to two.</summary>
    public enum Edge
    {
        /// <summary>the nodes with u = 0</summary>
        UFirst = 0,
        /// <summary>u = nu</summary>
        ULast = 1,
        /// <summary>v = 0</summary>
        VFirst = 2,
        /// <summary>v = nv</summary>
        VLast = 3,
    }

    /// <summary>The four sides.</summary>
    public enum Side
    {
        /// <summary>x = 0</summary>
        XFirst = 0,
        /// <summary>x = nx dx</summary>
        XLast = 1,
        /// <summary>y = 0</summary>
        YFirst = 2,
        /// <summary>y = ny dy</summary>
        YLast = 3,
    }

    /// <summary>What is at a side.</summary>
    public enum Border
    {
        Wall = 0,
        /// <summary>water of a given level outside, into which waves run without an echo</summary>
        Open = 1,
        /// <summary>a given discharge comes in; if negative, leaves as far as there is water</summary>
        Inflow = 2,
        /// <summary>goes on at the opposite side</summary>
        Periodic = 3,
        /// <summary>holds a given level for what flows out slower than its waves: a lake, a weir</summary>
        Level = 4,
    }

    /// <summary>Whether water carries its momentum along.</summary>
    public enum Momentum
    {
        Linear = 0,
        Advected = 1,
    }

    /// <summary>What a write to CD_BED leaves as it is.</summary>
    public enum BedRule
    {
        /// <summary>the depth: water rides on the bed, volume is kept</summary>
        LiftsWater = 0,
        /// <summary>the surface of wet cells: the account tells the volume that a write brings or takes</summary>
        KeepsSurface = 1,
    }

    /// <summary>Memory from the caller. allocate returns `size` bytes aligned to `alignment` (a power of two, at
    /// most 64), or null; release gets back what allocate gave, with the same size and alignment. Both are called
    /// only from inside a call on the object, on the caller's thread, never from a step, a read or a write. Copied
    /// at create.</summary>
    public sealed unsafe class AllocatorCallbacks : Callbacks
    {
        public delegate IntPtr AllocateFunction(long size, long alignment);

        public AllocateFunction Allocate;

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate IntPtr AllocateNative(IntPtr user, UIntPtr size, UIntPtr alignment);

        private IntPtr CallAllocate(IntPtr user, UIntPtr size, UIntPtr alignment)
        {
            try
            {
                return Allocate((long)size, (long)alignment);
            }
            catch (Exception raised)
            {
                Raised(raised);
                return default(IntPtr);
            }
        }

        public delegate void ReleaseFunction(IntPtr pointer, long size, long alignment);

        public ReleaseFunction Release;

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void ReleaseNative(IntPtr user, IntPtr pointer, UIntPtr size, UIntPtr alignment);

        private void CallRelease(IntPtr user, IntPtr pointer, UIntPtr size, UIntPtr alignment)
        {
            try
            {
                Release(pointer, (long)size, (long)alignment);
            }
            catch (Exception raised)
            {
                Raised(raised);
            }
        }

        internal override void* Struct()
        {
            return Made(null, (Allocate == null ? null : new AllocateNative(CallAllocate)),
                (Release == null ? null : new ReleaseNative(CallRelease)));
        }
    }

    /// <summary>Parallel work from the caller. run calls task(context, i) once for every i in [0, count), in any
    /// order, on any threads, and returns when all are done. Results do not depend on it, bit for bit, as long as
    /// they are finite. Copied when it is set.</summary>
    public sealed unsafe class ParallelCallbacks : Callbacks
    {
        public delegate void RunFunction(long count, Action<long> task);

        public RunFunction Run;

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void RunNative(IntPtr user, UIntPtr count, IntPtr task, IntPtr context);

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void TaskNative(IntPtr context, UIntPtr index);

        private void CallRun(IntPtr user, UIntPtr count, IntPtr task, IntPtr context)
        {
            try
            {
                var taskFunction = (TaskNative)Marshal.GetDelegateForFunctionPointer(task, typeof(TaskNative));
                Run((long)count, (index) => taskFunction(context, (UIntPtr)(ulong)index));
            }
            catch (Exception raised)
            {
                Raised(raised);
            }
        }

        internal override void* Struct()
        {
            return Made(null, (Run == null ? null : new RunNative(CallRun)));
        }
    }

    /// <summary>A shape from the caller, of a collider of ropes and cloth. distance is given `count` positions,
    /// each of `components` numbers and relative to the collider's origin, and the time [s]. To out_distances[i] it
    /// writes how far outside of the shape each is [m], less than 0 inside, at most 1e60 in size; to
    /// out_normals[i][component] the unit vector along which that distance grows fastest, of a length within 1e-3
    /// of 1. It is called from steps, from any thread of cd_parallel and from several at once. The same position
    /// must get the same answer at the same time, whatever others are asked with it, and it may call no function on
    /// the object. A shape that moves as a whole should do so by the collider's velocity: one that changes with
    /// time by itself is met where it was when the step began. Copied when it is set.</summary>
    public sealed unsafe class DistanceCallbacks : Callbacks
    {
        public delegate void DistanceFunction(double time, long count, long components, IntPtr positions,
            IntPtr outDistances, IntPtr outNormals);

        public DistanceFunction Distance;

        [UnmanagedFunctionPointer(CallingConvention.Cdecl)]
        private delegate void DistanceNative(IntPtr user, double time, UIntPtr count, UIntPtr components,
            IntPtr positions, IntPtr outDistances, IntPtr outNormals);

        private void CallDistance(IntPtr user, double time, UIntPtr count, UIntPtr components, IntPtr positions,
            IntPtr outDistances, IntPtr outNormals)
        {
            try
            {
                Distance(time, (long)count, (long)components, positions, outDistances, outNormals);
            }
            catch (Exception raised)
            {
                Raised(raised);
            }
        }

        internal override void* Struct()
        {
            return Made(null, (Distance == null ? null : new DistanceNative(CallDistance)));
        }
    }

    /// <summary>The library's functions that belong to no object.</summary>
    public static unsafe class Library
    {
        /// <summary>C's SIZE_MAX, for offsets that may be it.</summary>
        public const long SizeMax = -1;

        /// <summary>Name of a status, such as "CD_ERROR_VALUE"; "CD_ERROR_UNKNOWN" for a number that is none. A static
        /// string.</summary>
        public static string StatusName(Status status)
        {
            return Native.Text(Native.cd_status_name((int)status));
        }

        /// <summary>Why the last failed call on this thread failed: the function, the argument, its value, what would
        /// be valid. Empty before the first failure; successful calls leave it as it is. The string belongs to the
        /// library and stays valid until the next failure on the same thread. The library tells nothing else, and has
        /// no hook for messages.</summary>
        public static string ErrorMessage()
        {
            return Native.Text(Native.cd_error_message());
        }

        /// <summary>What cd_*_save made these bytes of: the kind of object, and what its create function has to be
        /// given so that it loads them: of a chain strands and springs, of a membrane nu and nv, of water nx and ny;
        /// components, of water 1; and the precision. Water's dx and dy, allocators and callbacks may be others. Each
        /// output may be null, and is left alone on failure. Errors: CD_ERROR_FORMAT for bytes that are damaged, cut
        /// short or of a later version.</summary>
        public static SavedShape SavedShape<T>(T[] bytes) where T : struct
        {
            using (var bytesPinned = new Pinned<T>(bytes))
                return SavedShapeCore(bytesPinned.Pointer, bytesPinned.Length);
        }

#if CONTDYN_SPANS
        /// <summary>What cd_*_save made these bytes of: the kind of object, and what its create function has to be
        /// given so that it loads them: of a chain strands and springs, of a membrane nu and nv, of water nx and ny;
        /// components, of water 1; and the precision. Water's dx and dy, allocators and callbacks may be others. Each
        /// output may be null, and is left alone on failure. Errors: CD_ERROR_FORMAT for bytes that are damaged, cut
        /// short or of a later version.</summary>
        public static SavedShape SavedShape(ReadOnlySpan<byte> bytes)
        {
            fixed (byte* bytesPointer = &MemoryMarshal.GetReference(bytes))
                return SavedShapeCore(bytes.Length == 0 ? null : bytesPointer, bytes.Length);
        }

#endif
        private static SavedShape SavedShapeCore(void* bytes, long bytesLength)
        {
            long size = bytesLength;
            int outKind;
            UIntPtr outFirst;
            UIntPtr outSecond;
            UIntPtr outComponents;
            int outPrecision;
            Native.Check(Native.cd_saved_shape(bytes, Native.Size(size, "cd_saved_shape", "size"), &outKind, &outFirst,
                &outSecond, &outComponents, &outPrecision));
            return new SavedShape((Kind)outKind, (long)outFirst, (long)outSecond, (long)outComponents,
                (Precision)outPrecision);
        }

        /// <summary>The kernels that this build has and this processor runs: the sum of 1 &lt;&lt; k for each of them,
        /// k a cd_kernels. The largest k is the fastest. CD_KERNELS_PLAIN is always there.</summary>
        public static uint RunnableKernels()
        {
            return Native.cd_runnable_kernels();
        }

        /// <summary>The instructions' name, such as "AVX-512"; of CD_KERNELS_PLAIN those that it was built with:
        /// "SSE2", "NEON", "SIMD128", or "plain" for one number at a time. "unknown" for a number that is no
        /// cd_kernels. A static string.</summary>
        public static string KernelsName(Kernels kernels)
        {
            return Native.Text(Native.cd_kernels_name((int)kernels));
        }

        /// <summary>Version of the library that runs: major * 1000000 + minor * 1000 + patch. The macros tell that of
        /// the header.</summary>
        public static uint Version()
        {
            return Native.cd_version();
        }

        /// <summary>The same as text, "0.2.0". A static string.</summary>
        public static string VersionString()
        {
            return Native.Text(Native.cd_version_string());
        }

        /// <summary>Compiler, target, and which objects, features, precisions and kernels this build has, in one line:
        /// options of the build leave parts out, and what asks for one that is not there says CD_ERROR_UNSUPPORTED. A
        /// static string.</summary>
        public static string BuildInfo()
        {
            return Native.Text(Native.cd_build_info());
        }
    }

    /// <summary>What Library.SavedShape tells.</summary>
    public struct SavedShape
    {
        public readonly Kind Kind;
        public readonly long First;
        public readonly long Second;
        public readonly long Components;
        public readonly Precision Precision;

        internal SavedShape(Kind kind, long first, long second, long components, Precision precision)
        {
            Kind = kind;
            First = first;
            Second = second;
            Components = components;
            Precision = precision;
        }
    }

    /// <summary>What Chain.GetShape tells.</summary>
    public struct ChainShape
    {
        public readonly long Strands;
        public readonly long Springs;
        public readonly long Components;
        public readonly Precision Precision;

        internal ChainShape(long strands, long springs, long components, Precision precision)
        {
            Strands = strands;
            Springs = springs;
            Components = components;
            Precision = precision;
        }
    }

    /// <summary>What Chain.GetSleep tells.</summary>
    public struct ChainSleep
    {
        public readonly double Speed;
        public readonly double Seconds;

        internal ChainSleep(double speed, double seconds)
        {
            Speed = speed;
            Seconds = seconds;
        }
    }

    /// <summary>What Chain.GetAir tells.</summary>
    public struct ChainAir
    {
        public readonly double Along;
        public readonly double Across;

        internal ChainAir(double along, double across)
        {
            Along = along;
            Across = across;
        }
    }

    /// <summary>What Chain.GetTolerance tells.</summary>
    public struct ChainTolerance
    {
        public readonly double Tolerance;
        public readonly long MostIterations;

        internal ChainTolerance(double tolerance, long mostIterations)
        {
            Tolerance = tolerance;
            MostIterations = mostIterations;
        }
    }

    /// <summary>What Chain.GetConvergence tells.</summary>
    public struct ChainConvergence
    {
        public readonly long Iterations;
        public readonly double Residual;

        internal ChainConvergence(long iterations, double residual)
        {
            Iterations = iterations;
            Residual = residual;
        }
    }

    /// <summary>What Chain.GetBed tells.</summary>
    public struct ChainBed
    {
        public readonly long Columns;
        public readonly long Rows;

        internal ChainBed(long columns, long rows)
        {
            Columns = columns;
            Rows = rows;
        }
    }

    /// <summary>What Chain.GetCollider tells.</summary>
    public struct ChainCollider
    {
        public readonly Shape Shape;
        public readonly double Radius;
        public readonly double Friction;

        internal ChainCollider(Shape shape, double radius, double friction)
        {
            Shape = shape;
            Radius = radius;
            Friction = friction;
        }
    }

    /// <summary>What Chain.GetAttachment tells.</summary>
    public struct ChainAttachment
    {
        public readonly double Stiffness;
        public readonly double Damping;

        internal ChainAttachment(double stiffness, double damping)
        {
            Stiffness = stiffness;
            Damping = damping;
        }
    }

    /// <summary>What Chain.GetEnergy tells.</summary>
    public struct ChainEnergy
    {
        public readonly double Kinetic;
        public readonly double Elastic;
        public readonly double Gravity;

        internal ChainEnergy(double kinetic, double elastic, double gravity)
        {
            Kinetic = kinetic;
            Elastic = elastic;
            Gravity = gravity;
        }
    }

    /// <summary>contdyn: a chain of nodes joined by springs: massive spring, rope, hair, spline.
    /// A chain has `springs` springs and nodes = springs + 1 nodes; spring i joins node i to node i + 1. A ring has
    /// one spring more, number `springs`, from the last node to the first. A node has 1 to 4 components that never
    /// mix. One handle holds one or many strands, each with its own positions, velocities, forces and targets.
    /// Strands share masses, stiffnesses, pins and attachments, and so one factorization; only ropes' strands have
    /// their own of these too.
    /// Energy E = 1/2 sum k_i |x_{i+1} - x_i|^2 + 1/2 sum b_i |x_{i+1} - 2 x_i + x_{i-1}|^2 (Kass 1997, eq. 2 and
    /// 5) Motion M x'' + C x' + K x = M g + f, K = the Hessian of E, C = drag M + stiffness_damping K
    /// Rest length is zero, unless cd_chain_set_rest_length makes the chain a rope: a free chain draws together,
    /// and one stretched evenly is held by its ends. A new chain lies with every node at the origin, at rest, all
    /// nodes free, mass 1, stiffness 1, no bend, no gravity, no damping, CD_METHOD_IMPLICIT with lambda 1/2.
    /// All computing is done in double precision; CD_FLOAT32 is what positions, velocities, forces and targets are
    /// stored in. (Steps of symplectic Euler on uniform chains without damping and forces compute in float32 and
    /// are as exact.) Numbers smaller than 2^-80 (float32) or 2^-500 (float64), in those steps velocities, are
    /// taken for 0 where a step stores them, so that a scene at rest is never slow. Parameters may be as large as
    /// 1e60, masses as small as 1e-60.
    /// Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind;
    /// the comments name the other errors.</summary>
    public sealed unsafe class Chain : LibraryObject
    {
        internal new ChainHandle Handle { get { return (ChainHandle)base.Handle; } }

        /// <summary>Makes a chain. strands &gt;= 1; springs &gt;= 0 (0: a single node); components 1 to 4. allocator
        /// may be null (malloc). The caller owns *out_chain and releases it with cd_chain_destroy; on failure
        /// *out_chain is left alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY;
        /// CD_ERROR_UNSUPPORTED for a precision that this build leaves out.</summary>
        public Chain(long strands, long springs, long components, Precision precision = Precision.Float64,
            AllocatorCallbacks allocator = null)
        {
            void* allocatorStruct = allocator == null ? null : allocator.Struct();
            IntPtr made;
            Native.CheckVersion();
            int status;
            try
            {
                status = Native.cd_chain_create(Native.Size(strands, "cd_chain_create", "strands"),
                    Native.Size(springs, "cd_chain_create", "springs"), Native.Size(components, "cd_chain_create",
                    "components"), (int)precision, allocatorStruct, &made);
            }
            catch (EntryPointNotFoundException)
            {
                throw Native.LeftOut("cd_chain_create");
            }
            Native.Check(status, allocator);
            Own(new ChainHandle(made));
            Handle.Keep("allocator", allocator);
        }

        private static readonly Dictionary<Field, FieldRow> rows = new Dictionary<Field, FieldRow>
        {
            { Field.Position, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, true, false) },
            { Field.Velocity, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, true, false) },
            { Field.Force, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, true, false) },
            { Field.Target, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, true, false) },
            { Field.Mass, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, false, true) },
            { Field.Stiffness, new FieldRow(new[] { 1, 0, 0, 2, 0, 1 }, false, true) },
            { Field.Bend, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, false, true) },
            { Field.Pin, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, false, true) },
            { Field.RestLength, new FieldRow(new[] { 1, 0, 0, 2, 0, 1 }, false, false) },
            { Field.Tension, new FieldRow(new[] { 1, 0, 0, 2, 0, 1 }, false, false) },
            { Field.Wind, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, true, false) },
            { Field.Strength, new FieldRow(new[] { 1, 0, 0, 2, 0, 1 }, false, false) },
            { Field.RestAngle, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, false, false) },
            { Field.Strain, new FieldRow(new[] { 1, 0, 0, 2, 0, 1 }, false, false) },
        };

        internal override Whole Extents(Field field)
        {
            FieldRow row;
            if (!rows.TryGetValue(field, out row)) return new Whole();
            var shape = GetShape();
            return new Whole(row, new[] { shape.Strands, shape.Springs }, new[] { Ring },
                row.OneButInRopes && RestLength > 0, shape.Components);
        }

        internal override Precision Stored { get { return GetShape().Precision; } }

        internal override void ReadWhole(Field field, Whole whole, float* outValues, long count)
        {
            var range = whole.Range(true);
            ReadF32Core(field, range[0], range[1], range[2], range[3], outValues, count);
        }

        internal override void ReadWhole(Field field, Whole whole, double* outValues, long count)
        {
            var range = whole.Range(true);
            ReadF64Core(field, range[0], range[1], range[2], range[3], outValues, count);
        }

        internal override void WriteWhole(Field field, Whole whole, float* values, long count)
        {
            var range = whole.Range(true);
            WriteF32Core(field, range[0], range[1], range[2], range[3], values, count);
        }

        internal override void WriteWhole(Field field, Whole whole, double* values, long count)
        {
            var range = whole.Range(true);
            WriteF64Core(field, range[0], range[1], range[2], range[3], values, count);
        }

        /// <summary>What cd_chain_create was given. Each output may be null.</summary>
        public ChainShape GetShape()
        {
            UIntPtr outStrands;
            UIntPtr outSprings;
            UIntPtr outComponents;
            int outPrecision;
            Check(Native.cd_chain_get_shape(Handle, &outStrands, &outSprings, &outComponents, &outPrecision));
            return new ChainShape((long)outStrands, (long)outSprings, (long)outComponents, (Precision)outPrecision);
        }

        /// <summary>How steps are made. Methods differ in the memory they need: implicit ones a factorization and a row
        /// of scratch, CD_METHOD_STIFF_SECOND a second row. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.</summary>
        public Method Method
        {
            get
            {
                int outMethod;
                Check(Native.cd_chain_get_method(Handle, &outMethod));
                return (Method)outMethod;
            }
            set
            {
                var method = value;
                Changed();
                Check(Native.cd_chain_set_method(Handle, (int)method));
            }
        }

        /// <summary>lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE.</summary>
        public double Lambda
        {
            get
            {
                double outLambda;
                Check(Native.cd_chain_get_lambda(Handle, &outLambda));
                return outLambda;
            }
            set
            {
                var lambda = value;
                Changed();
                Check(Native.cd_chain_set_lambda(Handle, lambda));
            }
        }

        /// <summary>Spreads the strands of a step over the caller's threads. Null: none. Errors: CD_ERROR_NULL for a
        /// table without run.</summary>
        public void SetParallel(ParallelCallbacks parallel)
        {
            void* parallelStruct = parallel == null ? null : parallel.Struct();
            Changed();
            Check(Native.cd_chain_set_parallel(Handle, parallelStruct));
            Handle.Keep("parallel", parallel);
        }

        /// <summary>The instructions that steps are made of, from here on: for tests and measurements, as all give the
        /// same bits and a new chain has the fastest that its processor runs. Not part of the saved state. Errors:
        /// CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.</summary>
        public Kernels Kernels
        {
            get
            {
                int outKernels;
                Check(Native.cd_chain_get_kernels(Handle, &outKernels));
                return (Kernels)outKernels;
            }
            set
            {
                var kernels = value;
                Changed();
                Check(Native.cd_chain_set_kernels(Handle, (int)kernels));
            }
        }

        /// <summary>Mass [kg], &gt; 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half
        /// of it at the two ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.</summary>
        public double Mass
        {
            get
            {
                double outMass;
                Check(Native.cd_chain_get_mass(Handle, &outMass));
                return outMass;
            }
            set
            {
                var mass = value;
                Changed();
                Check(Native.cd_chain_set_mass(Handle, mass));
            }
        }

        /// <summary>Mass [kg], &gt; 0. Per node, CD_MASS_EQUAL: mass / nodes; CD_MASS_HALF_ENDS: mass / springs, half
        /// of it at the two ends (in a ring, and with no spring, the rules agree). Kass 1997, eq. 6.</summary>
        public MassRule MassRule
        {
            get
            {
                int outRule;
                Check(Native.cd_chain_get_mass_rule(Handle, &outRule));
                return (MassRule)outRule;
            }
            set
            {
                var rule = value;
                Changed();
                Check(Native.cd_chain_set_mass_rule(Handle, (int)rule));
            }
        }

        /// <summary>Stretch stiffness k [N/m], &gt;= 0, of ropes up to INFINITY. Per spring: k times the number of
        /// springs. Kass 1997, eq. 7. Waves run along the chain in sqrt(mass / k) seconds.</summary>
        public double Stiffness
        {
            get
            {
                double outStiffness;
                Check(Native.cd_chain_get_stiffness(Handle, &outStiffness));
                return outStiffness;
            }
            set
            {
                var stiffness = value;
                Changed();
                Check(Native.cd_chain_set_stiffness(Handle, stiffness));
            }
        }

        /// <summary>Bend stiffness b [N/m], &gt;= 0. Per node with two neighbours: b times the cube of the number of
        /// springs (Kass 1997, eq. 5; eq. 8 prints the square). With b = E I / L^3, L the length of all its springs,
        /// held ones too, a rope bends as a beam of the rigidity E I [N m^2]. Errors: CD_ERROR_MEMORY when bend is
        /// switched on.</summary>
        public double Bend
        {
            get
            {
                double outBend;
                Check(Native.cd_chain_get_bend(Handle, &outBend));
                return outBend;
            }
            set
            {
                var bend = value;
                Changed();
                Check(Native.cd_chain_set_bend(Handle, bend));
            }
        }

        /// <summary>Drag [1/s], &gt;= 0: every node loses velocity at this rate.</summary>
        public double Drag
        {
            get
            {
                double outDrag;
                Check(Native.cd_chain_get_drag(Handle, &outDrag));
                return outDrag;
            }
            set
            {
                var drag = value;
                Changed();
                Check(Native.cd_chain_set_drag(Handle, drag));
            }
        }

        /// <summary>Stiffness damping [s], &gt;= 0: stretch and bend damp at this time constant; a mode of angular
        /// frequency w loses amplitude at the rate (drag + stiffness_damping w^2) / 2. Ropes take none.</summary>
        public double StiffnessDamping
        {
            get
            {
                double outSeconds;
                Check(Native.cd_chain_get_stiffness_damping(Handle, &outSeconds));
                return outSeconds;
            }
            set
            {
                var seconds = value;
                Changed();
                Check(Native.cd_chain_set_stiffness_damping(Handle, seconds));
            }
        }

        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void SetGravity(params double[] gravity)
        {
            fixed (double* gravityPointer = gravity)
                SetGravityCore(gravityPointer, Native.Length(gravity));
        }

#if CONTDYN_SPANS
        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void SetGravity(ReadOnlySpan<double> gravity)
        {
            fixed (double* gravityPointer = &MemoryMarshal.GetReference(gravity))
                SetGravityCore(gravity.Length == 0 ? null : gravityPointer, gravity.Length);
        }

#endif
        private void SetGravityCore(double* gravity, long gravityLength)
        {
            long count = Native.Count(gravityLength, 1, "cd_chain_set_gravity", "gravity");
            Changed();
            Check(Native.cd_chain_set_gravity(Handle, gravity, Native.Size(count, "cd_chain_set_gravity", "count")));
        }

        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void GetGravity(double[] outGravity)
        {
            fixed (double* outGravityPointer = outGravity)
                GetGravityCore(outGravityPointer, Native.Length(outGravity));
        }

#if CONTDYN_SPANS
        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void GetGravity(Span<double> outGravity)
        {
            fixed (double* outGravityPointer = &MemoryMarshal.GetReference(outGravity))
                GetGravityCore(outGravity.Length == 0 ? null : outGravityPointer, outGravity.Length);
        }

#endif
        private void GetGravityCore(double* outGravity, long outGravityLength)
        {
            long count = Native.Count(outGravityLength, 1, "cd_chain_get_gravity", "out_gravity");
            Check(Native.cd_chain_get_gravity(Handle, outGravity, Native.Size(count, "cd_chain_get_gravity", "count")));
        }

        /// <summary>What holds an end: the same as writing the field CD_PIN at the first or last node of every strand;
        /// the getter tells that of the first strand. Pinning stops the node; driving leaves its velocity, which is
        /// then written through CD_VELOCITY; posing switches CD_TARGET on and sets the end's target to where it is:
        /// write the next one there. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED
        /// on a ring; CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.</summary>
        public void SetEnd(End end, Node kind)
        {
            Changed();
            Check(Native.cd_chain_set_end(Handle, (int)end, (int)kind));
        }

        /// <summary>What holds an end: the same as writing the field CD_PIN at the first or last node of every strand;
        /// the getter tells that of the first strand. Pinning stops the node; driving leaves its velocity, which is
        /// then written through CD_VELOCITY; posing switches CD_TARGET on and sets the end's target to where it is:
        /// write the next one there. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for CD_NODE_MATCHED
        /// on a ring; CD_ERROR_DIVERGED for CD_NODE_POSED where the state is not finite.</summary>
        public Node GetEnd(End end)
        {
            int outKind;
            Check(Native.cd_chain_get_end(Handle, (int)end, &outKind));
            return (Node)outKind;
        }

        /// <summary>Joins the last node to the first (1) or opens the ring (0). A ring has as many springs as nodes,
        /// and with bend a bend term at every node; totals are dealt out anew, and a per-spring stiffness field gets
        /// the uniform value. Needs 3 nodes. A ring with bend whose springs are cut, or some far softer than others,
        /// gains energy by rounding in steps longer than some 1e6 times its fastest swing. Errors: CD_ERROR_VALUE for
        /// anything but 0 and 1; CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched end;
        /// CD_ERROR_MEMORY.</summary>
        public bool Ring
        {
            get
            {
                int outRing;
                Check(Native.cd_chain_get_ring(Handle, &outRing));
                return outRing != 0;
            }
            set
            {
                var ring = value;
                Changed();
                Check(Native.cd_chain_set_ring(Handle, ring ? 1 : 0));
            }
        }

        /// <summary>Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do
        /// so one by one, others together. One stops, and sleeps, once for some `seconds` [s], in [1e-30, 1e60], no
        /// step left a free node of it faster than `speed` [m/s], in [0, 1e60], nor a held one moving. Energy is lost
        /// and none gained. Neglected is a mean acceleration of up to 2 speed / seconds: let that be little beside
        /// gravity, or what is thrown may stay in the air. speed 0, the default: nothing sleeps, and seconds means
        /// nothing and is 0. A plane or capsule that moves wakes what it could touch in the next step; a bed that
        /// moves, or a callback, keeps all awake. What changes a strand wakes it, with whatever numbers: a write, an
        /// impulse, a teleport, an attachment, a cut; what is set wakes all, but for the hook, the kernels and the
        /// tolerance. Who sleeps is part of the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.</summary>
        public void SetSleep(double speed, double seconds)
        {
            Changed();
            Check(Native.cd_chain_set_sleep(Handle, speed, seconds));
        }

        /// <summary>Lets what has come to rest sleep: steps leave it as it is, at hardly any cost. Strands of a rope do
        /// so one by one, others together. One stops, and sleeps, once for some `seconds` [s], in [1e-30, 1e60], no
        /// step left a free node of it faster than `speed` [m/s], in [0, 1e60], nor a held one moving. Energy is lost
        /// and none gained. Neglected is a mean acceleration of up to 2 speed / seconds: let that be little beside
        /// gravity, or what is thrown may stay in the air. speed 0, the default: nothing sleeps, and seconds means
        /// nothing and is 0. A plane or capsule that moves wakes what it could touch in the next step; a bed that
        /// moves, or a callback, keeps all awake. What changes a strand wakes it, with whatever numbers: a write, an
        /// impulse, a teleport, an attachment, a cut; what is set wakes all, but for the hook, the kernels and the
        /// tolerance. Who sleeps is part of the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.</summary>
        public ChainSleep GetSleep()
        {
            double outSpeed;
            double outSeconds;
            Check(Native.cd_chain_get_sleep(Handle, &outSpeed, &outSeconds));
            return new ChainSleep(outSpeed, outSeconds);
        }

        /// <summary>How many nodes are awake: those that the next step moves.</summary>
        public long GetAwake()
        {
            UIntPtr outNodes;
            Check(Native.cd_chain_get_awake(Handle, &outNodes));
            return (long)outNodes;
        }

        /// <summary>Rest length of a strand [m], 0 or in [1e-60, 1e60]; default 0: no rope. Per spring: length /
        /// springs; nodes stay where they are. A rope has the fields CD_TENSION, at first 0, and CD_STRAIN. Its strands
        /// are individuals: each has its own pins, masses, stiffnesses, bends, rest lengths and attachments, at first
        /// those that they shared. Length 0 switches CD_TENSION off, and CD_REST_LENGTH, rest angles, strength, air,
        /// wind and colliders too. Reeled in or paid out a little every step, it is a winch. Errors: CD_ERROR_VALUE;
        /// CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 4 components or no spring, and for 0 where strands differ in what
        /// they would share, or an infinite stiffness would weld all springs or two held nodes.</summary>
        public double RestLength
        {
            get
            {
                double outLength;
                Check(Native.cd_chain_get_rest_length(Handle, &outLength));
                return outLength;
            }
            set
            {
                var length = value;
                Changed();
                Check(Native.cd_chain_set_rest_length(Handle, length));
            }
        }

        /// <summary>Rest angle of a strand [rad], by which its last spring is turned from its first at rest, from the
        /// first axis to the second; default 0: straight. Per node with two neighbours: angle / (springs - 1), at most
        /// pi in size. It is what bend bends about, so it does nothing without bend, and turns with the rope: curls,
        /// hooks, tentacles, blades of grass. The field CD_REST_ANGLE has one for each node. Where springs push, a rod
        /// takes its shape by turning, else also by going slack. Errors: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a
        /// chain that is no rope, or, but for 0, without 2 components: in space a curl needs to know how its links are
        /// twisted, which nodes do not tell.</summary>
        public double RestAngle
        {
            get
            {
                double outAngle;
                Check(Native.cd_chain_get_rest_angle(Handle, &outAngle));
                return outAngle;
            }
            set
            {
                var angle = value;
                Changed();
                Check(Native.cd_chain_set_rest_angle(Handle, angle));
            }
        }

        /// <summary>Whether springs with a length push when shorter (1) or are slack (0, the default). Links that push
        /// are solved by Newton's method alone, which may fail from a crumpled start, or where hardly any bend holds
        /// them at long steps: of the first 15 steps of 20 or 50 links laid at random one in 700, which moves too
        /// little. Errors: CD_ERROR_VALUE.</summary>
        public bool Push
        {
            get
            {
                int outPush;
                Check(Native.cd_chain_get_push(Handle, &outPush));
                return outPush != 0;
            }
            set
            {
                var push = value;
                Changed();
                Check(Native.cd_chain_set_push(Handle, push ? 1 : 0));
            }
        }

        /// <summary>The tension at which a spring breaks [N], 1e-60 to 1e60, or INFINITY, the default: springs hold. A
        /// rope's step ends by cutting, of each strand, the spring whose tension is most beyond its strength: its
        /// stiffness and tension become 0, and the next step shows what the others bear. Where a step ends short of its
        /// tolerance and leaves springs of fixed length longer than that allows, as between held nodes that are driven
        /// apart, no tension is large enough: then, of the springs between the held nodes on both sides of the longest
        /// one, the weakest breaks. Mend a spring by writing CD_STIFFNESS, which a finite strength switches on and
        /// keeps on. The field CD_STRENGTH has one for each spring. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY;
        /// CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public double Strength
        {
            get
            {
                double outStrength;
                Check(Native.cd_chain_get_strength(Handle, &outStrength));
                return outStrength;
            }
            set
            {
                var strength = value;
                Changed();
                Check(Native.cd_chain_set_strength(Handle, strength));
            }
        }

        /// <summary>How many springs broke in the last call of cd_chain_step that made steps: those whose CD_STIFFNESS
        /// became 0.</summary>
        public long GetBroken()
        {
            UIntPtr outSprings;
            Check(Native.cd_chain_get_broken(Handle, &outSprings));
            return (long)outSprings;
        }

        /// <summary>The force [N], one number per component, with which the springs of a rope pull at a node, and its
        /// bend: of a held node, what the rope does to whatever holds it. It is the sum of the springs' tensions, along
        /// their directions now (0 of a spring without length), and of the forces of the bend at the node and at the
        /// nodes beside it. After a step that ended short of its tolerance tensions are a guess, 0 or at most the sum
        /// of the forces of springs on each node in that step: a rope of fixed length has no tension that holds a
        /// driven end which would stretch it. To tie a rope to a body of your own, give the last node its mass, in
        /// CD_MASS; or drive an end of a rope of finite stiffness. Where tensions are read, or a strength is set, take
        /// lambda = 1. With 1/2 &lt; lambda &lt; 1 they miss up to a third of the pull of hardly yielding springs where
        /// nodes swing; with 1/2 those can be twice the mean just after a jolt. With lambda &lt; 1 a load paid out by
        /// springs of infinite stiffness is let fall and caught by turns where dt^2 times gravity is less than 5
        /// tolerance * length: of 10 kg on 4 m of rope at dt = 1/960 s they are 6 N and 190 N; a smaller tolerance
        /// helps. Errors: CD_ERROR_RANGE; CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public void GetReaction(long strand, long node, double[] outForce)
        {
            fixed (double* outForcePointer = outForce)
                GetReactionCore(strand, node, outForcePointer, Native.Length(outForce));
        }

#if CONTDYN_SPANS
        /// <summary>The force [N], one number per component, with which the springs of a rope pull at a node, and its
        /// bend: of a held node, what the rope does to whatever holds it. It is the sum of the springs' tensions, along
        /// their directions now (0 of a spring without length), and of the forces of the bend at the node and at the
        /// nodes beside it. After a step that ended short of its tolerance tensions are a guess, 0 or at most the sum
        /// of the forces of springs on each node in that step: a rope of fixed length has no tension that holds a
        /// driven end which would stretch it. To tie a rope to a body of your own, give the last node its mass, in
        /// CD_MASS; or drive an end of a rope of finite stiffness. Where tensions are read, or a strength is set, take
        /// lambda = 1. With 1/2 &lt; lambda &lt; 1 they miss up to a third of the pull of hardly yielding springs where
        /// nodes swing; with 1/2 those can be twice the mean just after a jolt. With lambda &lt; 1 a load paid out by
        /// springs of infinite stiffness is let fall and caught by turns where dt^2 times gravity is less than 5
        /// tolerance * length: of 10 kg on 4 m of rope at dt = 1/960 s they are 6 N and 190 N; a smaller tolerance
        /// helps. Errors: CD_ERROR_RANGE; CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public void GetReaction(long strand, long node, Span<double> outForce)
        {
            fixed (double* outForcePointer = &MemoryMarshal.GetReference(outForce))
                GetReactionCore(strand, node, outForce.Length == 0 ? null : outForcePointer, outForce.Length);
        }

#endif
        private void GetReactionCore(long strand, long node, double* outForce, long outForceLength)
        {
            long count = Native.Count(outForceLength, 1, "cd_chain_get_reaction", "out_force");
            Check(Native.cd_chain_get_reaction(Handle, Native.Size(strand, "cd_chain_get_reaction", "strand"),
                Native.Size(node, "cd_chain_get_reaction", "node"), outForce, Native.Size(count,
                "cd_chain_get_reaction", "count")));
        }

        /// <summary>Resistance of the air, per length of a rope [N s/m^2], in [0, 1e60], default 0: a piece of length s
        /// whose velocity through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t +
        /// across w_n). Implicit, so that it only takes energy, as seen from the air, at any dt; the rope's direction
        /// is the one that it would have lambda dt after the step began. A node bears half of its two springs' rest
        /// lengths, at most 1e10 m / dt [N s/m] where its mass is m; cut springs feel no air. A round rope of diameter
        /// d has some across = 0.6 density d |w_n|, and along a hundredth of that. Errors: CD_ERROR_VALUE;
        /// CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public void SetAir(double along, double across)
        {
            Changed();
            Check(Native.cd_chain_set_air(Handle, along, across));
        }

        /// <summary>Resistance of the air, per length of a rope [N s/m^2], in [0, 1e60], default 0: a piece of length s
        /// whose velocity through the air is w, w_t along the rope and w_n across it, is pushed by -s (along w_t +
        /// across w_n). Implicit, so that it only takes energy, as seen from the air, at any dt; the rope's direction
        /// is the one that it would have lambda dt after the step began. A node bears half of its two springs' rest
        /// lengths, at most 1e10 m / dt [N s/m] where its mass is m; cut springs feel no air. A round rope of diameter
        /// d has some across = 0.6 density d |w_n|, and along a hundredth of that. Errors: CD_ERROR_VALUE;
        /// CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public ChainAir GetAir()
        {
            double outAlong;
            double outAcross;
            Check(Native.cd_chain_get_air(Handle, &outAlong, &outAcross));
            return new ChainAir(outAlong, outAcross);
        }

        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set:
        /// CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public void SetWind(params double[] velocity)
        {
            fixed (double* velocityPointer = velocity)
                SetWindCore(velocityPointer, Native.Length(velocity));
        }

#if CONTDYN_SPANS
        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set:
        /// CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public void SetWind(ReadOnlySpan<double> velocity)
        {
            fixed (double* velocityPointer = &MemoryMarshal.GetReference(velocity))
                SetWindCore(velocity.Length == 0 ? null : velocityPointer, velocity.Length);
        }

#endif
        private void SetWindCore(double* velocity, long velocityLength)
        {
            long count = Native.Count(velocityLength, 1, "cd_chain_set_wind", "velocity");
            Changed();
            Check(Native.cd_chain_set_wind(Handle, velocity, Native.Size(count, "cd_chain_set_wind", "count")));
        }

        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set:
        /// CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public void GetWind(double[] outVelocity)
        {
            fixed (double* outVelocityPointer = outVelocity)
                GetWindCore(outVelocityPointer, Native.Length(outVelocity));
        }

#if CONTDYN_SPANS
        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_VALUE; CD_ERROR_RANGE if count is not the number of components; set:
        /// CD_ERROR_UNSUPPORTED of a chain that is no rope.</summary>
        public void GetWind(Span<double> outVelocity)
        {
            fixed (double* outVelocityPointer = &MemoryMarshal.GetReference(outVelocity))
                GetWindCore(outVelocity.Length == 0 ? null : outVelocityPointer, outVelocity.Length);
        }

#endif
        private void GetWindCore(double* outVelocity, long outVelocityLength)
        {
            long count = Native.Count(outVelocityLength, 1, "cd_chain_get_wind", "out_velocity");
            Check(Native.cd_chain_get_wind(Handle, outVelocity, Native.Size(count, "cd_chain_get_wind", "count")));
        }

        /// <summary>When a step of a rope ends: when every spring is as long as its tension makes it, but for
        /// `tolerance` times its rest length, and springs gave no more energy than such errors are worth. A slack
        /// spring that is shorter by the fraction s may keep a tension of tolerance / s times the mean force on the
        /// nodes, or the mean tension. In [1e-14, 1/2], default 1e-6; above 1e-4 it costs more time, not less, since
        /// the next step must correct what one leaves. most_iterations, 1 to 10000, default 200, limits the slow and
        /// sure method, an interior point, which follows on at most 16 iterations of Newton's; where springs push, it
        /// limits Newton's. Errors: CD_ERROR_VALUE.</summary>
        public void SetTolerance(double tolerance, long mostIterations)
        {
            Changed();
            Check(Native.cd_chain_set_tolerance(Handle, tolerance, Native.Size(mostIterations,
                "cd_chain_set_tolerance", "most_iterations")));
        }

        /// <summary>When a step of a rope ends: when every spring is as long as its tension makes it, but for
        /// `tolerance` times its rest length, and springs gave no more energy than such errors are worth. A slack
        /// spring that is shorter by the fraction s may keep a tension of tolerance / s times the mean force on the
        /// nodes, or the mean tension. In [1e-14, 1/2], default 1e-6; above 1e-4 it costs more time, not less, since
        /// the next step must correct what one leaves. most_iterations, 1 to 10000, default 200, limits the slow and
        /// sure method, an interior point, which follows on at most 16 iterations of Newton's; where springs push, it
        /// limits Newton's. Errors: CD_ERROR_VALUE.</summary>
        public ChainTolerance GetTolerance()
        {
            double outTolerance;
            UIntPtr outMostIterations;
            Check(Native.cd_chain_get_tolerance(Handle, &outTolerance, &outMostIterations));
            return new ChainTolerance(outTolerance, (long)outMostIterations);
        }

        /// <summary>What the last call of cd_chain_step did with ropes: the most iterations that a step of a strand
        /// took, and the largest error it ended with, as the tolerance counts it, or INFINITY. 0 and 0 without ropes.
        /// Each output may be null.</summary>
        public ChainConvergence GetConvergence()
        {
            UIntPtr outIterations;
            double outResidual;
            Check(Native.cd_chain_get_convergence(Handle, &outIterations, &outResidual));
            return new ChainConvergence((long)outIterations, outResidual);
        }

        /// <summary>How many colliders there are, 0 to 4096, default 0: new ones are CD_SHAPE_NONE, those that stay
        /// keep what they are. Rest length 0 takes them away. Errors: CD_ERROR_MEMORY.</summary>
        public long Colliders
        {
            get
            {
                UIntPtr outCount;
                Check(Native.cd_chain_get_colliders(Handle, &outCount));
                return (long)outCount;
            }
            set
            {
                var count = value;
                Changed();
                Check(Native.cd_chain_set_colliders(Handle, Native.Size(count, "cd_chain_set_colliders", "count")));
            }
        }

        /// <summary>Makes a collider the half space behind the plane through `point` [m] that `normal`, of any length
        /// but 0, points out of; one number per component each, at most 1e60 in size. friction, 0 to 1e60, is Coulomb's
        /// coefficient.</summary>
        public void SetPlane(long index, double[] point, double[] normal, double friction)
        {
            fixed (double* pointPointer = point)
            fixed (double* normalPointer = normal)
                SetPlaneCore(index, pointPointer, Native.Length(point), normalPointer, Native.Length(normal), friction);
        }

#if CONTDYN_SPANS
        /// <summary>Makes a collider the half space behind the plane through `point` [m] that `normal`, of any length
        /// but 0, points out of; one number per component each, at most 1e60 in size. friction, 0 to 1e60, is Coulomb's
        /// coefficient.</summary>
        public void SetPlane(long index, ReadOnlySpan<double> point, ReadOnlySpan<double> normal, double friction)
        {
            fixed (double* pointPointer = &MemoryMarshal.GetReference(point))
            fixed (double* normalPointer = &MemoryMarshal.GetReference(normal))
                SetPlaneCore(index, point.Length == 0 ? null : pointPointer, point.Length,
                    normal.Length == 0 ? null : normalPointer, normal.Length, friction);
        }

#endif
        private void SetPlaneCore(long index, double* point, long pointLength, double* normal, long normalLength,
            double friction)
        {
            long count = Native.Count(pointLength, 1, "cd_chain_set_plane", "point");
            Native.Same(normal, normalLength, count, "cd_chain_set_plane", "normal");
            Changed();
            Check(Native.cd_chain_set_plane(Handle, Native.Size(index, "cd_chain_set_plane", "index"), point, normal,
                Native.Size(count, "cd_chain_set_plane", "count"), friction));
        }

        /// <summary>Makes a collider all that is less than `radius` [m], 1e-60 to 1e60, away from the line between two
        /// ends: a sphere where they are the same.</summary>
        public void SetCapsule(long index, double[] first, double[] last, double radius, double friction)
        {
            fixed (double* firstPointer = first)
            fixed (double* lastPointer = last)
                SetCapsuleCore(index, firstPointer, Native.Length(first), lastPointer, Native.Length(last), radius,
                    friction);
        }

#if CONTDYN_SPANS
        /// <summary>Makes a collider all that is less than `radius` [m], 1e-60 to 1e60, away from the line between two
        /// ends: a sphere where they are the same.</summary>
        public void SetCapsule(long index, ReadOnlySpan<double> first, ReadOnlySpan<double> last, double radius,
            double friction)
        {
            fixed (double* firstPointer = &MemoryMarshal.GetReference(first))
            fixed (double* lastPointer = &MemoryMarshal.GetReference(last))
                SetCapsuleCore(index, first.Length == 0 ? null : firstPointer, first.Length,
                    last.Length == 0 ? null : lastPointer, last.Length, radius, friction);
        }

#endif
        private void SetCapsuleCore(long index, double* first, long firstLength, double* last, long lastLength,
            double radius, double friction)
        {
            long count = Native.Count(firstLength, 1, "cd_chain_set_capsule", "first");
            Native.Same(last, lastLength, count, "cd_chain_set_capsule", "last");
            Changed();
            Check(Native.cd_chain_set_capsule(Handle, Native.Size(index, "cd_chain_set_capsule", "index"), first, last,
                Native.Size(count, "cd_chain_set_capsule", "count"), radius, friction));
        }

        /// <summary>Makes a collider all that lies below a bed of heights [m], at most 1e60 in size, which are copied.
        /// The last component is up. With 3 components heights[j * columns + i] is at the first two components origin +
        /// (i column_spacing, j row_spacing), of at least 2 columns and rows; with 2 components a single row is along
        /// the first one, and row_spacing means nothing. Heights count from the origin's own; spacings [m] are 1e-60 to
        /// 1e60. Between heights the bed is bilinear, with creases rounded within a quarter of the spacing either side;
        /// beyond the border it goes on at the border's height. How far outside a node is, is its height above the bed
        /// times the upward part of the bed's normal. A step meets the bed at the plane that touches it there where it
        /// finds the node. What the bed rises above that plane on the node's way the node may end inside of, and the
        /// next step takes it out; however fast, none falls through. Errors: CD_ERROR_RANGE too, if height_count is not
        /// columns * rows; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 1 component.</summary>
        public void SetBed(long index, double[] origin, long columns, long rows, double columnSpacing,
            double rowSpacing, double[] heights, double friction)
        {
            fixed (double* originPointer = origin)
            fixed (double* heightsPointer = heights)
                SetBedCore(index, originPointer, Native.Length(origin), columns, rows, columnSpacing, rowSpacing,
                    heightsPointer, Native.Length(heights), friction);
        }

#if CONTDYN_SPANS
        /// <summary>Makes a collider all that lies below a bed of heights [m], at most 1e60 in size, which are copied.
        /// The last component is up. With 3 components heights[j * columns + i] is at the first two components origin +
        /// (i column_spacing, j row_spacing), of at least 2 columns and rows; with 2 components a single row is along
        /// the first one, and row_spacing means nothing. Heights count from the origin's own; spacings [m] are 1e-60 to
        /// 1e60. Between heights the bed is bilinear, with creases rounded within a quarter of the spacing either side;
        /// beyond the border it goes on at the border's height. How far outside a node is, is its height above the bed
        /// times the upward part of the bed's normal. A step meets the bed at the plane that touches it there where it
        /// finds the node. What the bed rises above that plane on the node's way the node may end inside of, and the
        /// next step takes it out; however fast, none falls through. Errors: CD_ERROR_RANGE too, if height_count is not
        /// columns * rows; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED with 1 component.</summary>
        public void SetBed(long index, ReadOnlySpan<double> origin, long columns, long rows, double columnSpacing,
            double rowSpacing, ReadOnlySpan<double> heights, double friction)
        {
            fixed (double* originPointer = &MemoryMarshal.GetReference(origin))
            fixed (double* heightsPointer = &MemoryMarshal.GetReference(heights))
                SetBedCore(index, origin.Length == 0 ? null : originPointer, origin.Length, columns, rows,
                    columnSpacing, rowSpacing, heights.Length == 0 ? null : heightsPointer, heights.Length, friction);
        }

#endif
        private void SetBedCore(long index, double* origin, long originLength, long columns, long rows,
            double columnSpacing, double rowSpacing, double* heights, long heightsLength, double friction)
        {
            long count = Native.Count(originLength, 1, "cd_chain_set_bed", "origin");
            long heightCount = Native.Count(heightsLength, 1, "cd_chain_set_bed", "heights");
            Changed();
            Check(Native.cd_chain_set_bed(Handle, Native.Size(index, "cd_chain_set_bed", "index"), origin,
                Native.Size(count, "cd_chain_set_bed", "count"), Native.Size(columns, "cd_chain_set_bed", "columns"),
                Native.Size(rows, "cd_chain_set_bed", "rows"), columnSpacing, rowSpacing, heights,
                Native.Size(heightCount, "cd_chain_set_bed", "height_count"), friction));
        }

        /// <summary>Each output may be null; 0 columns and rows of what is no bed. Errors: CD_ERROR_RANGE for an index
        /// that no collider has, and, with out_heights, if height_count is not columns * rows.</summary>
        public ChainBed GetBed(long index, double[] outHeights)
        {
            fixed (double* outHeightsPointer = outHeights)
                return GetBedCore(index, outHeightsPointer, Native.Length(outHeights));
        }

#if CONTDYN_SPANS
        /// <summary>Each output may be null; 0 columns and rows of what is no bed. Errors: CD_ERROR_RANGE for an index
        /// that no collider has, and, with out_heights, if height_count is not columns * rows.</summary>
        public ChainBed GetBed(long index, Span<double> outHeights)
        {
            fixed (double* outHeightsPointer = &MemoryMarshal.GetReference(outHeights))
                return GetBedCore(index, outHeights.Length == 0 ? null : outHeightsPointer, outHeights.Length);
        }

#endif
        private ChainBed GetBedCore(long index, double* outHeights, long outHeightsLength)
        {
            long heightCount = Native.Count(outHeightsLength, 1, "cd_chain_get_bed", "out_heights");
            UIntPtr outColumns;
            UIntPtr outRows;
            Check(Native.cd_chain_get_bed(Handle, Native.Size(index, "cd_chain_get_bed", "index"), &outColumns,
                &outRows, outHeights, Native.Size(heightCount, "cd_chain_get_bed", "height_count")));
            return new ChainBed((long)outColumns, (long)outRows);
        }

        /// <summary>Makes a collider the shape that a callback tells the distances of, whose positions are relative to
        /// origin [m]. A step asks for all nodes of a strand at once, at its start and then in each iteration where
        /// they would end. Where a shape is hollow it is met as beds are. Where an answer is not what cd_distance says,
        /// that step takes it for nothing there, and cd_chain_step says CD_ERROR_CALLBACK. The callback itself is no
        /// state: after a load, or a copied state, a collider that was CD_SHAPE_CALLBACK before goes on with the one it
        /// had, and for any other cd_chain_step says CD_ERROR_UNSUPPORTED until it is set again. origin may be null: a
        /// collider that is CD_SHAPE_CALLBACK stays as it is and gets this callback; count and friction mean nothing
        /// then. Errors: CD_ERROR_NULL too, for a table without a function; CD_ERROR_MEMORY.</summary>
        public void SetCallback(long index, DistanceCallbacks distance, double[] origin, double friction)
        {
            fixed (double* originPointer = origin)
                SetCallbackCore(index, distance, originPointer, Native.Length(origin), friction);
        }

#if CONTDYN_SPANS
        /// <summary>Makes a collider the shape that a callback tells the distances of, whose positions are relative to
        /// origin [m]. A step asks for all nodes of a strand at once, at its start and then in each iteration where
        /// they would end. Where a shape is hollow it is met as beds are. Where an answer is not what cd_distance says,
        /// that step takes it for nothing there, and cd_chain_step says CD_ERROR_CALLBACK. The callback itself is no
        /// state: after a load, or a copied state, a collider that was CD_SHAPE_CALLBACK before goes on with the one it
        /// had, and for any other cd_chain_step says CD_ERROR_UNSUPPORTED until it is set again. origin may be null: a
        /// collider that is CD_SHAPE_CALLBACK stays as it is and gets this callback; count and friction mean nothing
        /// then. Errors: CD_ERROR_NULL too, for a table without a function; CD_ERROR_MEMORY.</summary>
        public void SetCallback(long index, DistanceCallbacks distance, ReadOnlySpan<double> origin, double friction)
        {
            fixed (double* originPointer = &MemoryMarshal.GetReference(origin))
                SetCallbackCore(index, distance, origin.Length == 0 ? null : originPointer, origin.Length, friction);
        }

#endif
        private void SetCallbackCore(long index, DistanceCallbacks distance, double* origin, long originLength,
            double friction)
        {
            long count = Native.Count(originLength, 1, "cd_chain_set_callback", "origin");
            void* distanceStruct = distance == null ? null : distance.Struct();
            Changed();
            Check(Native.cd_chain_set_callback(Handle, Native.Size(index, "cd_chain_set_callback", "index"),
                distanceStruct, origin, Native.Size(count, "cd_chain_set_callback", "count"), friction));
            Handle.Keep("distance" + " " + index, distance);
        }

        /// <summary>Makes a collider CD_SHAPE_NONE, at rest: nothing touches it.</summary>
        public void RemoveCollider(long index)
        {
            Changed();
            Check(Native.cd_chain_remove_collider(Handle, Native.Size(index, "cd_chain_remove_collider", "index")));
        }

        /// <summary>Velocity of a collider [m/s], default 0, one number per component, at most 1e60 in size: steps move
        /// it, and it carries what it touches along. It keeps its velocity when it is made another shape. A capsule
        /// that turns: before each step put it where it will be after it, less dt times its middle's velocity, and give
        /// it that: cloth on limbs that swing at 3.6 rad/s ends up to 2e-3 m inside in steps of 1/30 s; put where the
        /// step begins, 3.5e-2 m.</summary>
        public void SetColliderVelocity(long index, params double[] velocity)
        {
            fixed (double* velocityPointer = velocity)
                SetColliderVelocityCore(index, velocityPointer, Native.Length(velocity));
        }

#if CONTDYN_SPANS
        /// <summary>Velocity of a collider [m/s], default 0, one number per component, at most 1e60 in size: steps move
        /// it, and it carries what it touches along. It keeps its velocity when it is made another shape. A capsule
        /// that turns: before each step put it where it will be after it, less dt times its middle's velocity, and give
        /// it that: cloth on limbs that swing at 3.6 rad/s ends up to 2e-3 m inside in steps of 1/30 s; put where the
        /// step begins, 3.5e-2 m.</summary>
        public void SetColliderVelocity(long index, ReadOnlySpan<double> velocity)
        {
            fixed (double* velocityPointer = &MemoryMarshal.GetReference(velocity))
                SetColliderVelocityCore(index, velocity.Length == 0 ? null : velocityPointer, velocity.Length);
        }

#endif
        private void SetColliderVelocityCore(long index, double* velocity, long velocityLength)
        {
            long count = Native.Count(velocityLength, 1, "cd_chain_set_collider_velocity", "velocity");
            Changed();
            Check(Native.cd_chain_set_collider_velocity(Handle, Native.Size(index, "cd_chain_set_collider_velocity",
                "index"), velocity, Native.Size(count, "cd_chain_set_collider_velocity", "count")));
        }

        /// <summary>What a collider is, and where now: of a plane its point and its normal, of length 1; of a capsule
        /// its two ends; of a bed its origin and its spacings, 0 upward; of a callback its origin; else zeros, but for
        /// its velocity. One number per component in each array. Each output may be null. Errors: CD_ERROR_RANGE for an
        /// index that no collider has, or a count that is not the number of components.</summary>
        public ChainCollider GetCollider(long index, double[] outFirst, double[] outSecond, double[] outVelocity)
        {
            fixed (double* outFirstPointer = outFirst)
            fixed (double* outSecondPointer = outSecond)
            fixed (double* outVelocityPointer = outVelocity)
                return GetColliderCore(index, outFirstPointer, Native.Length(outFirst), outSecondPointer,
                    Native.Length(outSecond), outVelocityPointer, Native.Length(outVelocity));
        }

#if CONTDYN_SPANS
        /// <summary>What a collider is, and where now: of a plane its point and its normal, of length 1; of a capsule
        /// its two ends; of a bed its origin and its spacings, 0 upward; of a callback its origin; else zeros, but for
        /// its velocity. One number per component in each array. Each output may be null. Errors: CD_ERROR_RANGE for an
        /// index that no collider has, or a count that is not the number of components.</summary>
        public ChainCollider GetCollider(long index, Span<double> outFirst, Span<double> outSecond,
            Span<double> outVelocity)
        {
            fixed (double* outFirstPointer = &MemoryMarshal.GetReference(outFirst))
            fixed (double* outSecondPointer = &MemoryMarshal.GetReference(outSecond))
            fixed (double* outVelocityPointer = &MemoryMarshal.GetReference(outVelocity))
                return GetColliderCore(index, outFirst.Length == 0 ? null : outFirstPointer, outFirst.Length,
                    outSecond.Length == 0 ? null : outSecondPointer, outSecond.Length,
                    outVelocity.Length == 0 ? null : outVelocityPointer, outVelocity.Length);
        }

#endif
        private ChainCollider GetColliderCore(long index, double* outFirst, long outFirstLength, double* outSecond,
            long outSecondLength, double* outVelocity, long outVelocityLength)
        {
            long count = Native.Count(Math.Max((outFirst != null ? outFirstLength : outSecondLength),
                outVelocityLength), 1, "cd_chain_get_collider", "out_first");
            Native.Same(outSecond, outSecondLength, count, "cd_chain_get_collider", "out_second");
            Native.Same(outVelocity, outVelocityLength, count, "cd_chain_get_collider", "out_velocity");
            int outShape;
            double outRadius;
            double outFriction;
            Check(Native.cd_chain_get_collider(Handle, Native.Size(index, "cd_chain_get_collider", "index"), &outShape,
                outFirst, outSecond, outVelocity, Native.Size(count, "cd_chain_get_collider", "count"), &outRadius,
                &outFriction));
            return new ChainCollider((Shape)outShape, outRadius, outFriction);
        }

        /// <summary>Whether steps note what ropes do to colliders: 1, or 0, the default. Errors: CD_ERROR_VALUE;
        /// CD_ERROR_MEMORY.</summary>
        public bool Loads
        {
            get
            {
                int outLoads;
                Check(Native.cd_chain_get_loads(Handle, &outLoads));
                return outLoads != 0;
            }
            set
            {
                var loads = value;
                Changed();
                Check(Native.cd_chain_set_loads(Handle, loads ? 1 : 0));
            }
        }

        /// <summary>What the nodes of all strands did to a collider, pushes and friction, in the last step, in the mean
        /// over its time: 6 numbers, the force along x, y and z [N] and its moment about the origin [N m]; about a
        /// point p it is less by p x force. Momentum of ropes changes by what all else gives, less this, but 0 is told
        /// of a strand whose step ended short of its tolerance. What a node forgets of the speed at which it came out
        /// of a collider is not given. A strand that sleeps bears as in its last step. 0 before a step. Part of the
        /// state. Errors: CD_ERROR_RANGE for index, or if count is not 6; CD_ERROR_DISABLED unless cd_chain_set_loads
        /// has asked for it.</summary>
        public void GetColliderLoad(long index, double[] outLoad)
        {
            fixed (double* outLoadPointer = outLoad)
                GetColliderLoadCore(index, outLoadPointer, Native.Length(outLoad));
        }

#if CONTDYN_SPANS
        /// <summary>What the nodes of all strands did to a collider, pushes and friction, in the last step, in the mean
        /// over its time: 6 numbers, the force along x, y and z [N] and its moment about the origin [N m]; about a
        /// point p it is less by p x force. Momentum of ropes changes by what all else gives, less this, but 0 is told
        /// of a strand whose step ended short of its tolerance. What a node forgets of the speed at which it came out
        /// of a collider is not given. A strand that sleeps bears as in its last step. 0 before a step. Part of the
        /// state. Errors: CD_ERROR_RANGE for index, or if count is not 6; CD_ERROR_DISABLED unless cd_chain_set_loads
        /// has asked for it.</summary>
        public void GetColliderLoad(long index, Span<double> outLoad)
        {
            fixed (double* outLoadPointer = &MemoryMarshal.GetReference(outLoad))
                GetColliderLoadCore(index, outLoad.Length == 0 ? null : outLoadPointer, outLoad.Length);
        }

#endif
        private void GetColliderLoadCore(long index, double* outLoad, long outLoadLength)
        {
            long count = Native.Count(outLoadLength, 1, "cd_chain_get_collider_load", "out_load");
            Check(Native.cd_chain_get_collider_load(Handle, Native.Size(index, "cd_chain_get_collider_load", "index"),
                outLoad, Native.Size(count, "cd_chain_get_collider_load", "count")));
        }

        /// <summary>How thick ropes are, as a radius [m] in [0, 1e60], default 0: nodes stay this far outside of
        /// colliders.</summary>
        public double Thickness
        {
            get
            {
                double outRadius;
                Check(Native.cd_chain_get_thickness(Handle, &outRadius));
                return outRadius;
            }
            set
            {
                var radius = value;
                Changed();
                Check(Native.cd_chain_set_thickness(Handle, radius));
            }
        }

        /// <summary>Switches a field on, filled with the present uniform values (force 0, target the present position).
        /// On already: nothing happens. CD_STRENGTH switches CD_STIFFNESS on too. Errors: CD_ERROR_ENUM,
        /// CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_TARGET where the state is not finite; here and below
        /// CD_ERROR_UNSUPPORTED for the fields of ropes of a chain that is none.</summary>
        public void EnableField(Field field)
        {
            Changed();
            Check(Native.cd_chain_enable_field(Handle, (int)field));
        }

        /// <summary>Switches a field off and releases its memory: uniform values again, no forces, all attachments
        /// loosened. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position, velocity, pin, tension and strain, and
        /// for stiffness where springs may break.</summary>
        public void DisableField(Field field)
        {
            Changed();
            Check(Native.cd_chain_disable_field(Handle, (int)field));
        }

        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void WriteF32(Field field, long firstStrand, long strands, long first, long n, params float[] values)
        {
            fixed (float* valuesPointer = values)
                WriteF32Core(field, firstStrand, strands, first, n, valuesPointer, Native.Length(values));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void WriteF32(Field field, long firstStrand, long strands, long first, long n,
            ReadOnlySpan<float> values)
        {
            fixed (float* valuesPointer = &MemoryMarshal.GetReference(values))
                WriteF32Core(field, firstStrand, strands, first, n, values.Length == 0 ? null : valuesPointer,
                    values.Length);
        }

#endif
        private void WriteF32Core(Field field, long firstStrand, long strands, long first, long n, float* values,
            long valuesLength)
        {
            long count = Native.Count(valuesLength, 1, "cd_chain_write_f32", "values");
            Changed();
            Check(Native.cd_chain_write_f32(Handle, (int)field, Native.Size(firstStrand, "cd_chain_write_f32",
                "first_strand"), Native.Size(strands, "cd_chain_write_f32", "strands"), Native.Size(first,
                "cd_chain_write_f32", "first"), Native.Size(n, "cd_chain_write_f32", "n"), values, Native.Size(count,
                "cd_chain_write_f32", "count")));
        }

        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void WriteF64(Field field, long firstStrand, long strands, long first, long n, params double[] values)
        {
            fixed (double* valuesPointer = values)
                WriteF64Core(field, firstStrand, strands, first, n, valuesPointer, Native.Length(values));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void WriteF64(Field field, long firstStrand, long strands, long first, long n,
            ReadOnlySpan<double> values)
        {
            fixed (double* valuesPointer = &MemoryMarshal.GetReference(values))
                WriteF64Core(field, firstStrand, strands, first, n, values.Length == 0 ? null : valuesPointer,
                    values.Length);
        }

#endif
        private void WriteF64Core(Field field, long firstStrand, long strands, long first, long n, double* values,
            long valuesLength)
        {
            long count = Native.Count(valuesLength, 1, "cd_chain_write_f64", "values");
            Changed();
            Check(Native.cd_chain_write_f64(Handle, (int)field, Native.Size(firstStrand, "cd_chain_write_f64",
                "first_strand"), Native.Size(strands, "cd_chain_write_f64", "strands"), Native.Size(first,
                "cd_chain_write_f64", "first"), Native.Size(n, "cd_chain_write_f64", "n"), values, Native.Size(count,
                "cd_chain_write_f64", "count")));
        }

        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void ReadF32(Field field, long firstStrand, long strands, long first, long n, float[] outValues)
        {
            fixed (float* outValuesPointer = outValues)
                ReadF32Core(field, firstStrand, strands, first, n, outValuesPointer, Native.Length(outValues));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void ReadF32(Field field, long firstStrand, long strands, long first, long n, Span<float> outValues)
        {
            fixed (float* outValuesPointer = &MemoryMarshal.GetReference(outValues))
                ReadF32Core(field, firstStrand, strands, first, n, outValues.Length == 0 ? null : outValuesPointer,
                    outValues.Length);
        }

#endif
        private void ReadF32Core(Field field, long firstStrand, long strands, long first, long n, float* outValues,
            long outValuesLength)
        {
            long count = Native.Count(outValuesLength, 1, "cd_chain_read_f32", "out_values");
            Check(Native.cd_chain_read_f32(Handle, (int)field, Native.Size(firstStrand, "cd_chain_read_f32",
                "first_strand"), Native.Size(strands, "cd_chain_read_f32", "strands"), Native.Size(first,
                "cd_chain_read_f32", "first"), Native.Size(n, "cd_chain_read_f32", "n"), outValues, Native.Size(count,
                "cd_chain_read_f32", "count")));
        }

        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void ReadF64(Field field, long firstStrand, long strands, long first, long n, double[] outValues)
        {
            fixed (double* outValuesPointer = outValues)
                ReadF64Core(field, firstStrand, strands, first, n, outValuesPointer, Native.Length(outValues));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[strand][node][component], dense, of strands [first_strand, first_strand +
        /// strands) and nodes (or springs) [first, first + n). Fields without components have one value per node;
        /// fields that the strands share have the single strand 0. `count` is the number of values in the buffer:
        /// strands * n * components. Numbers are rounded once, to the precision of the side that is narrower. Never
        /// allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the first
        /// bad index, and CD_ERROR_UNSUPPORTED for CD_STRAIN.</summary>
        public void ReadF64(Field field, long firstStrand, long strands, long first, long n, Span<double> outValues)
        {
            fixed (double* outValuesPointer = &MemoryMarshal.GetReference(outValues))
                ReadF64Core(field, firstStrand, strands, first, n, outValues.Length == 0 ? null : outValuesPointer,
                    outValues.Length);
        }

#endif
        private void ReadF64Core(Field field, long firstStrand, long strands, long first, long n, double* outValues,
            long outValuesLength)
        {
            long count = Native.Count(outValuesLength, 1, "cd_chain_read_f64", "out_values");
            Check(Native.cd_chain_read_f64(Handle, (int)field, Native.Size(firstStrand, "cd_chain_read_f64",
                "first_strand"), Native.Size(strands, "cd_chain_read_f64", "strands"), Native.Size(first,
                "cd_chain_read_f64", "first"), Native.Size(n, "cd_chain_read_f64", "n"), outValues, Native.Size(count,
                "cd_chain_read_f64", "count")));
        }

        /// <summary>Where a field lies in the chain's own memory, in the chain's precision, to read without a copy: the
        /// value of (strand, node, component) is at byte *out_data + strand * strand_stride + node * node_stride +
        /// component * component_stride. Position, velocity, force and target only. The pointer is good until the field
        /// is switched off or the chain released; the numbers change with every write and step. Do not write through
        /// it. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED.</summary>
        public View View(Field field)
        {
            return new View(this, field);
        }

        internal override IntPtr Lie(Field field, long[] strides)
        {
            IntPtr data;
            UIntPtr* s = stackalloc UIntPtr[4];
            Check(Native.cd_chain_view(Handle, (int)field, &data, s + 0, s + 1, s + 2));
            strides[0] = (long)s[0];
            strides[1] = (long)s[1];
            strides[2] = (long)s[2];
            return data;
        }

        /// <summary>Adds impulse [N s], one number per component, to a node: its velocity changes by impulse / mass, in
        /// a welded group by impulse / the group's mass; a held node takes none. Errors: CD_ERROR_RANGE,
        /// CD_ERROR_VALUE, CD_ERROR_DIVERGED.</summary>
        public void Impulse(long strand, long node, params double[] impulse)
        {
            fixed (double* impulsePointer = impulse)
                ImpulseCore(strand, node, impulsePointer, Native.Length(impulse));
        }

#if CONTDYN_SPANS
        /// <summary>Adds impulse [N s], one number per component, to a node: its velocity changes by impulse / mass, in
        /// a welded group by impulse / the group's mass; a held node takes none. Errors: CD_ERROR_RANGE,
        /// CD_ERROR_VALUE, CD_ERROR_DIVERGED.</summary>
        public void Impulse(long strand, long node, ReadOnlySpan<double> impulse)
        {
            fixed (double* impulsePointer = &MemoryMarshal.GetReference(impulse))
                ImpulseCore(strand, node, impulse.Length == 0 ? null : impulsePointer, impulse.Length);
        }

#endif
        private void ImpulseCore(long strand, long node, double* impulse, long impulseLength)
        {
            long count = Native.Count(impulseLength, 1, "cd_chain_impulse", "impulse");
            Changed();
            Check(Native.cd_chain_impulse(Handle, Native.Size(strand, "cd_chain_impulse", "strand"), Native.Size(node,
                "cd_chain_impulse", "node"), impulse, Native.Size(count, "cd_chain_impulse", "count")));
        }

        /// <summary>Moves a strand as a whole, as if it had always been there: every position and target becomes
        /// rotation * x + offset, every velocity rotation * v; tensions stay, and colliders stay where they are.
        /// rotation: components rows of as many numbers, orthogonal to 1e-6, with rest angles no mirror image; null:
        /// none. offset [m]: one number per component, which count counts. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE;
        /// CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public void Teleport(long strand, double[] rotation, params double[] offset)
        {
            fixed (double* rotationPointer = rotation)
            fixed (double* offsetPointer = offset)
                TeleportCore(strand, rotationPointer, Native.Length(rotation), offsetPointer, Native.Length(offset));
        }

#if CONTDYN_SPANS
        /// <summary>Moves a strand as a whole, as if it had always been there: every position and target becomes
        /// rotation * x + offset, every velocity rotation * v; tensions stay, and colliders stay where they are.
        /// rotation: components rows of as many numbers, orthogonal to 1e-6, with rest angles no mirror image; null:
        /// none. offset [m]: one number per component, which count counts. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE;
        /// CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public void Teleport(long strand, ReadOnlySpan<double> rotation, ReadOnlySpan<double> offset)
        {
            fixed (double* rotationPointer = &MemoryMarshal.GetReference(rotation))
            fixed (double* offsetPointer = &MemoryMarshal.GetReference(offset))
                TeleportCore(strand, rotation.Length == 0 ? null : rotationPointer, rotation.Length,
                    offset.Length == 0 ? null : offsetPointer, offset.Length);
        }

#endif
        private void TeleportCore(long strand, double* rotation, long rotationLength, double* offset, long offsetLength)
        {
            long count = Native.Count(offsetLength, 1, "cd_chain_teleport", "offset");
            Native.Same(rotation, rotationLength, count * count, "cd_chain_teleport", "rotation");
            Changed();
            Check(Native.cd_chain_teleport(Handle, Native.Size(strand, "cd_chain_teleport", "strand"), rotation,
                offset, Native.Size(count, "cd_chain_teleport", "count")));
        }

        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. In a rope it is the node of this strand; in a chain that is no rope `strand` must be
        /// 0, and the node of every strand is tied. target, one number per component, is given to every strand that is
        /// tied; null: the present position, and count means nothing. Move it afterwards by writing CD_TARGET.
        /// Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE,
        /// CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public void Attach(long strand, long node, double stiffness, double damping, params double[] target)
        {
            fixed (double* targetPointer = target)
                AttachCore(strand, node, stiffness, damping, targetPointer, Native.Length(target));
        }

#if CONTDYN_SPANS
        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. In a rope it is the node of this strand; in a chain that is no rope `strand` must be
        /// 0, and the node of every strand is tied. target, one number per component, is given to every strand that is
        /// tied; null: the present position, and count means nothing. Move it afterwards by writing CD_TARGET.
        /// Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE,
        /// CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public void Attach(long strand, long node, double stiffness, double damping, ReadOnlySpan<double> target)
        {
            fixed (double* targetPointer = &MemoryMarshal.GetReference(target))
                AttachCore(strand, node, stiffness, damping, target.Length == 0 ? null : targetPointer, target.Length);
        }

#endif
        private void AttachCore(long strand, long node, double stiffness, double damping, double* target,
            long targetLength)
        {
            long count = Native.Count(targetLength, 1, "cd_chain_attach", "target");
            Changed();
            Check(Native.cd_chain_attach(Handle, Native.Size(strand, "cd_chain_attach", "strand"), Native.Size(node,
                "cd_chain_attach", "node"), stiffness, damping, target, Native.Size(count, "cd_chain_attach",
                "count")));
        }

        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. In a rope it is the node of this strand; in a chain that is no rope `strand` must be
        /// 0, and the node of every strand is tied. target, one number per component, is given to every strand that is
        /// tied; null: the present position, and count means nothing. Move it afterwards by writing CD_TARGET.
        /// Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE,
        /// CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public void Detach(long strand, long node)
        {
            Changed();
            Check(Native.cd_chain_detach(Handle, Native.Size(strand, "cd_chain_detach", "strand"), Native.Size(node,
                "cd_chain_detach", "node")));
        }

        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. In a rope it is the node of this strand; in a chain that is no rope `strand` must be
        /// 0, and the node of every strand is tied. target, one number per component, is given to every strand that is
        /// tied; null: the present position, and count means nothing. Move it afterwards by writing CD_TARGET.
        /// Attaching again changes the numbers. Switches CD_TARGET on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE,
        /// CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public ChainAttachment GetAttachment(long strand, long node)
        {
            double outStiffness;
            double outDamping;
            Check(Native.cd_chain_get_attachment(Handle, Native.Size(strand, "cd_chain_get_attachment", "strand"),
                Native.Size(node, "cd_chain_get_attachment", "node"), &outStiffness, &outDamping));
            return new ChainAttachment(outStiffness, outDamping);
        }

        /// <summary>Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain
        /// that is no rope `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one
        /// velocity, the mean of theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to
        /// a held node gives that node's velocity. A cut or welded spring gets a stiffness again by writing
        /// CD_STIFFNESS. Both switch CD_STIFFNESS on. Bend is not cut with the spring: write CD_BEND. In a rope it is,
        /// as long as the stiffness is 0, and welding fixes the spring's length only. Errors: CD_ERROR_RANGE,
        /// CD_ERROR_MEMORY; weld: CD_ERROR_UNSUPPORTED if it would join two held nodes.</summary>
        public void Cut(long strand, long spring)
        {
            Changed();
            Check(Native.cd_chain_cut(Handle, Native.Size(strand, "cd_chain_cut", "strand"), Native.Size(spring,
                "cd_chain_cut", "spring")));
        }

        /// <summary>Cuts a spring (stiffness 0) or welds it (infinite stiffness), in a rope of this strand; in a chain
        /// that is no rope `strand` must be 0, and it is done in every strand. From a weld on the two nodes share one
        /// velocity, the mean of theirs by mass, so that momentum is kept, and their offset stays as it is. Welding to
        /// a held node gives that node's velocity. A cut or welded spring gets a stiffness again by writing
        /// CD_STIFFNESS. Both switch CD_STIFFNESS on. Bend is not cut with the spring: write CD_BEND. In a rope it is,
        /// as long as the stiffness is 0, and welding fixes the spring's length only. Errors: CD_ERROR_RANGE,
        /// CD_ERROR_MEMORY; weld: CD_ERROR_UNSUPPORTED if it would join two held nodes.</summary>
        public void Weld(long strand, long spring)
        {
            Changed();
            Check(Native.cd_chain_weld(Handle, Native.Size(strand, "cd_chain_weld", "strand"), Native.Size(spring,
                "cd_chain_weld", "spring")));
        }

        /// <summary>Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
        /// Never allocates. Time is proportional to count * strands * nodes * components. Errors: CD_ERROR_VALUE;
        /// CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the message gives the first bad
        /// one, the chain can be read, and steps again after cd_chain_reset, a load, or once finite positions and
        /// velocities have been written; of ropes CD_ERROR_UNSUPPORTED for what they can't have, CD_ERROR_CALLBACK as
        /// cd_chain_set_callback says, and CD_ERROR_TOLERANCE if a step ended short of its tolerance: all steps are
        /// made, and good to the error that cd_chain_get_convergence tells, but for tensions: see
        /// cd_chain_get_reaction.</summary>
        public void Step(double dt, long count = 1)
        {
            Changed();
            Check(Native.cd_chain_step(Handle, dt, Native.Size(count, "cd_chain_step", "count")));
        }

        /// <summary>The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded, whatever method is set: the
        /// largest dt with 4 M - 2 dt C - dt^2 K positive definite. Exact for stretch with drag and stiffness damping;
        /// with bend a lower bound, exact in the limit of many nodes; with matched ends and attachment damping a lower
        /// bound, and close. INFINITY if nothing can swing. Errors: CD_ERROR_UNSUPPORTED of ropes.</summary>
        public double StableDt()
        {
            double outDt;
            Check(Native.cd_chain_stable_dt(Handle, &outDt));
            return outDt;
        }

        /// <summary>Simulated time [s] and steps made since create or reset, those before a load or a copied state
        /// included.</summary>
        public double GetTime()
        {
            double outTime;
            Check(Native.cd_chain_get_time(Handle, &outTime));
            return outTime;
        }

        /// <summary>Simulated time [s] and steps made since create or reset, those before a load or a copied state
        /// included.</summary>
        public ulong GetSteps()
        {
            ulong outSteps;
            Check(Native.cd_chain_get_steps(Handle, &outSteps));
            return outSteps;
        }

        /// <summary>How many factorizations the chain has made: one at the first implicit step and one at the first
        /// after each change of dt, lambda, method or a parameter. Ropes make none. Not part of the saved
        /// state.</summary>
        public ulong GetFactorizations()
        {
            ulong outCount;
            Check(Native.cd_chain_get_factorizations(Handle, &outCount));
            return outCount;
        }

        /// <summary>Energies of all strands together [J]; each output may be null. Kinetic: of the free nodes. Elastic:
        /// stretch, bend and attachments; a welded spring holds none. Gravity: -sum m g x of the free nodes. Undamped,
        /// lambda = 1/2 keeps their sum, of ropes but for what is told of them.</summary>
        public ChainEnergy GetEnergy()
        {
            double outKinetic;
            double outElastic;
            double outGravity;
            Check(Native.cd_chain_get_energy(Handle, &outKinetic, &outElastic, &outGravity));
            return new ChainEnergy(outKinetic, outElastic, outGravity);
        }

        /// <summary>Momentum of the free nodes of all strands together [kg m/s], one number per component. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void GetMomentum(double[] outMomentum)
        {
            fixed (double* outMomentumPointer = outMomentum)
                GetMomentumCore(outMomentumPointer, Native.Length(outMomentum));
        }

#if CONTDYN_SPANS
        /// <summary>Momentum of the free nodes of all strands together [kg m/s], one number per component. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void GetMomentum(Span<double> outMomentum)
        {
            fixed (double* outMomentumPointer = &MemoryMarshal.GetReference(outMomentum))
                GetMomentumCore(outMomentum.Length == 0 ? null : outMomentumPointer, outMomentum.Length);
        }

#endif
        private void GetMomentumCore(double* outMomentum, long outMomentumLength)
        {
            long count = Native.Count(outMomentumLength, 1, "cd_chain_get_momentum", "out_momentum");
            Check(Native.cd_chain_get_momentum(Handle, outMomentum, Native.Size(count, "cd_chain_get_momentum",
                "count")));
        }

        /// <summary>Positions of one strand at places along it, linear between nodes: at[j] in [0, springs] (ring: to
        /// springs + 1), out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE if there is no
        /// such strand or out_count is another number; CD_ERROR_ENUM; CD_ERROR_VALUE for a place beyond the
        /// strand.</summary>
        public void Sample(long strand, double[] at, Outside outside, double[] outPositions)
        {
            fixed (double* atPointer = at)
            fixed (double* outPositionsPointer = outPositions)
                SampleCore(strand, atPointer, Native.Length(at), outside, outPositionsPointer,
                    Native.Length(outPositions));
        }

#if CONTDYN_SPANS
        /// <summary>Positions of one strand at places along it, linear between nodes: at[j] in [0, springs] (ring: to
        /// springs + 1), out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE if there is no
        /// such strand or out_count is another number; CD_ERROR_ENUM; CD_ERROR_VALUE for a place beyond the
        /// strand.</summary>
        public void Sample(long strand, ReadOnlySpan<double> at, Outside outside, Span<double> outPositions)
        {
            fixed (double* atPointer = &MemoryMarshal.GetReference(at))
            fixed (double* outPositionsPointer = &MemoryMarshal.GetReference(outPositions))
                SampleCore(strand, at.Length == 0 ? null : atPointer, at.Length, outside,
                    outPositions.Length == 0 ? null : outPositionsPointer, outPositions.Length);
        }

#endif
        private void SampleCore(long strand, double* at, long atLength, Outside outside, double* outPositions,
            long outPositionsLength)
        {
            long n = Native.Count(atLength, 1, "cd_chain_sample", "at");
            long outCount = Native.Count(outPositionsLength, 1, "cd_chain_sample", "out_positions");
            Check(Native.cd_chain_sample(Handle, Native.Size(strand, "cd_chain_sample", "strand"), at, Native.Size(n,
                "cd_chain_sample", "n"), (int)outside, outPositions, Native.Size(outCount, "cd_chain_sample",
                "out_count")));
        }

        /// <summary>Bytes the chain holds from its allocator.</summary>
        public long GetMemory()
        {
            UIntPtr outBytes;
            Check(Native.cd_chain_get_memory(Handle, &outBytes));
            return (long)outBytes;
        }

        /// <summary>A 64-bit hash of everything cd_chain_save would write. Equal on every machine, compiler and vector
        /// width.</summary>
        public ulong Hash()
        {
            ulong outHash;
            Check(Native.cd_chain_hash(Handle, &outHash));
            return outHash;
        }

        /// <summary>The whole state as bytes: shape, parameters, fields, time: all the future depends on but the
        /// callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_chain_save_size and tells what it wrote. load needs a chain of the same shape and precision; it switches
        /// fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind are
        /// refused and change nothing. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public long SaveSize()
        {
            UIntPtr outSize;
            Check(Native.cd_chain_save_size(Handle, &outSize));
            return (long)outSize;
        }

        /// <summary>The whole state as bytes: shape, parameters, fields, time: all the future depends on but the
        /// callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_chain_save_size and tells what it wrote. load needs a chain of the same shape and precision; it switches
        /// fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind are
        /// refused and change nothing. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public long Save<T>(T[] buffer) where T : struct
        {
            using (var bufferPinned = new Pinned<T>(buffer))
                return SaveCore(bufferPinned.Pointer, bufferPinned.Length);
        }

#if CONTDYN_SPANS
        /// <summary>The whole state as bytes: shape, parameters, fields, time: all the future depends on but the
        /// callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_chain_save_size and tells what it wrote. load needs a chain of the same shape and precision; it switches
        /// fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind are
        /// refused and change nothing. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public long Save(Span<byte> buffer)
        {
            fixed (byte* bufferPointer = &MemoryMarshal.GetReference(buffer))
                return SaveCore(buffer.Length == 0 ? null : bufferPointer, buffer.Length);
        }

#endif
        private long SaveCore(void* buffer, long bufferLength)
        {
            long size = bufferLength;
            UIntPtr outWritten;
            Check(Native.cd_chain_save(Handle, buffer, Native.Size(size, "cd_chain_save", "size"), &outWritten));
            return (long)outWritten;
        }

        /// <summary>The same into a new array.</summary>
        public byte[] Save()
        {
            var bytes = new byte[SaveSize()];
            Array.Resize(ref bytes, (int)Save(bytes));
            return bytes;
        }

        /// <summary>The whole state as bytes: shape, parameters, fields, time: all the future depends on but the
        /// callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_chain_save_size and tells what it wrote. load needs a chain of the same shape and precision; it switches
        /// fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind are
        /// refused and change nothing. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public void Load<T>(T[] bytes) where T : struct
        {
            using (var bytesPinned = new Pinned<T>(bytes))
                LoadCore(bytesPinned.Pointer, bytesPinned.Length);
        }

#if CONTDYN_SPANS
        /// <summary>The whole state as bytes: shape, parameters, fields, time: all the future depends on but the
        /// callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_chain_save_size and tells what it wrote. load needs a chain of the same shape and precision; it switches
        /// fields on and off as they were. Bytes that are damaged, cut short, of a later version or another kind are
        /// refused and change nothing. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public void Load(ReadOnlySpan<byte> bytes)
        {
            fixed (byte* bytesPointer = &MemoryMarshal.GetReference(bytes))
                LoadCore(bytes.Length == 0 ? null : bytesPointer, bytes.Length);
        }

#endif
        private void LoadCore(void* bytes, long bytesLength)
        {
            long size = bytesLength;
            Changed();
            Check(Native.cd_chain_load(Handle, bytes, Native.Size(size, "cd_chain_load", "size")));
        }

        /// <summary>Makes `chain` what `source` is, as save and load would, without the bytes: the two must agree in
        /// shape and precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public void CopyState(Chain source)
        {
            Changed();
            Check(Native.cd_chain_copy_state(Handle, Native.NotNull(source, "source").Handle));
        }

        /// <summary>Positions, velocities, tensions, time and steps back to 0. Parameters, fields and pins stay;
        /// targets too.</summary>
        public void Reset()
        {
            Changed();
            Check(Native.cd_chain_reset(Handle));
        }
    }

    /// <summary>What Membrane.GetShape tells.</summary>
    public struct MembraneShape
    {
        public readonly long Nu;
        public readonly long Nv;
        public readonly long Components;
        public readonly Precision Precision;

        internal MembraneShape(long nu, long nv, long components, Precision precision)
        {
            Nu = nu;
            Nv = nv;
            Components = components;
            Precision = precision;
        }
    }

    /// <summary>What Membrane.GetTolerance tells.</summary>
    public struct MembraneTolerance
    {
        public readonly double Tolerance;
        public readonly long MostIterations;

        internal MembraneTolerance(double tolerance, long mostIterations)
        {
            Tolerance = tolerance;
            MostIterations = mostIterations;
        }
    }

    /// <summary>What Membrane.GetConvergence tells.</summary>
    public struct MembraneConvergence
    {
        public readonly long Iterations;
        public readonly double Residual;

        internal MembraneConvergence(long iterations, double residual)
        {
            Iterations = iterations;
            Residual = residual;
        }
    }

    /// <summary>What Membrane.GetStiffness tells.</summary>
    public struct MembraneStiffness
    {
        public readonly double AlongU;
        public readonly double AlongV;

        internal MembraneStiffness(double alongU, double alongV)
        {
            AlongU = alongU;
            AlongV = alongV;
        }
    }

    /// <summary>What Membrane.GetRing tells.</summary>
    public struct MembraneRing
    {
        public readonly bool AlongU;
        public readonly bool AlongV;

        internal MembraneRing(bool alongU, bool alongV)
        {
            AlongU = alongU;
            AlongV = alongV;
        }
    }

    /// <summary>What Membrane.GetSleep tells.</summary>
    public struct MembraneSleep
    {
        public readonly double Speed;
        public readonly double Seconds;

        internal MembraneSleep(double speed, double seconds)
        {
            Speed = speed;
            Seconds = seconds;
        }
    }

    /// <summary>What Membrane.GetRestLength tells.</summary>
    public struct MembraneRestLength
    {
        public readonly double AlongU;
        public readonly double AlongV;

        internal MembraneRestLength(double alongU, double alongV)
        {
            AlongU = alongU;
            AlongV = alongV;
        }
    }

    /// <summary>What Membrane.GetEffort tells.</summary>
    public struct MembraneEffort
    {
        public readonly long Newton;
        public readonly long Gradient;

        internal MembraneEffort(long newton, long gradient)
        {
            Newton = newton;
            Gradient = gradient;
        }
    }

    /// <summary>What Membrane.GetAir tells.</summary>
    public struct MembraneAir
    {
        public readonly double Along;
        public readonly double Across;

        internal MembraneAir(double along, double across)
        {
            Along = along;
            Across = across;
        }
    }

    /// <summary>What Membrane.GetBed tells.</summary>
    public struct MembraneBed
    {
        public readonly long Columns;
        public readonly long Rows;

        internal MembraneBed(long columns, long rows)
        {
            Columns = columns;
            Rows = rows;
        }
    }

    /// <summary>What Membrane.GetCollider tells.</summary>
    public struct MembraneCollider
    {
        public readonly Shape Shape;
        public readonly double Radius;
        public readonly double Friction;

        internal MembraneCollider(Shape shape, double radius, double friction)
        {
            Shape = shape;
            Radius = radius;
            Friction = friction;
        }
    }

    /// <summary>What Membrane.GetAttachment tells.</summary>
    public struct MembraneAttachment
    {
        public readonly double Stiffness;
        public readonly double Damping;

        internal MembraneAttachment(double stiffness, double damping)
        {
            Stiffness = stiffness;
            Damping = damping;
        }
    }

    /// <summary>What Membrane.GetEnergy tells.</summary>
    public struct MembraneEnergy
    {
        public readonly double Kinetic;
        public readonly double Elastic;
        public readonly double Gravity;

        internal MembraneEnergy(double kinetic, double elastic, double gravity)
        {
            Kinetic = kinetic;
            Elastic = elastic;
            Gravity = gravity;
        }
    }

    /// <summary>contdyn: a membrane: nodes joined by springs in two directions: drum, balloon, plate, and with rest
    /// lengths cloth.
    /// A membrane has `nu` springs along u and `nv` along v, and (nu + 1) (nv + 1) nodes; node (u, v) has the
    /// number v (nu + 1) + u wherever nodes are listed. A node has 1 to 4 components that never mix. A direction
    /// can be closed to a ring: its last nodes are then joined to the first by one spring more.
    /// Energy E = 1/2 sum k_u |x_{u+1,v} - x_{u,v}|^2 + 1/2 sum k_v |x_{u,v+1} - x_{u,v}|^2 + 1/2 sum b (|x_uu|^2 +
    /// 2 |x_uv|^2 + |x_vv|^2) (Kass 1997, section 8; the thin plate's energy) Motion M x'' + C x' + K x = M g + f +
    /// pressure along the normal, K = the Hessian of E, C = drag M + stiffness_damping K
    /// Rest length is zero, unless cd_membrane_set_rest_length makes the membrane cloth: a free sheet draws
    /// together, and one stretched evenly is held by its edges. A new membrane lies at the origin, at rest, all
    /// nodes free, mass 1, stiffness 1 both ways, no bend, gravity and damping, CD_METHOD_IMPLICIT with lambda 1/2,
    /// CD_SOLVER_AUTO.
    /// Which solver? An implicit step of a sheet without rest lengths has a two-dimensional system to solve, here
    /// with h = lambda dt. Leave that to CD_SOLVER_AUTO, or take CD_SOLVER_ALTERNATING for a fixed cost and less
    /// memory. A sheet is uniform here if its masses and stiffnesses are the totals dealt out and no node is
    /// absent; if nothing holds it but whole rows and columns and at most 16 single nodes, held or attached, these
    /// while h (h + damping) (2 k + 16 b) is at most 1e4 times a node's mass; and if with bend each direction is
    /// held at both edges or a ring, not both a ring. CD_SOLVER_ALTERNATING rows, then columns (Kass 1997, section
    /// 9). Uniform sheets are stable at any stiffness and any dt that stays the same. A motion of the angular
    /// frequencies w_u and w_v along the two directions is slowed down as if it were 1 + (w_u h)^2 (w_v h)^2 times
    /// as heavy; where the sheet comes to rest does not depend on dt. Other sheets, a plate that is a ring both
    /// ways among them, would blow up: their step, not quite linear and at six times the cost, is the best, in
    /// energy, of sums of the lines' answers, the velocity and common motion. It leaves slow motions anywhere where
    /// fast ones have energy: a plate with a hole was off by all that it swung. CD_SOLVER_COUPLED the system
    /// itself, to a tolerance, by conjugate gradients: nothing is slowed down. Uniform sheets without bend and
    /// rings take one or two iterations of some ten alternating solves each, others multigrid, 4 to 100 times the
    /// cost. It comes to rest where alternating does. Take it where stiff sheets must move in time, or stiff parts
    /// against each other: alternating finds only their common motion. It needs many iterations where springs or
    /// masses vary at random by decades, plates with free edges hardly stretch or many nodes are tied.
    /// CD_SOLVER_AUTO of uniform sheets, for each dt, alternating where the slowest motion (half a wave along each
    /// direction, round a ring a whole one, with the kinks at held or attached nodes) is made at most 5% heavier.
    /// Else coupled; and so, until cd_membrane_reset, uniform sheets that have been coupled once, whose steps have
    /// differed in dt, method, lambda, damping or solver, or of which moving nodes were pinned. At that bound a
    /// kick of one of 33 x 33 nodes goes 31 times as far as it should, of a radius of an eighth of the sheet 3.5,
    /// of a quarter 1.4. It holds some 300 bytes a node; alternating takes 36 where edges hold it. Builds without
    /// coupled solver alternate. Steps are of second order in time, those of alternating plates with stiffness
    /// damping of first. Without rest lengths: Energy: lambda = 1/2 keeps it, and lambda &gt; 1/2 never adds any,
    /// whatever the tolerance of coupled solves. Momentum: of a free sheet, and of each part of a torn one, it is
    /// kept however stiff they are; alternating, up to a stiffness of 1e19 mass / h^2 of uniform sheets, and a bend
    /// of 1e13 mass / h^2 of plates with one ring. Unlike steps: alternating, the energy that a uniform sheet keeps
    /// counts the extra mass, which depends on dt, lambda and damping. If these keep changing it grows without
    /// bound: with lambda = 1/2 or CD_METHOD_STIFF_SECOND by up to an eighth a step where 16 and 17 ms take turns,
    /// with lambda = 1 by a quarter where some steps are twice as long. CD_FLOAT32: alternating, the rounding of a
    /// velocity is a kick whose energy is so many times larger as the motion is heavier: where (w_u h) (w_v h) is
    /// beyond 1e4, take CD_FLOAT64 or the coupled solver. CD_METHOD_STIFF_SECOND: adds no energy where coupled
    /// solves meet the default tolerance; a step that ended short of its own has added a third, one that alternates
    /// on a sheet that is not uniform a twentieth. What chain.h says of precision and of numbers that are too small
    /// holds for sheets too. Parameters may be as large as 1e60, masses as small as 1e-60. Every function returns
    /// CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind; the comments name the
    /// other errors. Functions that the chain has too mean the same here.</summary>
    public sealed unsafe class Membrane : LibraryObject
    {
        internal new MembraneHandle Handle { get { return (MembraneHandle)base.Handle; } }

        /// <summary>Makes a membrane. nu, nv &gt;= 0 (0: a single row or column of nodes); components 1 to 4. allocator
        /// may be null (malloc). The caller owns *out_membrane and releases it with cd_membrane_destroy; on failure
        /// *out_membrane is left alone. Errors: CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY;
        /// CD_ERROR_UNSUPPORTED for a precision that this build leaves out.</summary>
        public Membrane(long nu, long nv, long components, Precision precision = Precision.Float64,
            AllocatorCallbacks allocator = null)
        {
            void* allocatorStruct = allocator == null ? null : allocator.Struct();
            IntPtr made;
            Native.CheckVersion();
            int status;
            try
            {
                status = Native.cd_membrane_create(Native.Size(nu, "cd_membrane_create", "nu"), Native.Size(nv,
                    "cd_membrane_create", "nv"), Native.Size(components, "cd_membrane_create", "components"),
                    (int)precision, allocatorStruct, &made);
            }
            catch (EntryPointNotFoundException)
            {
                throw Native.LeftOut("cd_membrane_create");
            }
            Native.Check(status, allocator);
            Own(new MembraneHandle(made));
            Handle.Keep("allocator", allocator);
        }

        private static readonly Dictionary<Field, FieldRow> rows = new Dictionary<Field, FieldRow>
        {
            { Field.Position, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, true, false) },
            { Field.Velocity, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, true, false) },
            { Field.Force, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, true, false) },
            { Field.Target, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, true, false) },
            { Field.Mass, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, false, false) },
            { Field.StiffnessU, new FieldRow(new[] { 1, 0, 1, 2, 1, 0 }, false, false) },
            { Field.StiffnessV, new FieldRow(new[] { 1, 1, 0, 2, 0, 2 }, false, false) },
            { Field.Pin, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, false, false) },
            { Field.Mask, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, false, false) },
            { Field.RestLengthU, new FieldRow(new[] { 1, 0, 1, 2, 1, 0 }, false, false) },
            { Field.RestLengthV, new FieldRow(new[] { 1, 1, 0, 2, 0, 2 }, false, false) },
            { Field.BreakingStrainU, new FieldRow(new[] { 1, 0, 1, 2, 1, 0 }, false, false) },
            { Field.BreakingStrainV, new FieldRow(new[] { 1, 1, 0, 2, 0, 2 }, false, false) },
            { Field.Wind, new FieldRow(new[] { 1, 1, 0, 2, 1, 0 }, true, false) },
            { Field.TensionU, new FieldRow(new[] { 1, 0, 1, 2, 1, 0 }, false, false) },
            { Field.TensionV, new FieldRow(new[] { 1, 1, 0, 2, 0, 2 }, false, false) },
            { Field.StrainU, new FieldRow(new[] { 1, 0, 1, 2, 1, 0 }, false, false) },
            { Field.StrainV, new FieldRow(new[] { 1, 1, 0, 2, 0, 2 }, false, false) },
        };

        internal override Whole Extents(Field field)
        {
            FieldRow row;
            if (!rows.TryGetValue(field, out row)) return new Whole();
            var shape = GetShape();
            return new Whole(row, new[] { shape.Nu, shape.Nv }, new[] { GetRing().AlongU, GetRing().AlongV }, false,
                shape.Components);
        }

        internal override Precision Stored { get { return GetShape().Precision; } }

        internal override void ReadWhole(Field field, Whole whole, float* outValues, long count)
        {
            var range = whole.Range(false);
            ReadF32Core(field, range[0], range[1], range[2], range[3], outValues, count);
        }

        internal override void ReadWhole(Field field, Whole whole, double* outValues, long count)
        {
            var range = whole.Range(false);
            ReadF64Core(field, range[0], range[1], range[2], range[3], outValues, count);
        }

        internal override void WriteWhole(Field field, Whole whole, float* values, long count)
        {
            var range = whole.Range(false);
            WriteF32Core(field, range[0], range[1], range[2], range[3], values, count);
        }

        internal override void WriteWhole(Field field, Whole whole, double* values, long count)
        {
            var range = whole.Range(false);
            WriteF64Core(field, range[0], range[1], range[2], range[3], values, count);
        }

        /// <summary>What cd_membrane_create was given. Each output may be null.</summary>
        public MembraneShape GetShape()
        {
            UIntPtr outNu;
            UIntPtr outNv;
            UIntPtr outComponents;
            int outPrecision;
            Check(Native.cd_membrane_get_shape(Handle, &outNu, &outNv, &outComponents, &outPrecision));
            return new MembraneShape((long)outNu, (long)outNv, (long)outComponents, (Precision)outPrecision);
        }

        /// <summary>How steps are made. Methods and solvers differ in the memory they need. Errors: CD_ERROR_ENUM;
        /// CD_ERROR_MEMORY.</summary>
        public Method Method
        {
            get
            {
                int outMethod;
                Check(Native.cd_membrane_get_method(Handle, &outMethod));
                return (Method)outMethod;
            }
            set
            {
                var method = value;
                Changed();
                Check(Native.cd_membrane_set_method(Handle, (int)method));
            }
        }

        /// <summary>lambda of CD_METHOD_IMPLICIT, in [0, 1]; default 1/2. Errors: CD_ERROR_VALUE.</summary>
        public double Lambda
        {
            get
            {
                double outLambda;
                Check(Native.cd_membrane_get_lambda(Handle, &outLambda));
                return outLambda;
            }
            set
            {
                var lambda = value;
                Changed();
                Check(Native.cd_membrane_set_lambda(Handle, lambda));
            }
        }

        /// <summary>How implicit steps solve their system; see above. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.</summary>
        public Solver Solver
        {
            get
            {
                int outSolver;
                Check(Native.cd_membrane_get_solver(Handle, &outSolver));
                return (Solver)outSolver;
            }
            set
            {
                var solver = value;
                Changed();
                Check(Native.cd_membrane_set_solver(Handle, (int)solver));
            }
        }

        /// <summary>Which of the two the last step took that found it awake; CD_SOLVER_AUTO: neither. Not part of the
        /// saved state.</summary>
        public Solver GetSolverTaken()
        {
            int outSolver;
            Check(Native.cd_membrane_get_solver_taken(Handle, &outSolver));
            return (Solver)outSolver;
        }

        /// <summary>When CD_SOLVER_COUPLED is content: a residual of `tolerance` times the one it starts from, in
        /// [1e-14, 1/2], default 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal
        /// entry of the system. It may take most_iterations, &gt;= 1, default 100, and ends when 500 have not halved
        /// the residual, which rounding may keep from falling. cd_membrane_step says CD_ERROR_TOLERANCE where it ends
        /// short of the tolerance. Errors: CD_ERROR_VALUE.</summary>
        public void SetTolerance(double tolerance, long mostIterations)
        {
            Changed();
            Check(Native.cd_membrane_set_tolerance(Handle, tolerance, Native.Size(mostIterations,
                "cd_membrane_set_tolerance", "most_iterations")));
        }

        /// <summary>When CD_SOLVER_COUPLED is content: a residual of `tolerance` times the one it starts from, in
        /// [1e-14, 1/2], default 1e-6. Each component's is the Euclidean norm of its nodes', each over its diagonal
        /// entry of the system. It may take most_iterations, &gt;= 1, default 100, and ends when 500 have not halved
        /// the residual, which rounding may keep from falling. cd_membrane_step says CD_ERROR_TOLERANCE where it ends
        /// short of the tolerance. Errors: CD_ERROR_VALUE.</summary>
        public MembraneTolerance GetTolerance()
        {
            double outTolerance;
            UIntPtr outMostIterations;
            Check(Native.cd_membrane_get_tolerance(Handle, &outTolerance, &outMostIterations));
            return new MembraneTolerance(outTolerance, (long)outMostIterations);
        }

        /// <summary>What the last call of cd_membrane_step did when it took CD_SOLVER_COUPLED: the most iterations that
        /// a solve needed, and the largest residual it ended with, as a fraction of the one it started from: INFINITY
        /// where its square is. 0 and 0 if there was no such solve. Soft motions beside stiff ones may be off by more.
        /// Each output may be null.</summary>
        public MembraneConvergence GetConvergence()
        {
            UIntPtr outIterations;
            double outResidual;
            Check(Native.cd_membrane_get_convergence(Handle, &outIterations, &outResidual));
            return new MembraneConvergence((long)outIterations, outResidual);
        }

        /// <summary>Spreads a step over the caller's threads. Null turns it off. Errors: CD_ERROR_NULL for a table
        /// without run.</summary>
        public void SetParallel(ParallelCallbacks parallel)
        {
            void* parallelStruct = parallel == null ? null : parallel.Struct();
            Changed();
            Check(Native.cd_membrane_set_parallel(Handle, parallelStruct));
            Handle.Keep("parallel", parallel);
        }

        /// <summary>The instructions that steps are made of, as cd_chain_set_kernels says. Not part of the saved state.
        /// Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.</summary>
        public Kernels Kernels
        {
            get
            {
                int outKernels;
                Check(Native.cd_membrane_get_kernels(Handle, &outKernels));
                return (Kernels)outKernels;
            }
            set
            {
                var kernels = value;
                Changed();
                Check(Native.cd_membrane_set_kernels(Handle, (int)kernels));
            }
        }

        /// <summary>Mass [kg], &gt; 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge
        /// line counts half, in its masses and in the springs and bends along it: mass / (nu nv) per node inside, half
        /// of it on an edge, a quarter at a corner. In a direction that is a ring or has no spring the rules agree, and
        /// in what follows its nu + 1 and nu (or nv + 1 and nv) are both the number of its nodes. The rule deals out
        /// mass and stiffness anew.</summary>
        public double Mass
        {
            get
            {
                double outMass;
                Check(Native.cd_membrane_get_mass(Handle, &outMass));
                return outMass;
            }
            set
            {
                var mass = value;
                Changed();
                Check(Native.cd_membrane_set_mass(Handle, mass));
            }
        }

        /// <summary>Mass [kg], &gt; 0. CD_MASS_EQUAL: mass / ((nu + 1) (nv + 1)) per node. CD_MASS_HALF_ENDS: an edge
        /// line counts half, in its masses and in the springs and bends along it: mass / (nu nv) per node inside, half
        /// of it on an edge, a quarter at a corner. In a direction that is a ring or has no spring the rules agree, and
        /// in what follows its nu + 1 and nu (or nv + 1 and nv) are both the number of its nodes. The rule deals out
        /// mass and stiffness anew.</summary>
        public MassRule MassRule
        {
            get
            {
                int outRule;
                Check(Native.cd_membrane_get_mass_rule(Handle, &outRule));
                return (MassRule)outRule;
            }
            set
            {
                var rule = value;
                Changed();
                Check(Native.cd_membrane_set_mass_rule(Handle, (int)rule));
            }
        }

        /// <summary>Stretch stiffness along u and along v [N/m], &gt;= 0: a sheet stretched evenly along u by the
        /// length d holds the energy k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and
        /// half of it along the edges; along v likewise. Waves run across the sheet along u in sqrt(mass / k_u)
        /// seconds. A sheet of 1 component has no size of its own: with the sides L_u and L_v under the tension S [N/m]
        /// k_u = S L_v / L_u and k_v = S L_u / L_v, a square one S.</summary>
        public void SetStiffness(double alongU, double alongV)
        {
            Changed();
            Check(Native.cd_membrane_set_stiffness(Handle, alongU, alongV));
        }

        /// <summary>Stretch stiffness along u and along v [N/m], &gt;= 0: a sheet stretched evenly along u by the
        /// length d holds the energy k_u d^2 / 2. Per spring along u: nu k_u / (nv + 1), half edges: nu k_u / nv and
        /// half of it along the edges; along v likewise. Waves run across the sheet along u in sqrt(mass / k_u)
        /// seconds. A sheet of 1 component has no size of its own: with the sides L_u and L_v under the tension S [N/m]
        /// k_u = S L_v / L_u and k_v = S L_u / L_v, a square one S.</summary>
        public MembraneStiffness GetStiffness()
        {
            double outAlongU;
            double outAlongV;
            Check(Native.cd_membrane_get_stiffness(Handle, &outAlongU, &outAlongV));
            return new MembraneStiffness(outAlongU, outAlongV);
        }

        /// <summary>Bend stiffness b [N/m], &gt;= 0, of E = b/2 times the integral of |x_uu|^2 + 2 |x_uv|^2 + |x_vv|^2
        /// over the unit square of u and v. Per node with two neighbours along u: b nu^3 / (nv + 1), half edges: b nu^3
        /// / nv and half of it along the edges; along v likewise; per cell, on the squared twist: twice their geometric
        /// mean. A square plate of side L with b = D / L^2 has the flexural rigidity D [N m]; one of L_u by L_v has b
        /// L_u^3 / L_v along u, b L_v^3 / L_u along v and b L_u L_v in twist. Cut springs do not cut it, but CD_MASK.
        /// Errors: CD_ERROR_MEMORY when bend is switched on.</summary>
        public double Bend
        {
            get
            {
                double outBend;
                Check(Native.cd_membrane_get_bend(Handle, &outBend));
                return outBend;
            }
            set
            {
                var bend = value;
                Changed();
                Check(Native.cd_membrane_set_bend(Handle, bend));
            }
        }

        /// <summary>Drag [1/s], &gt;= 0: every node loses velocity at this rate.</summary>
        public double Drag
        {
            get
            {
                double outDrag;
                Check(Native.cd_membrane_get_drag(Handle, &outDrag));
                return outDrag;
            }
            set
            {
                var drag = value;
                Changed();
                Check(Native.cd_membrane_set_drag(Handle, drag));
            }
        }

        /// <summary>Stiffness damping [s], &gt;= 0: stretch and bend damp at this time constant; a mode of angular
        /// frequency w loses amplitude at the rate (drag + stiffness_damping w^2) / 2. Cloth takes none.</summary>
        public double StiffnessDamping
        {
            get
            {
                double outSeconds;
                Check(Native.cd_membrane_get_stiffness_damping(Handle, &outSeconds));
                return outSeconds;
            }
            set
            {
                var seconds = value;
                Changed();
                Check(Native.cd_membrane_set_stiffness_damping(Handle, seconds));
            }
        }

        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void SetGravity(params double[] gravity)
        {
            fixed (double* gravityPointer = gravity)
                SetGravityCore(gravityPointer, Native.Length(gravity));
        }

#if CONTDYN_SPANS
        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void SetGravity(ReadOnlySpan<double> gravity)
        {
            fixed (double* gravityPointer = &MemoryMarshal.GetReference(gravity))
                SetGravityCore(gravity.Length == 0 ? null : gravityPointer, gravity.Length);
        }

#endif
        private void SetGravityCore(double* gravity, long gravityLength)
        {
            long count = Native.Count(gravityLength, 1, "cd_membrane_set_gravity", "gravity");
            Changed();
            Check(Native.cd_membrane_set_gravity(Handle, gravity, Native.Size(count, "cd_membrane_set_gravity",
                "count")));
        }

        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void GetGravity(double[] outGravity)
        {
            fixed (double* outGravityPointer = outGravity)
                GetGravityCore(outGravityPointer, Native.Length(outGravity));
        }

#if CONTDYN_SPANS
        /// <summary>Gravity [m/s^2], one number per component, at most 1e60 in size, in CD_FLOAT32 1e30. Errors:
        /// CD_ERROR_RANGE if count is not the number of components.</summary>
        public void GetGravity(Span<double> outGravity)
        {
            fixed (double* outGravityPointer = &MemoryMarshal.GetReference(outGravity))
                GetGravityCore(outGravity.Length == 0 ? null : outGravityPointer, outGravity.Length);
        }

#endif
        private void GetGravityCore(double* outGravity, long outGravityLength)
        {
            long count = Native.Count(outGravityLength, 1, "cd_membrane_get_gravity", "out_gravity");
            Check(Native.cd_membrane_get_gravity(Handle, outGravity, Native.Size(count, "cd_membrane_get_gravity",
                "count")));
        }

        /// <summary>Pressure [Pa] on the sheet along its normal x_u x x_v, of either sign, at most 1e60 in size: the
        /// force on a node is pressure times the gradient of the volume under the sheet, at an edge its part of the
        /// cells' areas, at the positions a step starts from. It grows with the sheet, beyond some half of stiffness /
        /// side without end. 3 components only; costs memory while not 0. Errors: CD_ERROR_UNSUPPORTED for other
        /// components unless 0; CD_ERROR_MEMORY.</summary>
        public double Pressure
        {
            get
            {
                double outPressure;
                Check(Native.cd_membrane_get_pressure(Handle, &outPressure));
                return outPressure;
            }
            set
            {
                var pressure = value;
                Changed();
                Check(Native.cd_membrane_set_pressure(Handle, pressure));
            }
        }

        /// <summary>What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either
        /// is. Pinning stops the nodes; driving leaves their velocity, which is then written through CD_VELOCITY;
        /// posing switches CD_TARGET on and sets the edge's targets to where it is: write the next ones there.
        /// CD_NODE_MATCHED leaves the edge free, with the impedance that sends no echo back to a wave that runs
        /// straight at it. Where CD_PIN is switched on, all but matched are written to it along the edge. The getter
        /// tells what was set last, whatever was written to CD_PIN since. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED
        /// for CD_NODE_MATCHED in the direction of a ring; CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_NODE_POSED where
        /// the state is not finite.</summary>
        public void SetEdge(Edge edge, Node kind)
        {
            Changed();
            Check(Native.cd_membrane_set_edge(Handle, (int)edge, (int)kind));
        }

        /// <summary>What holds an edge; a corner is pinned if either of its edges is, else driven, else posed if either
        /// is. Pinning stops the nodes; driving leaves their velocity, which is then written through CD_VELOCITY;
        /// posing switches CD_TARGET on and sets the edge's targets to where it is: write the next ones there.
        /// CD_NODE_MATCHED leaves the edge free, with the impedance that sends no echo back to a wave that runs
        /// straight at it. Where CD_PIN is switched on, all but matched are written to it along the edge. The getter
        /// tells what was set last, whatever was written to CD_PIN since. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED
        /// for CD_NODE_MATCHED in the direction of a ring; CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_NODE_POSED where
        /// the state is not finite.</summary>
        public Node GetEdge(Edge edge)
        {
            int outKind;
            Check(Native.cd_membrane_get_edge(Handle, (int)edge, &outKind));
            return (Node)outKind;
        }

        /// <summary>Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out
        /// anew, and fields of masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors:
        /// CD_ERROR_VALUE for anything but 0 and 1; CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched edge;
        /// CD_ERROR_MEMORY.</summary>
        public void SetRing(bool alongU, bool alongV)
        {
            Changed();
            Check(Native.cd_membrane_set_ring(Handle, alongU ? 1 : 0, alongV ? 1 : 0));
        }

        /// <summary>Joins the last nodes along u (along v) to the first (1), or opens them (0). Totals are dealt out
        /// anew, and fields of masses and stiffnesses get the uniform values. A ring needs 3 nodes. Errors:
        /// CD_ERROR_VALUE for anything but 0 and 1; CD_ERROR_UNSUPPORTED with fewer than 3 nodes or a matched edge;
        /// CD_ERROR_MEMORY.</summary>
        public MembraneRing GetRing()
        {
            int outAlongU;
            int outAlongV;
            Check(Native.cd_membrane_get_ring(Handle, &outAlongU, &outAlongV));
            return new MembraneRing(outAlongU != 0, outAlongV != 0);
        }

        /// <summary>Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some
        /// `seconds` [s], in [1e-30, 1e60]: as cd_chain_set_sleep says; the effort wakes nothing. Errors:
        /// CD_ERROR_VALUE; CD_ERROR_MEMORY.</summary>
        public void SetSleep(double speed, double seconds)
        {
            Changed();
            Check(Native.cd_membrane_set_sleep(Handle, speed, seconds));
        }

        /// <summary>Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some
        /// `seconds` [s], in [1e-30, 1e60]: as cd_chain_set_sleep says; the effort wakes nothing. Errors:
        /// CD_ERROR_VALUE; CD_ERROR_MEMORY.</summary>
        public MembraneSleep GetSleep()
        {
            double outSpeed;
            double outSeconds;
            Check(Native.cd_membrane_get_sleep(Handle, &outSpeed, &outSeconds));
            return new MembraneSleep(outSpeed, outSeconds);
        }

        /// <summary>Lets a sheet sleep, as a whole, once it has been slower than `speed` [m/s], in [0, 1e60], for some
        /// `seconds` [s], in [1e-30, 1e60]: as cd_chain_set_sleep says; the effort wakes nothing. Errors:
        /// CD_ERROR_VALUE; CD_ERROR_MEMORY.</summary>
        public long GetAwake()
        {
            UIntPtr outNodes;
            Check(Native.cd_membrane_get_awake(Handle, &outNodes));
            return (long)outNodes;
        }

        /// <summary>Rest lengths of the sheet along u and along v [m], 0 or in [1e-60, 1e60]; default 0: no cloth. Both
        /// are 0 or neither is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making
        /// cloth of a membrane sets lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air,
        /// wind and colliders too. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED without 3 components
        /// and springs along both directions.</summary>
        public void SetRestLength(double alongU, double alongV)
        {
            Changed();
            Check(Native.cd_membrane_set_rest_length(Handle, alongU, alongV));
        }

        /// <summary>Rest lengths of the sheet along u and along v [m], 0 or in [1e-60, 1e60]; default 0: no cloth. Both
        /// are 0 or neither is. Per spring: length / springs, in a ring as well; nodes stay where they are. Making
        /// cloth of a membrane sets lambda to 1. Length 0 switches the fields of cloth off, and breaking strain, air,
        /// wind and colliders too. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED without 3 components
        /// and springs along both directions.</summary>
        public MembraneRestLength GetRestLength()
        {
            double outAlongU;
            double outAlongV;
            Check(Native.cd_membrane_get_rest_length(Handle, &outAlongU, &outAlongV));
            return new MembraneRestLength(outAlongU, outAlongV);
        }

        /// <summary>Shear stiffness [N/m], &gt;= 0, default 0, of a spring along each diagonal of every cell, with the
        /// law and the mean rest lengths of the cell's springs. Of square cells the shear modulus is half of it [N/m].
        /// Errors here and below: CD_ERROR_VALUE; CD_ERROR_UNSUPPORTED of a membrane that is no cloth.</summary>
        public double Shear
        {
            get
            {
                double outStiffness;
                Check(Native.cd_membrane_get_shear(Handle, &outStiffness));
                return outStiffness;
            }
            set
            {
                var stiffness = value;
                Changed();
                Check(Native.cd_membrane_set_shear(Handle, stiffness));
            }
        }

        /// <summary>What keeps cloth from crumpling: springs along u and v that are shorter than their length push by c
        /// (L - l), longer ones pull by as much, c dealt out as a stiffness of mass * rate. rate [1/s^2] &gt;= 0,
        /// default 80: flags of a metre wave in winds up to 12 m/s with 0.4% folded sharply at most; smaller ones want
        /// more. It damps folds from node to node.</summary>
        public double Compression
        {
            get
            {
                double outRate;
                Check(Native.cd_membrane_get_compression(Handle, &outRate));
                return outRate;
            }
            set
            {
                var rate = value;
                Changed();
                Check(Native.cd_membrane_set_compression(Handle, rate));
            }
        }

        /// <summary>The strain, length over rest length less 1, at which a spring tears, whatever its stiffness: 1e-60
        /// to 1e60, or INFINITY, the default: springs hold. The fields CD_BREAKING_STRAIN_U and _V have one for each
        /// spring: a seam is a line of springs that tear at less. A step ends by cutting springs beyond their breaking
        /// strains, in each row and each column of springs at most one. First goes the spring whose strain is the
        /// largest multiple of its breaking strain; then its neighbour in the next row, and so on from row to row,
        /// while that is beyond its breaking strain too; then the same in the rows that are left. So tears go on from
        /// their ends, and jerked cloth parts without falling to pieces. A cut spring's stiffness becomes 0, and adds
        /// no energy. Mend it by writing CD_STIFFNESS_U or _V, which finite breaking strains switch on and keep on. A
        /// cell of cloth that lacks two or more springs is open: it is not drawn, it has no volume, and air and
        /// pressure go through it. Errors: CD_ERROR_MEMORY too.</summary>
        public double BreakingStrain
        {
            get
            {
                double outStrain;
                Check(Native.cd_membrane_get_breaking_strain(Handle, &outStrain));
                return outStrain;
            }
            set
            {
                var strain = value;
                Changed();
                Check(Native.cd_membrane_set_breaking_strain(Handle, strain));
            }
        }

        /// <summary>How many springs tore in the last call of cd_membrane_step that made steps: those whose stiffness
        /// became 0. Where there are any, cd_membrane_write_indices may write other triangles than before.</summary>
        public long GetBroken()
        {
            UIntPtr outSprings;
            Check(Native.cd_membrane_get_broken(Handle, &outSprings));
            return (long)outSprings;
        }

        /// <summary>How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each
        /// those of conjugate gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of
        /// the energy that all brought. Up to 4 more of Newton's are made where it gains little, with gradient 0 also
        /// where it still gains much. After a step get_convergence tells the most of conjugate gradients that a step
        /// took, and what gradient was left over the first.</summary>
        public void SetEffort(long newton, long gradient)
        {
            Changed();
            Check(Native.cd_membrane_set_effort(Handle, Native.Size(newton, "cd_membrane_set_effort", "newton"),
                Native.Size(gradient, "cd_membrane_set_effort", "gradient")));
        }

        /// <summary>How much a step may do: iterations of Newton's method, `newton`, 1 to 1000, default 3, and in each
        /// those of conjugate gradients, `gradient`, 1 to 10000, or 0, the default: until four bring less than 3% of
        /// the energy that all brought. Up to 4 more of Newton's are made where it gains little, with gradient 0 also
        /// where it still gains much. After a step get_convergence tells the most of conjugate gradients that a step
        /// took, and what gradient was left over the first.</summary>
        public MembraneEffort GetEffort()
        {
            UIntPtr outNewton;
            UIntPtr outGradient;
            Check(Native.cd_membrane_get_effort(Handle, &outNewton, &outGradient));
            return new MembraneEffort((long)outNewton, (long)outGradient);
        }

        /// <summary>Resistance of the air, per area of cloth [N s/m^3], in [0, 1e60], default 0: a piece of area a
        /// whose velocity through the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t +
        /// across w_n). Implicit, so that it only takes energy, as seen from the air, at any dt; areas and directions
        /// are those that the step starts from. Air of density 1.2 kg/m^3 that passes at the speed s has about across =
        /// 1.2 s and along = 0.02 s. A node on an edge bears half the air: with CD_MASS_EQUAL, where it has the whole
        /// mass, a flat sheet folds as it falls; with CD_MASS_HALF_ENDS it falls flat. Errors: CD_ERROR_MEMORY
        /// too.</summary>
        public void SetAir(double along, double across)
        {
            Changed();
            Check(Native.cd_membrane_set_air(Handle, along, across));
        }

        /// <summary>Resistance of the air, per area of cloth [N s/m^3], in [0, 1e60], default 0: a piece of area a
        /// whose velocity through the air is w, w_t along the cloth and w_n across it, is pushed by -a (along w_t +
        /// across w_n). Implicit, so that it only takes energy, as seen from the air, at any dt; areas and directions
        /// are those that the step starts from. Air of density 1.2 kg/m^3 that passes at the speed s has about across =
        /// 1.2 s and along = 0.02 s. A node on an edge bears half the air: with CD_MASS_EQUAL, where it has the whole
        /// mass, a flat sheet folds as it falls; with CD_MASS_HALF_ENDS it falls flat. Errors: CD_ERROR_MEMORY
        /// too.</summary>
        public MembraneAir GetAir()
        {
            double outAlong;
            double outAcross;
            Check(Native.cd_membrane_get_air(Handle, &outAlong, &outAcross));
            return new MembraneAir(outAlong, outAcross);
        }

        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_RANGE too, if count is not the number of components.</summary>
        public void SetWind(params double[] velocity)
        {
            fixed (double* velocityPointer = velocity)
                SetWindCore(velocityPointer, Native.Length(velocity));
        }

#if CONTDYN_SPANS
        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_RANGE too, if count is not the number of components.</summary>
        public void SetWind(ReadOnlySpan<double> velocity)
        {
            fixed (double* velocityPointer = &MemoryMarshal.GetReference(velocity))
                SetWindCore(velocity.Length == 0 ? null : velocityPointer, velocity.Length);
        }

#endif
        private void SetWindCore(double* velocity, long velocityLength)
        {
            long count = Native.Count(velocityLength, 1, "cd_membrane_set_wind", "velocity");
            Changed();
            Check(Native.cd_membrane_set_wind(Handle, velocity, Native.Size(count, "cd_membrane_set_wind", "count")));
        }

        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_RANGE too, if count is not the number of components.</summary>
        public void GetWind(double[] outVelocity)
        {
            fixed (double* outVelocityPointer = outVelocity)
                GetWindCore(outVelocityPointer, Native.Length(outVelocity));
        }

#if CONTDYN_SPANS
        /// <summary>Velocity of that air [m/s], one number per component, default 0; the field CD_WIND has one for each
        /// node. Errors: CD_ERROR_RANGE too, if count is not the number of components.</summary>
        public void GetWind(Span<double> outVelocity)
        {
            fixed (double* outVelocityPointer = &MemoryMarshal.GetReference(outVelocity))
                GetWindCore(outVelocity.Length == 0 ? null : outVelocityPointer, outVelocity.Length);
        }

#endif
        private void GetWindCore(double* outVelocity, long outVelocityLength)
        {
            long count = Native.Count(outVelocityLength, 1, "cd_membrane_get_wind", "out_velocity");
            Check(Native.cd_membrane_get_wind(Handle, outVelocity, Native.Size(count, "cd_membrane_get_wind",
                "count")));
        }

        /// <summary>As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and
        /// capsules, spheres among them, beds and callbacks, each with velocity and friction of its own. In a step a
        /// node meets the three that it would be deepest in, or nearest to, at its velocity, as the planes that touch
        /// them where the step begins: it goes through none of them, however fast. Nodes collide; what lies between
        /// them does not, nor does cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass),
        /// some 1e-3 m where a sheet lands at 50 m/s; with the default effort nodes are now and then deeper, by up to
        /// 7e-3 m in steps that move them by 0.1 m. What lies inside comes out, and what that lifts or stretches gains
        /// energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the
        /// push that the step's iterations find. With the default effort, what begins to slide is up to a quarter too
        /// slow in its first half second. What friction holds creeps, at half of the largest force that it can hold by
        /// 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a
        /// node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
        /// callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
        /// CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of
        /// the functions of cd_chain.</summary>
        public long Colliders
        {
            get
            {
                UIntPtr outCount;
                Check(Native.cd_membrane_get_colliders(Handle, &outCount));
                return (long)outCount;
            }
            set
            {
                var count = value;
                Changed();
                Check(Native.cd_membrane_set_colliders(Handle, Native.Size(count, "cd_membrane_set_colliders",
                    "count")));
            }
        }

        /// <summary>As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and
        /// capsules, spheres among them, beds and callbacks, each with velocity and friction of its own. In a step a
        /// node meets the three that it would be deepest in, or nearest to, at its velocity, as the planes that touch
        /// them where the step begins: it goes through none of them, however fast. Nodes collide; what lies between
        /// them does not, nor does cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass),
        /// some 1e-3 m where a sheet lands at 50 m/s; with the default effort nodes are now and then deeper, by up to
        /// 7e-3 m in steps that move them by 0.1 m. What lies inside comes out, and what that lifts or stretches gains
        /// energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the
        /// push that the step's iterations find. With the default effort, what begins to slide is up to a quarter too
        /// slow in its first half second. What friction holds creeps, at half of the largest force that it can hold by
        /// 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a
        /// node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
        /// callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
        /// CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of
        /// the functions of cd_chain.</summary>
        public void SetPlane(long index, double[] point, double[] normal, double friction)
        {
            fixed (double* pointPointer = point)
            fixed (double* normalPointer = normal)
                SetPlaneCore(index, pointPointer, Native.Length(point), normalPointer, Native.Length(normal), friction);
        }

#if CONTDYN_SPANS
        /// <summary>As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and
        /// capsules, spheres among them, beds and callbacks, each with velocity and friction of its own. In a step a
        /// node meets the three that it would be deepest in, or nearest to, at its velocity, as the planes that touch
        /// them where the step begins: it goes through none of them, however fast. Nodes collide; what lies between
        /// them does not, nor does cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass),
        /// some 1e-3 m where a sheet lands at 50 m/s; with the default effort nodes are now and then deeper, by up to
        /// 7e-3 m in steps that move them by 0.1 m. What lies inside comes out, and what that lifts or stretches gains
        /// energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the
        /// push that the step's iterations find. With the default effort, what begins to slide is up to a quarter too
        /// slow in its first half second. What friction holds creeps, at half of the largest force that it can hold by
        /// 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a
        /// node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
        /// callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
        /// CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of
        /// the functions of cd_chain.</summary>
        public void SetPlane(long index, ReadOnlySpan<double> point, ReadOnlySpan<double> normal, double friction)
        {
            fixed (double* pointPointer = &MemoryMarshal.GetReference(point))
            fixed (double* normalPointer = &MemoryMarshal.GetReference(normal))
                SetPlaneCore(index, point.Length == 0 ? null : pointPointer, point.Length,
                    normal.Length == 0 ? null : normalPointer, normal.Length, friction);
        }

#endif
        private void SetPlaneCore(long index, double* point, long pointLength, double* normal, long normalLength,
            double friction)
        {
            long count = Native.Count(pointLength, 1, "cd_membrane_set_plane", "point");
            Native.Same(normal, normalLength, count, "cd_membrane_set_plane", "normal");
            Changed();
            Check(Native.cd_membrane_set_plane(Handle, Native.Size(index, "cd_membrane_set_plane", "index"), point,
                normal, Native.Size(count, "cd_membrane_set_plane", "count"), friction));
        }

        /// <summary>As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and
        /// capsules, spheres among them, beds and callbacks, each with velocity and friction of its own. In a step a
        /// node meets the three that it would be deepest in, or nearest to, at its velocity, as the planes that touch
        /// them where the step begins: it goes through none of them, however fast. Nodes collide; what lies between
        /// them does not, nor does cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass),
        /// some 1e-3 m where a sheet lands at 50 m/s; with the default effort nodes are now and then deeper, by up to
        /// 7e-3 m in steps that move them by 0.1 m. What lies inside comes out, and what that lifts or stretches gains
        /// energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the
        /// push that the step's iterations find. With the default effort, what begins to slide is up to a quarter too
        /// slow in its first half second. What friction holds creeps, at half of the largest force that it can hold by
        /// 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a
        /// node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
        /// callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
        /// CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of
        /// the functions of cd_chain.</summary>
        public void SetCapsule(long index, double[] first, double[] last, double radius, double friction)
        {
            fixed (double* firstPointer = first)
            fixed (double* lastPointer = last)
                SetCapsuleCore(index, firstPointer, Native.Length(first), lastPointer, Native.Length(last), radius,
                    friction);
        }

#if CONTDYN_SPANS
        /// <summary>As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and
        /// capsules, spheres among them, beds and callbacks, each with velocity and friction of its own. In a step a
        /// node meets the three that it would be deepest in, or nearest to, at its velocity, as the planes that touch
        /// them where the step begins: it goes through none of them, however fast. Nodes collide; what lies between
        /// them does not, nor does cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass),
        /// some 1e-3 m where a sheet lands at 50 m/s; with the default effort nodes are now and then deeper, by up to
        /// 7e-3 m in steps that move them by 0.1 m. What lies inside comes out, and what that lifts or stretches gains
        /// energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the
        /// push that the step's iterations find. With the default effort, what begins to slide is up to a quarter too
        /// slow in its first half second. What friction holds creeps, at half of the largest force that it can hold by
        /// 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a
        /// node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
        /// callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
        /// CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of
        /// the functions of cd_chain.</summary>
        public void SetCapsule(long index, ReadOnlySpan<double> first, ReadOnlySpan<double> last, double radius,
            double friction)
        {
            fixed (double* firstPointer = &MemoryMarshal.GetReference(first))
            fixed (double* lastPointer = &MemoryMarshal.GetReference(last))
                SetCapsuleCore(index, first.Length == 0 ? null : firstPointer, first.Length,
                    last.Length == 0 ? null : lastPointer, last.Length, radius, friction);
        }

#endif
        private void SetCapsuleCore(long index, double* first, long firstLength, double* last, long lastLength,
            double radius, double friction)
        {
            long count = Native.Count(firstLength, 1, "cd_membrane_set_capsule", "first");
            Native.Same(last, lastLength, count, "cd_membrane_set_capsule", "last");
            Changed();
            Check(Native.cd_membrane_set_capsule(Handle, Native.Size(index, "cd_membrane_set_capsule", "index"), first,
                last, Native.Size(count, "cd_membrane_set_capsule", "count"), radius, friction));
        }

        /// <summary>As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and
        /// capsules, spheres among them, beds and callbacks, each with velocity and friction of its own. In a step a
        /// node meets the three that it would be deepest in, or nearest to, at its velocity, as the planes that touch
        /// them where the step begins: it goes through none of them, however fast. Nodes collide; what lies between
        /// them does not, nor does cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass),
        /// some 1e-3 m where a sheet lands at 50 m/s; with the default effort nodes are now and then deeper, by up to
        /// 7e-3 m in steps that move them by 0.1 m. What lies inside comes out, and what that lifts or stretches gains
        /// energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the
        /// push that the step's iterations find. With the default effort, what begins to slide is up to a quarter too
        /// slow in its first half second. What friction holds creeps, at half of the largest force that it can hold by
        /// 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a
        /// node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
        /// callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
        /// CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of
        /// the functions of cd_chain.</summary>
        public void SetBed(long index, double[] origin, long columns, long rows, double columnSpacing,
            double rowSpacing, double[] heights, double friction)
        {
            fixed (double* originPointer = origin)
            fixed (double* heightsPointer = heights)
                SetBedCore(index, originPointer, Native.Length(origin), columns, rows, columnSpacing, rowSpacing,
                    heightsPointer, Native.Length(heights), friction);
        }

#if CONTDYN_SPANS
        /// <summary>As ropes do, the nodes of cloth stay outside of colliders, numbered from 0: half spaces and
        /// capsules, spheres among them, beds and callbacks, each with velocity and friction of its own. In a step a
        /// node meets the three that it would be deepest in, or nearest to, at its velocity, as the planes that touch
        /// them where the step begins: it goes through none of them, however fast. Nodes collide; what lies between
        /// them does not, nor does cloth with itself. Depth: contacts yield by a node's force times dt^2 / (1e4 mass),
        /// some 1e-3 m where a sheet lands at 50 m/s; with the default effort nodes are now and then deeper, by up to
        /// 7e-3 m in steps that move them by 0.1 m. What lies inside comes out, and what that lifts or stretches gains
        /// energy: at 1e9 N/m 1e-3 of it a step. Friction is Coulomb's, times v / (v + 1e-3 m/s) at the speed v, of the
        /// push that the step's iterations find. With the default effort, what begins to slide is up to a quarter too
        /// slow in its first half second. What friction holds creeps, at half of the largest force that it can hold by
        /// 1e-3 m/s. Beds and callbacks are those of cd_chain, met at the plane that touches them where a step finds a
        /// node: what a hollow rises above that plane a node may end inside of, and the next step takes it out. A
        /// callback is asked once a step, for all nodes; answers that it may not give make cd_membrane_step say
        /// CD_ERROR_CALLBACK, and one that is missing after a load CD_ERROR_UNSUPPORTED. Errors and ranges are those of
        /// the functions of cd_chain.</summary>
        public void SetBed(long index, ReadOnlySpan<double> origin, long columns, long rows, double columnSpacing,
            double rowSpacing, ReadOnlySpan<double> heights, double friction)
        {
            fixed (double* originPointer = &MemoryMarshal.GetReference(origin))
            fixed (double* heightsPointer = &MemoryMarshal.GetReference(heights))
                SetBedCore(index, origin.Length == 0 ? null : originPointer, origin.Length, columns, rows,
                    columnSpacing, rowSpacing, heights.Length == 0 ? null : heightsPointer, heights.Length, friction);
        }

#endif
        private void SetBedCore(long index, double* origin, long originLength, long columns, long rows,
            double columnSpacing, double rowSpacing, double* heights, long heightsLength, double friction)
        {
            long count = Native.Count(originLength, 1, "cd_membrane_set_bed", "origin");
            long heightCount = Native.Count(heightsLength, 1, "cd_membrane_set_bed", "heights");
            Changed();
            Check(Native.cd_membrane_set_bed(Handle, Native.Size(index, "cd_membrane_set_bed", "index"), origin,
                Native.Size(count, "cd_membrane_set_bed", "count"), Native.Size(columns, "cd_membrane_set_bed",
                "columns"), Native.Size(rows, "cd_membrane_set_bed", "rows"), columnSpacing, rowSpacing, heights,
                Native.Size(heightCount, "cd_membrane_set_bed", "height_count"), friction));
        }

        /// <summary>Each output may be null.</summary>
        public MembraneBed GetBed(long index, double[] outHeights)
        {
            fixed (double* outHeightsPointer = outHeights)
                return GetBedCore(index, outHeightsPointer, Native.Length(outHeights));
        }

#if CONTDYN_SPANS
        /// <summary>Each output may be null.</summary>
        public MembraneBed GetBed(long index, Span<double> outHeights)
        {
            fixed (double* outHeightsPointer = &MemoryMarshal.GetReference(outHeights))
                return GetBedCore(index, outHeights.Length == 0 ? null : outHeightsPointer, outHeights.Length);
        }

#endif
        private MembraneBed GetBedCore(long index, double* outHeights, long outHeightsLength)
        {
            long heightCount = Native.Count(outHeightsLength, 1, "cd_membrane_get_bed", "out_heights");
            UIntPtr outColumns;
            UIntPtr outRows;
            Check(Native.cd_membrane_get_bed(Handle, Native.Size(index, "cd_membrane_get_bed", "index"), &outColumns,
                &outRows, outHeights, Native.Size(heightCount, "cd_membrane_get_bed", "height_count")));
            return new MembraneBed((long)outColumns, (long)outRows);
        }

        /// <summary>origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.</summary>
        public void SetCallback(long index, DistanceCallbacks distance, double[] origin, double friction)
        {
            fixed (double* originPointer = origin)
                SetCallbackCore(index, distance, originPointer, Native.Length(origin), friction);
        }

#if CONTDYN_SPANS
        /// <summary>origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.</summary>
        public void SetCallback(long index, DistanceCallbacks distance, ReadOnlySpan<double> origin, double friction)
        {
            fixed (double* originPointer = &MemoryMarshal.GetReference(origin))
                SetCallbackCore(index, distance, origin.Length == 0 ? null : originPointer, origin.Length, friction);
        }

#endif
        private void SetCallbackCore(long index, DistanceCallbacks distance, double* origin, long originLength,
            double friction)
        {
            long count = Native.Count(originLength, 1, "cd_membrane_set_callback", "origin");
            void* distanceStruct = distance == null ? null : distance.Struct();
            Changed();
            Check(Native.cd_membrane_set_callback(Handle, Native.Size(index, "cd_membrane_set_callback", "index"),
                distanceStruct, origin, Native.Size(count, "cd_membrane_set_callback", "count"), friction));
            Handle.Keep("distance" + " " + index, distance);
        }

        /// <summary>origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.</summary>
        public void RemoveCollider(long index)
        {
            Changed();
            Check(Native.cd_membrane_remove_collider(Handle, Native.Size(index, "cd_membrane_remove_collider",
                "index")));
        }

        /// <summary>origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.</summary>
        public void SetColliderVelocity(long index, params double[] velocity)
        {
            fixed (double* velocityPointer = velocity)
                SetColliderVelocityCore(index, velocityPointer, Native.Length(velocity));
        }

#if CONTDYN_SPANS
        /// <summary>origin may be null where the collider is CD_SHAPE_CALLBACK already: it stays as it is.</summary>
        public void SetColliderVelocity(long index, ReadOnlySpan<double> velocity)
        {
            fixed (double* velocityPointer = &MemoryMarshal.GetReference(velocity))
                SetColliderVelocityCore(index, velocity.Length == 0 ? null : velocityPointer, velocity.Length);
        }

#endif
        private void SetColliderVelocityCore(long index, double* velocity, long velocityLength)
        {
            long count = Native.Count(velocityLength, 1, "cd_membrane_set_collider_velocity", "velocity");
            Changed();
            Check(Native.cd_membrane_set_collider_velocity(Handle, Native.Size(index,
                "cd_membrane_set_collider_velocity", "index"), velocity, Native.Size(count,
                "cd_membrane_set_collider_velocity", "count")));
        }

        /// <summary>Each output may be null.</summary>
        public MembraneCollider GetCollider(long index, double[] outFirst, double[] outSecond, double[] outVelocity)
        {
            fixed (double* outFirstPointer = outFirst)
            fixed (double* outSecondPointer = outSecond)
            fixed (double* outVelocityPointer = outVelocity)
                return GetColliderCore(index, outFirstPointer, Native.Length(outFirst), outSecondPointer,
                    Native.Length(outSecond), outVelocityPointer, Native.Length(outVelocity));
        }

#if CONTDYN_SPANS
        /// <summary>Each output may be null.</summary>
        public MembraneCollider GetCollider(long index, Span<double> outFirst, Span<double> outSecond,
            Span<double> outVelocity)
        {
            fixed (double* outFirstPointer = &MemoryMarshal.GetReference(outFirst))
            fixed (double* outSecondPointer = &MemoryMarshal.GetReference(outSecond))
            fixed (double* outVelocityPointer = &MemoryMarshal.GetReference(outVelocity))
                return GetColliderCore(index, outFirst.Length == 0 ? null : outFirstPointer, outFirst.Length,
                    outSecond.Length == 0 ? null : outSecondPointer, outSecond.Length,
                    outVelocity.Length == 0 ? null : outVelocityPointer, outVelocity.Length);
        }

#endif
        private MembraneCollider GetColliderCore(long index, double* outFirst, long outFirstLength, double* outSecond,
            long outSecondLength, double* outVelocity, long outVelocityLength)
        {
            long count = Native.Count(Math.Max((outFirst != null ? outFirstLength : outSecondLength),
                outVelocityLength), 1, "cd_membrane_get_collider", "out_first");
            Native.Same(outSecond, outSecondLength, count, "cd_membrane_get_collider", "out_second");
            Native.Same(outVelocity, outVelocityLength, count, "cd_membrane_get_collider", "out_velocity");
            int outShape;
            double outRadius;
            double outFriction;
            Check(Native.cd_membrane_get_collider(Handle, Native.Size(index, "cd_membrane_get_collider", "index"),
                &outShape, outFirst, outSecond, outVelocity, Native.Size(count, "cd_membrane_get_collider", "count"),
                &outRadius, &outFriction));
            return new MembraneCollider((Shape)outShape, outRadius, outFriction);
        }

        /// <summary>What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node
        /// that meets one lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets
        /// the sum is right whatever the effort; of held ones as right as the step's velocities are.</summary>
        public bool Loads
        {
            get
            {
                int outLoads;
                Check(Native.cd_membrane_get_loads(Handle, &outLoads));
                return outLoads != 0;
            }
            set
            {
                var loads = value;
                Changed();
                Check(Native.cd_membrane_set_loads(Handle, loads ? 1 : 0));
            }
        }

        /// <summary>What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node
        /// that meets one lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets
        /// the sum is right whatever the effort; of held ones as right as the step's velocities are.</summary>
        public void GetColliderLoad(long index, double[] outLoad)
        {
            fixed (double* outLoadPointer = outLoad)
                GetColliderLoadCore(index, outLoadPointer, Native.Length(outLoad));
        }

#if CONTDYN_SPANS
        /// <summary>What cloth does to colliders, as cd_chain_get_collider_load says: what the momentum of each node
        /// that meets one lacks, and of a part of the sheet that nothing holds that of all its nodes. So of free sheets
        /// the sum is right whatever the effort; of held ones as right as the step's velocities are.</summary>
        public void GetColliderLoad(long index, Span<double> outLoad)
        {
            fixed (double* outLoadPointer = &MemoryMarshal.GetReference(outLoad))
                GetColliderLoadCore(index, outLoad.Length == 0 ? null : outLoadPointer, outLoad.Length);
        }

#endif
        private void GetColliderLoadCore(long index, double* outLoad, long outLoadLength)
        {
            long count = Native.Count(outLoadLength, 1, "cd_membrane_get_collider_load", "out_load");
            Check(Native.cd_membrane_get_collider_load(Handle, Native.Size(index, "cd_membrane_get_collider_load",
                "index"), outLoad, Native.Size(count, "cd_membrane_get_collider_load", "count")));
        }

        /// <summary>How thick cloth is, as a distance [m] in [0, 1e60], default 0, that nodes keep from
        /// colliders.</summary>
        public double Thickness
        {
            get
            {
                double outDistance;
                Check(Native.cd_membrane_get_thickness(Handle, &outDistance));
                return outDistance;
            }
            set
            {
                var distance = value;
                Changed();
                Check(Native.cd_membrane_set_thickness(Handle, distance));
            }
        }

        /// <summary>Switches a field on, filled with the present uniform values (force 0, target the present position,
        /// mask 1, pin what the edges say). CD_BREAKING_STRAIN_U and _V switch CD_STIFFNESS_U and _V on too. On
        /// already: nothing happens. Errors: CD_ERROR_ENUM, CD_ERROR_MEMORY; CD_ERROR_DIVERGED for CD_TARGET where the
        /// state is not finite; here and below CD_ERROR_UNSUPPORTED for the fields of cloth of a membrane that is
        /// none.</summary>
        public void EnableField(Field field)
        {
            Changed();
            Check(Native.cd_membrane_enable_field(Handle, (int)field));
        }

        /// <summary>Switches a field off and releases its memory: uniform values again, no forces, all attachments
        /// loosened, all nodes there, none held but on edges. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for position,
        /// velocity, tension and strain, and for the stiffness of springs that may tear.</summary>
        public void DisableField(Field field)
        {
            Changed();
            Check(Native.cd_membrane_disable_field(Handle, (int)field));
        }

        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void WriteF32(Field field, long firstU, long firstV, long nU, long nV, params float[] values)
        {
            fixed (float* valuesPointer = values)
                WriteF32Core(field, firstU, firstV, nU, nV, valuesPointer, Native.Length(values));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void WriteF32(Field field, long firstU, long firstV, long nU, long nV, ReadOnlySpan<float> values)
        {
            fixed (float* valuesPointer = &MemoryMarshal.GetReference(values))
                WriteF32Core(field, firstU, firstV, nU, nV, values.Length == 0 ? null : valuesPointer, values.Length);
        }

#endif
        private void WriteF32Core(Field field, long firstU, long firstV, long nU, long nV, float* values,
            long valuesLength)
        {
            long count = Native.Count(valuesLength, 1, "cd_membrane_write_f32", "values");
            Changed();
            Check(Native.cd_membrane_write_f32(Handle, (int)field, Native.Size(firstU, "cd_membrane_write_f32",
                "first_u"), Native.Size(firstV, "cd_membrane_write_f32", "first_v"), Native.Size(nU,
                "cd_membrane_write_f32", "n_u"), Native.Size(nV, "cd_membrane_write_f32", "n_v"), values,
                Native.Size(count, "cd_membrane_write_f32", "count")));
        }

        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void WriteF64(Field field, long firstU, long firstV, long nU, long nV, params double[] values)
        {
            fixed (double* valuesPointer = values)
                WriteF64Core(field, firstU, firstV, nU, nV, valuesPointer, Native.Length(values));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void WriteF64(Field field, long firstU, long firstV, long nU, long nV, ReadOnlySpan<double> values)
        {
            fixed (double* valuesPointer = &MemoryMarshal.GetReference(values))
                WriteF64Core(field, firstU, firstV, nU, nV, values.Length == 0 ? null : valuesPointer, values.Length);
        }

#endif
        private void WriteF64Core(Field field, long firstU, long firstV, long nU, long nV, double* values,
            long valuesLength)
        {
            long count = Native.Count(valuesLength, 1, "cd_membrane_write_f64", "values");
            Changed();
            Check(Native.cd_membrane_write_f64(Handle, (int)field, Native.Size(firstU, "cd_membrane_write_f64",
                "first_u"), Native.Size(firstV, "cd_membrane_write_f64", "first_v"), Native.Size(nU,
                "cd_membrane_write_f64", "n_u"), Native.Size(nV, "cd_membrane_write_f64", "n_v"), values,
                Native.Size(count, "cd_membrane_write_f64", "count")));
        }

        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void ReadF32(Field field, long firstU, long firstV, long nU, long nV, float[] outValues)
        {
            fixed (float* outValuesPointer = outValues)
                ReadF32Core(field, firstU, firstV, nU, nV, outValuesPointer, Native.Length(outValues));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void ReadF32(Field field, long firstU, long firstV, long nU, long nV, Span<float> outValues)
        {
            fixed (float* outValuesPointer = &MemoryMarshal.GetReference(outValues))
                ReadF32Core(field, firstU, firstV, nU, nV, outValues.Length == 0 ? null : outValuesPointer,
                    outValues.Length);
        }

#endif
        private void ReadF32Core(Field field, long firstU, long firstV, long nU, long nV, float* outValues,
            long outValuesLength)
        {
            long count = Native.Count(outValuesLength, 1, "cd_membrane_read_f32", "out_values");
            Check(Native.cd_membrane_read_f32(Handle, (int)field, Native.Size(firstU, "cd_membrane_read_f32",
                "first_u"), Native.Size(firstV, "cd_membrane_read_f32", "first_v"), Native.Size(nU,
                "cd_membrane_read_f32", "n_u"), Native.Size(nV, "cd_membrane_read_f32", "n_v"), outValues,
                Native.Size(count, "cd_membrane_read_f32", "count")));
        }

        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void ReadF64(Field field, long firstU, long firstV, long nU, long nV, double[] outValues)
        {
            fixed (double* outValuesPointer = outValues)
                ReadF64Core(field, firstU, firstV, nU, nV, outValuesPointer, Native.Length(outValues));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[v][u][component], dense, of the rectangle of nodes (or springs) [first_u,
        /// first_u + n_u) x [first_v, first_v + n_v). Fields without components have one value per node or spring;
        /// there are nu (ring: nu + 1) springs along u and nv + 1 rows of them, and likewise along v. `count` is the
        /// number of values in the buffer: n_u * n_v * components. Numbers are rounded once, to the precision of the
        /// side that is narrower. Never allocates. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_RANGE; write:
        /// CD_ERROR_VALUE, with the first bad index, and CD_ERROR_UNSUPPORTED for tension and strain.</summary>
        public void ReadF64(Field field, long firstU, long firstV, long nU, long nV, Span<double> outValues)
        {
            fixed (double* outValuesPointer = &MemoryMarshal.GetReference(outValues))
                ReadF64Core(field, firstU, firstV, nU, nV, outValues.Length == 0 ? null : outValuesPointer,
                    outValues.Length);
        }

#endif
        private void ReadF64Core(Field field, long firstU, long firstV, long nU, long nV, double* outValues,
            long outValuesLength)
        {
            long count = Native.Count(outValuesLength, 1, "cd_membrane_read_f64", "out_values");
            Check(Native.cd_membrane_read_f64(Handle, (int)field, Native.Size(firstU, "cd_membrane_read_f64",
                "first_u"), Native.Size(firstV, "cd_membrane_read_f64", "first_v"), Native.Size(nU,
                "cd_membrane_read_f64", "n_u"), Native.Size(nV, "cd_membrane_read_f64", "n_v"), outValues,
                Native.Size(count, "cd_membrane_read_f64", "count")));
        }

        /// <summary>Where a field lies in the membrane's own memory, in the membrane's precision, to read without a
        /// copy: the value of (u, v, component) is at byte *out_data + u * u_stride + v * v_stride + component *
        /// component_stride. Position, velocity, force and target only. The pointer is good until the field is switched
        /// off or the membrane released; the numbers change with every write and step. Do not write through it. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED.</summary>
        public View View(Field field)
        {
            return new View(this, field);
        }

        internal override IntPtr Lie(Field field, long[] strides)
        {
            IntPtr data;
            UIntPtr* s = stackalloc UIntPtr[4];
            Check(Native.cd_membrane_view(Handle, (int)field, &data, s + 0, s + 1, s + 2));
            strides[0] = (long)s[0];
            strides[1] = (long)s[1];
            strides[2] = (long)s[2];
            return data;
        }

        /// <summary>Adds impulse [N s], one number per component, spread over the nodes less than `radius` springs away
        /// from the place (u, v), counted on the lattice and not round a ring, by weights (1 - (distance /
        /// radius)^2)^2, scaled to sum to 1; all on the nearest node if there is none. A node's velocity changes by its
        /// share / its mass; held and absent nodes lose it. u in [0, nu], v in [0, nv], radius &gt;= 0. Errors:
        /// CD_ERROR_RANGE, CD_ERROR_VALUE, CD_ERROR_DIVERGED.</summary>
        public void Impulse(double u, double v, double radius, params double[] impulse)
        {
            fixed (double* impulsePointer = impulse)
                ImpulseCore(u, v, radius, impulsePointer, Native.Length(impulse));
        }

#if CONTDYN_SPANS
        /// <summary>Adds impulse [N s], one number per component, spread over the nodes less than `radius` springs away
        /// from the place (u, v), counted on the lattice and not round a ring, by weights (1 - (distance /
        /// radius)^2)^2, scaled to sum to 1; all on the nearest node if there is none. A node's velocity changes by its
        /// share / its mass; held and absent nodes lose it. u in [0, nu], v in [0, nv], radius &gt;= 0. Errors:
        /// CD_ERROR_RANGE, CD_ERROR_VALUE, CD_ERROR_DIVERGED.</summary>
        public void Impulse(double u, double v, double radius, ReadOnlySpan<double> impulse)
        {
            fixed (double* impulsePointer = &MemoryMarshal.GetReference(impulse))
                ImpulseCore(u, v, radius, impulse.Length == 0 ? null : impulsePointer, impulse.Length);
        }

#endif
        private void ImpulseCore(double u, double v, double radius, double* impulse, long impulseLength)
        {
            long count = Native.Count(impulseLength, 1, "cd_membrane_impulse", "impulse");
            Changed();
            Check(Native.cd_membrane_impulse(Handle, u, v, radius, impulse, Native.Size(count, "cd_membrane_impulse",
                "count")));
        }

        /// <summary>Moves the sheet as a whole, as if it had always been there: every position and target becomes
        /// rotation * x + offset, every velocity rotation * v; colliders stay where they are. rotation: components rows
        /// of as many numbers, orthogonal to 1e-6; null: none. offset [m]: one number per component, which count
        /// counts. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public void Teleport(double[] rotation, params double[] offset)
        {
            fixed (double* rotationPointer = rotation)
            fixed (double* offsetPointer = offset)
                TeleportCore(rotationPointer, Native.Length(rotation), offsetPointer, Native.Length(offset));
        }

#if CONTDYN_SPANS
        /// <summary>Moves the sheet as a whole, as if it had always been there: every position and target becomes
        /// rotation * x + offset, every velocity rotation * v; colliders stay where they are. rotation: components rows
        /// of as many numbers, orthogonal to 1e-6; null: none. offset [m]: one number per component, which count
        /// counts. Errors: CD_ERROR_RANGE, CD_ERROR_VALUE; CD_ERROR_DIVERGED for a state that is not finite.</summary>
        public void Teleport(ReadOnlySpan<double> rotation, ReadOnlySpan<double> offset)
        {
            fixed (double* rotationPointer = &MemoryMarshal.GetReference(rotation))
            fixed (double* offsetPointer = &MemoryMarshal.GetReference(offset))
                TeleportCore(rotation.Length == 0 ? null : rotationPointer, rotation.Length,
                    offset.Length == 0 ? null : offsetPointer, offset.Length);
        }

#endif
        private void TeleportCore(double* rotation, long rotationLength, double* offset, long offsetLength)
        {
            long count = Native.Count(offsetLength, 1, "cd_membrane_teleport", "offset");
            Native.Same(rotation, rotationLength, count * count, "cd_membrane_teleport", "rotation");
            Changed();
            Check(Native.cd_membrane_teleport(Handle, rotation, offset, Native.Size(count, "cd_membrane_teleport",
                "count")));
        }

        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. target: one number per component; null: the node's present position, and count means
        /// nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET
        /// on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that
        /// is not finite.</summary>
        public void Attach(long u, long v, double stiffness, double damping, params double[] target)
        {
            fixed (double* targetPointer = target)
                AttachCore(u, v, stiffness, damping, targetPointer, Native.Length(target));
        }

#if CONTDYN_SPANS
        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. target: one number per component; null: the node's present position, and count means
        /// nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET
        /// on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that
        /// is not finite.</summary>
        public void Attach(long u, long v, double stiffness, double damping, ReadOnlySpan<double> target)
        {
            fixed (double* targetPointer = &MemoryMarshal.GetReference(target))
                AttachCore(u, v, stiffness, damping, target.Length == 0 ? null : targetPointer, target.Length);
        }

#endif
        private void AttachCore(long u, long v, double stiffness, double damping, double* target, long targetLength)
        {
            long count = Native.Count(targetLength, 1, "cd_membrane_attach", "target");
            Changed();
            Check(Native.cd_membrane_attach(Handle, Native.Size(u, "cd_membrane_attach", "u"), Native.Size(v,
                "cd_membrane_attach", "v"), stiffness, damping, target, Native.Size(count, "cd_membrane_attach",
                "count")));
        }

        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. target: one number per component; null: the node's present position, and count means
        /// nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET
        /// on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that
        /// is not finite.</summary>
        public void Detach(long u, long v)
        {
            Changed();
            Check(Native.cd_membrane_detach(Handle, Native.Size(u, "cd_membrane_detach", "u"), Native.Size(v,
                "cd_membrane_detach", "v")));
        }

        /// <summary>Ties a node to its target by a spring of `stiffness` [N/m] &gt;= 0 and `damping` [N s/m] &gt;= 0,
        /// as a mouse drag does. target: one number per component; null: the node's present position, and count means
        /// nothing. Move it afterwards by writing CD_TARGET. Attaching again changes the numbers. Switches CD_TARGET
        /// on. Errors: CD_ERROR_RANGE; attach: CD_ERROR_VALUE, CD_ERROR_MEMORY, and CD_ERROR_DIVERGED for a state that
        /// is not finite.</summary>
        public MembraneAttachment GetAttachment(long u, long v)
        {
            double outStiffness;
            double outDamping;
            Check(Native.cd_membrane_get_attachment(Handle, Native.Size(u, "cd_membrane_get_attachment", "u"),
                Native.Size(v, "cd_membrane_get_attachment", "v"), &outStiffness, &outDamping));
            return new MembraneAttachment(outStiffness, outDamping);
        }

        /// <summary>Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
        /// Never allocates. Time is proportional to count * nodes * components, with CD_SOLVER_COUPLED to the
        /// iterations too. Errors: CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are
        /// made, the message gives the first bad one, the membrane can be read, and steps again after
        /// cd_membrane_reset, a load, or once finite positions and velocities have been written; CD_ERROR_TOLERANCE if
        /// a coupled solve ended short of its tolerance: all steps are made, and good to the residual that
        /// cd_membrane_get_convergence tells.</summary>
        public void Step(double dt, long count = 1)
        {
            Changed();
            Check(Native.cd_membrane_step(Handle, dt, Native.Size(count, "cd_membrane_step", "count")));
        }

        /// <summary>The longest dt at which CD_METHOD_SYMPLECTIC_EULER is sure to stay bounded, whatever method is set:
        /// the largest dt with 4 M - 2 dt C - dt^2 K positive definite, by a bound on K that is exact in the limit of
        /// many nodes for uniform sheets, and a safe lower bound otherwise. INFINITY if nothing can swing. Errors:
        /// CD_ERROR_UNSUPPORTED of cloth.</summary>
        public double StableDt()
        {
            double outDt;
            Check(Native.cd_membrane_stable_dt(Handle, &outDt));
            return outDt;
        }

        /// <summary>Simulated time [s] and steps made since create or reset, those before a load or a copied state
        /// included.</summary>
        public double GetTime()
        {
            double outTime;
            Check(Native.cd_membrane_get_time(Handle, &outTime));
            return outTime;
        }

        /// <summary>Simulated time [s] and steps made since create or reset, those before a load or a copied state
        /// included.</summary>
        public ulong GetSteps()
        {
            ulong outSteps;
            Check(Native.cd_membrane_get_steps(Handle, &outSteps));
            return outSteps;
        }

        /// <summary>How many factorizations the membrane has made: one at the first implicit step and one at the first
        /// after each change of dt, lambda, method, solver or a parameter. Not part of the saved state.</summary>
        public ulong GetFactorizations()
        {
            ulong outCount;
            Check(Native.cd_membrane_get_factorizations(Handle, &outCount));
            return outCount;
        }

        /// <summary>Energies [J]; each output may be null. Kinetic: of the free nodes. Elastic: stretch, bend and
        /// attachments. Gravity: -sum m g x of the free nodes. What of their sum lambda = 1/2 keeps is told
        /// above.</summary>
        public MembraneEnergy GetEnergy()
        {
            double outKinetic;
            double outElastic;
            double outGravity;
            Check(Native.cd_membrane_get_energy(Handle, &outKinetic, &outElastic, &outGravity));
            return new MembraneEnergy(outKinetic, outElastic, outGravity);
        }

        /// <summary>Momentum of the free nodes [kg m/s], one number per component. Errors: CD_ERROR_RANGE if count is
        /// not the number of components.</summary>
        public void GetMomentum(double[] outMomentum)
        {
            fixed (double* outMomentumPointer = outMomentum)
                GetMomentumCore(outMomentumPointer, Native.Length(outMomentum));
        }

#if CONTDYN_SPANS
        /// <summary>Momentum of the free nodes [kg m/s], one number per component. Errors: CD_ERROR_RANGE if count is
        /// not the number of components.</summary>
        public void GetMomentum(Span<double> outMomentum)
        {
            fixed (double* outMomentumPointer = &MemoryMarshal.GetReference(outMomentum))
                GetMomentumCore(outMomentum.Length == 0 ? null : outMomentumPointer, outMomentum.Length);
        }

#endif
        private void GetMomentumCore(double* outMomentum, long outMomentumLength)
        {
            long count = Native.Count(outMomentumLength, 1, "cd_membrane_get_momentum", "out_momentum");
            Check(Native.cd_membrane_get_momentum(Handle, outMomentum, Native.Size(count, "cd_membrane_get_momentum",
                "count")));
        }

        /// <summary>The force [N], one number per component, with which springs, shear and bend pull at a node where it
        /// is now: of a held node, what the sheet does to whatever holds it, but for weight, forces, attachment,
        /// pressure and wind of that node itself. Errors: CD_ERROR_RANGE for count, or if there is no such
        /// node.</summary>
        public void GetReaction(long u, long v, double[] outForce)
        {
            fixed (double* outForcePointer = outForce)
                GetReactionCore(u, v, outForcePointer, Native.Length(outForce));
        }

#if CONTDYN_SPANS
        /// <summary>The force [N], one number per component, with which springs, shear and bend pull at a node where it
        /// is now: of a held node, what the sheet does to whatever holds it, but for weight, forces, attachment,
        /// pressure and wind of that node itself. Errors: CD_ERROR_RANGE for count, or if there is no such
        /// node.</summary>
        public void GetReaction(long u, long v, Span<double> outForce)
        {
            fixed (double* outForcePointer = &MemoryMarshal.GetReference(outForce))
                GetReactionCore(u, v, outForce.Length == 0 ? null : outForcePointer, outForce.Length);
        }

#endif
        private void GetReactionCore(long u, long v, double* outForce, long outForceLength)
        {
            long count = Native.Count(outForceLength, 1, "cd_membrane_get_reaction", "out_force");
            Check(Native.cd_membrane_get_reaction(Handle, Native.Size(u, "cd_membrane_get_reaction", "u"),
                Native.Size(v, "cd_membrane_get_reaction", "v"), outForce, Native.Size(count,
                "cd_membrane_get_reaction", "count")));
        }

        /// <summary>Volume between the sheet and the origin [m^3]: a third of the integral of x over the surface's
        /// normal, each cell the mean of its two triangulations, cells with an absent node or torn open left out. Of a
        /// drum-head whose rim lies in a plane through the origin it is the volume under it; of a closed surface, what
        /// it encloses. 3 components only. Errors: CD_ERROR_UNSUPPORTED.</summary>
        public double GetVolume()
        {
            double outVolume;
            Check(Native.cd_membrane_get_volume(Handle, &outVolume));
            return outVolume;
        }

        /// <summary>Positions at n places on the sheet, bilinear between nodes: at[j] = {u, v}, u in [0, nu] (ring: to
        /// nu + 1), v likewise; out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE,
        /// CD_ERROR_ENUM, CD_ERROR_VALUE.</summary>
        public void Sample(double[] at, Outside outside, double[] outPositions)
        {
            fixed (double* atPointer = at)
            fixed (double* outPositionsPointer = outPositions)
                SampleCore(atPointer, Native.Length(at), outside, outPositionsPointer, Native.Length(outPositions));
        }

#if CONTDYN_SPANS
        /// <summary>Positions at n places on the sheet, bilinear between nodes: at[j] = {u, v}, u in [0, nu] (ring: to
        /// nu + 1), v likewise; out_positions[j][component], out_count = n * components. Errors: CD_ERROR_RANGE,
        /// CD_ERROR_ENUM, CD_ERROR_VALUE.</summary>
        public void Sample(ReadOnlySpan<double> at, Outside outside, Span<double> outPositions)
        {
            fixed (double* atPointer = &MemoryMarshal.GetReference(at))
            fixed (double* outPositionsPointer = &MemoryMarshal.GetReference(outPositions))
                SampleCore(at.Length == 0 ? null : atPointer, at.Length, outside,
                    outPositions.Length == 0 ? null : outPositionsPointer, outPositions.Length);
        }

#endif
        private void SampleCore(double* at, long atLength, Outside outside, double* outPositions,
            long outPositionsLength)
        {
            long n = Native.Count(atLength, 2, "cd_membrane_sample", "at");
            long outCount = Native.Count(outPositionsLength, 1, "cd_membrane_sample", "out_positions");
            Check(Native.cd_membrane_sample(Handle, at, Native.Size(n, "cd_membrane_sample", "n"), (int)outside,
                outPositions, Native.Size(outCount, "cd_membrane_sample", "out_count")));
        }

        /// <summary>Bytes the membrane holds from its allocator.</summary>
        public long GetMemory()
        {
            UIntPtr outBytes;
            Check(Native.cd_membrane_get_memory(Handle, &outBytes));
            return (long)outBytes;
        }

        /// <summary>A 64-bit hash of everything cd_membrane_save would write. Equal on every machine, compiler and
        /// vector width.</summary>
        public ulong Hash()
        {
            ulong outHash;
            Check(Native.cd_membrane_hash(Handle, &outHash));
            return outHash;
        }

        /// <summary>Writes a vertex for every node, in node order, into the caller's buffer: vertex i at byte i *
        /// stride, its position as 3 floats at position_offset and its unit normal, smooth across the sheet, as 3
        /// floats at normal_offset. A normal points along x_u x x_v and is zero where the sheet has no area or is not
        /// finite. Components that are not there are written as 0, and a fourth is not drawn; a membrane of 1 component
        /// is drawn as the height z over the unit square, x = u / nu, y = v / nv (a direction without a spring: 0; a
        /// ring: u / (nu + 1), and for the normals the sheet goes on beyond its ends). normal_offset SIZE_MAX: no
        /// normals. Bytes between are left alone; any offset and stride will do, aligned or not, that keeps the
        /// vertices apart. Absent nodes get their vertex too, with a zero normal. Errors: CD_ERROR_RANGE if size &lt;
        /// nodes * stride, an offset and its 12 bytes reach past stride, or both overlap.</summary>
        public void WriteVertices<T>(T[] buffer, long stride, long positionOffset, long normalOffset) where T : struct
        {
            using (var bufferPinned = new Pinned<T>(buffer))
                WriteVerticesCore(bufferPinned.Pointer, bufferPinned.Length, stride, positionOffset, normalOffset);
        }

#if CONTDYN_SPANS
        /// <summary>Writes a vertex for every node, in node order, into the caller's buffer: vertex i at byte i *
        /// stride, its position as 3 floats at position_offset and its unit normal, smooth across the sheet, as 3
        /// floats at normal_offset. A normal points along x_u x x_v and is zero where the sheet has no area or is not
        /// finite. Components that are not there are written as 0, and a fourth is not drawn; a membrane of 1 component
        /// is drawn as the height z over the unit square, x = u / nu, y = v / nv (a direction without a spring: 0; a
        /// ring: u / (nu + 1), and for the normals the sheet goes on beyond its ends). normal_offset SIZE_MAX: no
        /// normals. Bytes between are left alone; any offset and stride will do, aligned or not, that keeps the
        /// vertices apart. Absent nodes get their vertex too, with a zero normal. Errors: CD_ERROR_RANGE if size &lt;
        /// nodes * stride, an offset and its 12 bytes reach past stride, or both overlap.</summary>
        public void WriteVertices(Span<byte> buffer, long stride, long positionOffset, long normalOffset)
        {
            fixed (byte* bufferPointer = &MemoryMarshal.GetReference(buffer))
                WriteVerticesCore(buffer.Length == 0 ? null : bufferPointer, buffer.Length, stride, positionOffset,
                    normalOffset);
        }

#endif
        private void WriteVerticesCore(void* buffer, long bufferLength, long stride, long positionOffset,
            long normalOffset)
        {
            long size = bufferLength;
            Check(Native.cd_membrane_write_vertices(Handle, buffer, Native.Size(size, "cd_membrane_write_vertices",
                "size"), Native.Size(stride, "cd_membrane_write_vertices", "stride"), Native.Size(positionOffset,
                "cd_membrane_write_vertices", "position_offset"), Native.SizeOrNone(normalOffset,
                "cd_membrane_write_vertices", "normal_offset")));
        }

        /// <summary>How many indices cd_membrane_write_indices writes now: 6 per cell of four nodes that are there, of
        /// cloth 0 if it is torn open, 3 per cell of which three are there. Cells that close a ring are among them, but
        /// not of 1 component: they would reach back across the unit square.</summary>
        public long GetIndexCount()
        {
            UIntPtr outCount;
            Check(Native.cd_membrane_get_index_count(Handle, &outCount));
            return (long)outCount;
        }

        /// <summary>Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte
        /// order), counter-clockwise seen from where the normal points; a cell is cut from its node (u, v) to (u + 1, v
        /// + 1). `size` is that of the buffer in bytes. The numbers change with CD_MASK, cd_membrane_set_ring and what
        /// is cut of cloth only. 65535 with 2 bytes and 2^32 - 1 with 4, which graphics cards may take for a restart,
        /// are never written. Errors: CD_ERROR_VALUE for another index_size; CD_ERROR_RANGE if size is too small;
        /// CD_ERROR_UNSUPPORTED for more nodes.</summary>
        public void WriteIndices<T>(T[] buffer, long indexSize) where T : struct
        {
            using (var bufferPinned = new Pinned<T>(buffer))
                WriteIndicesCore(bufferPinned.Pointer, bufferPinned.Length, indexSize);
        }

#if CONTDYN_SPANS
        /// <summary>Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte
        /// order), counter-clockwise seen from where the normal points; a cell is cut from its node (u, v) to (u + 1, v
        /// + 1). `size` is that of the buffer in bytes. The numbers change with CD_MASK, cd_membrane_set_ring and what
        /// is cut of cloth only. 65535 with 2 bytes and 2^32 - 1 with 4, which graphics cards may take for a restart,
        /// are never written. Errors: CD_ERROR_VALUE for another index_size; CD_ERROR_RANGE if size is too small;
        /// CD_ERROR_UNSUPPORTED for more nodes.</summary>
        public void WriteIndices(Span<byte> buffer, long indexSize)
        {
            fixed (byte* bufferPointer = &MemoryMarshal.GetReference(buffer))
                WriteIndicesCore(buffer.Length == 0 ? null : bufferPointer, buffer.Length, indexSize);
        }

#endif
        private void WriteIndicesCore(void* buffer, long bufferLength, long indexSize)
        {
            long size = bufferLength;
            Check(Native.cd_membrane_write_indices(Handle, buffer, Native.Size(size, "cd_membrane_write_indices",
                "size"), Native.Size(indexSize, "cd_membrane_write_indices", "index_size")));
        }

        /// <summary>The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load
        /// needs a membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
        /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public long SaveSize()
        {
            UIntPtr outSize;
            Check(Native.cd_membrane_save_size(Handle, &outSize));
            return (long)outSize;
        }

        /// <summary>The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load
        /// needs a membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
        /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public long Save<T>(T[] buffer) where T : struct
        {
            using (var bufferPinned = new Pinned<T>(buffer))
                return SaveCore(bufferPinned.Pointer, bufferPinned.Length);
        }

#if CONTDYN_SPANS
        /// <summary>The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load
        /// needs a membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
        /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public long Save(Span<byte> buffer)
        {
            fixed (byte* bufferPointer = &MemoryMarshal.GetReference(buffer))
                return SaveCore(buffer.Length == 0 ? null : bufferPointer, buffer.Length);
        }

#endif
        private long SaveCore(void* buffer, long bufferLength)
        {
            long size = bufferLength;
            UIntPtr outWritten;
            Check(Native.cd_membrane_save(Handle, buffer, Native.Size(size, "cd_membrane_save", "size"), &outWritten));
            return (long)outWritten;
        }

        /// <summary>The same into a new array.</summary>
        public byte[] Save()
        {
            var bytes = new byte[SaveSize()];
            Array.Resize(ref bytes, (int)Save(bytes));
            return bytes;
        }

        /// <summary>The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load
        /// needs a membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
        /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public void Load<T>(T[] bytes) where T : struct
        {
            using (var bytesPinned = new Pinned<T>(bytes))
                LoadCore(bytesPinned.Pointer, bytesPinned.Length);
        }

#if CONTDYN_SPANS
        /// <summary>The whole state as bytes, all the future depends on but the callbacks, as cd_chain_save says. load
        /// needs a membrane of the same shape and precision; it switches fields on and off as they were. Errors: save:
        /// CD_ERROR_RANGE. load: CD_ERROR_FORMAT, CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public void Load(ReadOnlySpan<byte> bytes)
        {
            fixed (byte* bytesPointer = &MemoryMarshal.GetReference(bytes))
                LoadCore(bytes.Length == 0 ? null : bytesPointer, bytes.Length);
        }

#endif
        private void LoadCore(void* bytes, long bytesLength)
        {
            long size = bytesLength;
            Changed();
            Check(Native.cd_membrane_load(Handle, bytes, Native.Size(size, "cd_membrane_load", "size")));
        }

        /// <summary>Makes `membrane` what `source` is, as save and load would, without the bytes: the two must agree in
        /// shape and precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public void CopyState(Membrane source)
        {
            Changed();
            Check(Native.cd_membrane_copy_state(Handle, Native.NotNull(source, "source").Handle));
        }

        /// <summary>Positions, velocities, time and steps back to 0. Parameters, fields and pins stay; targets
        /// too.</summary>
        public void Reset()
        {
            Changed();
            Check(Native.cd_membrane_reset(Handle));
        }
    }

    /// <summary>What Water.GetShape tells.</summary>
    public struct WaterShape
    {
        public readonly long Nx;
        public readonly long Ny;
        public readonly double Dx;
        public readonly double Dy;
        public readonly Precision Precision;

        internal WaterShape(long nx, long ny, double dx, double dy, Precision precision)
        {
            Nx = nx;
            Ny = ny;
            Dx = dx;
            Dy = dy;
            Precision = precision;
        }
    }

    /// <summary>What Water.GetSide tells.</summary>
    public struct WaterSide
    {
        public readonly Border Kind;
        public readonly double Value;
        public readonly double Rate;

        internal WaterSide(Border kind, double value, double rate)
        {
            Kind = kind;
            Value = value;
            Rate = rate;
        }
    }

    /// <summary>What Water.GetHulls tells.</summary>
    public struct WaterHulls
    {
        public readonly long Count;
        public readonly long NAlong;
        public readonly long NAcross;

        internal WaterHulls(long count, long nAlong, long nAcross)
        {
            Count = count;
            NAlong = nAlong;
            NAcross = nAcross;
        }
    }

    /// <summary>What Water.GetHull tells.</summary>
    public struct WaterHull
    {
        public readonly double Mass;
        public readonly double Length;
        public readonly double Width;
        public readonly double Area;

        internal WaterHull(double mass, double length, double width, double area)
        {
            Mass = mass;
            Length = length;
            Width = width;
            Area = area;
        }
    }

    /// <summary>What Water.GetHullDrag tells.</summary>
    public struct WaterHullDrag
    {
        public readonly double Along;
        public readonly double Across;
        public readonly double Friction;

        internal WaterHullDrag(double along, double across, double friction)
        {
            Along = along;
            Across = across;
            Friction = friction;
        }
    }

    /// <summary>What Water.GetHullEnergy tells.</summary>
    public struct WaterHullEnergy
    {
        public readonly double Kinetic;
        public readonly double Potential;

        internal WaterHullEnergy(double kinetic, double potential)
        {
            Kinetic = kinetic;
            Potential = potential;
        }
    }

    /// <summary>What Water.GetLimited tells.</summary>
    public struct WaterLimited
    {
        public readonly ulong Cells;
        public readonly double Volume;

        internal WaterLimited(ulong cells, double volume)
        {
            Cells = cells;
            Volume = volume;
        }
    }

    /// <summary>What Water.GetAccount tells.</summary>
    public struct WaterAccount
    {
        public readonly double Initial;
        public readonly double In;
        public readonly double Out;
        public readonly double Error;

        internal WaterAccount(double initial, double @in, double @out, double error)
        {
            Initial = initial;
            In = @in;
            Out = @out;
            Error = error;
        }
    }

    /// <summary>What Water.GetEnergy tells.</summary>
    public struct WaterEnergy
    {
        public readonly double Kinetic;
        public readonly double Potential;

        internal WaterEnergy(double kinetic, double potential)
        {
            Kinetic = kinetic;
            Potential = potential;
        }
    }

    /// <summary>contdyn: water: a height field of columns over a bed: pool, river, tide, flood.
    /// A water has nx x ny cells of dx x dy metres; ny = 1 is a slice. A cell holds a column of water of depth d
    /// &gt;= 0 over its bed b; its surface is h = b + d. Velocities live on the faces between cells: x-face (i, j)
    /// lies between the cells (i - 1, j) and (i, j), so that there are nx + 1 of them in a row; y-face (i, j)
    /// between (i, j - 1) and (i, j). Cell (i, j) has its centre at ((i + 1/2) dx, (j + 1/2) dy).
    /// Motion d_t + (d u)_x + (d v)_y = source u_t [+ u u_x + v u_y] = -g h_x - p_x / density + force - friction u,
    /// and v likewise friction = drag + g manning^2 |u| / d^(4/3) (Kass 1997, eq. 32-33; the bracket: shallow
    /// water)
    /// CD_MOMENTUM_LINEAR without the bracket: waves, splashes, tides, floods that creep. CD_MOMENTUM_ADVECTED with
    /// it: moving shores, dam breaks, bores, whirls. Momentum goes with the water that leaves a cell, upwind, of
    /// second order where depths are even.
    /// What to set: the momentum by this list; lambda as cd_water_set_momentum sets it; one step a frame, which is
    /// never too long to be stable, or more where waves must run at their speed (cd_water_get_courant at most 1).
    /// lambda = 1/2 is of second order in time and keeps the energy of small waves; above 1/2 short waves die out,
    /// and linear water, whose shores are steep, needs a little more. Right for waves much longer than the water is
    /// deep and for surfaces that do not turn over: there is no dispersion, and there are no ship wakes.
    /// A step sweeps along all rows, then along all columns, and the next step the other way round. Along such a
    /// line the fluxes and the changes of the surface are solved for together, by the theta scheme, theta = lambda,
    /// in time in proportion to its cells. The depth at a face is the mean of its two cells'; where these differ a
    /// lot, it is nearer to that of the cell which the water leaves. No cell gives more than it has and gets:
    /// cd_water_get_limited tells how much that holds back. So no depth is negative, a lake lies still on any bed,
    /// and cd_water_get_account tells all changes of volume. Explicit methods differ in that no surface is solved
    /// for: half of the slope pushes, the water moves, then the other half pushes (velocity Verlet).
    /// What goes wrong, and by how much. "From n cells on": in steps, or parts of fast water's, in which waves
    /// cross as many. Long steps: from 1 cell on waves run too slowly, short ones most, and slantwise more than
    /// along the axes. Make them shorter: to solve for the whole plane, a system that streams make neither
    /// symmetric nor definite, cost tens of times as much, and gained and lost water. Fast water: a line whose
    /// water would run more than half a cell makes its step in 2, 4, ... 64 parts, at so many times the cost, none
    /// of which begins with faster water. Water that runs more than 32 cells is carried less exactly, and ripples
    /// on it may grow; on slower water only those of linear momentum, lambda 1/2, uneven beds do. Bores, linear:
    /// momentum is not carried on, so that a shore moves with the slope of the surface there, and a bore a tenth,
    /// half, twice as high as the depth before it is 2, 9, 22% too slow, against a stream as much too fast. Bores,
    /// advected: within 1.2% of their speed, also against streams, until water runs over 32 cells; from 2 cells on
    /// those a tenth of the depth high are spread over 2 to 6 times as many. Waves behind a bore: with lambda = 1/2
    /// up to its own height (linear: 1.6), with 0.6 up to 0.3 (1.3), all along its way where the water behind it
    /// rests. Energy, linear: where water deepens it gains h_t u^2 / 2, at random shores some hundredths in all
    /// (and see hulls). From 2 cells on waves in the plane, with lambda = 1/2, grow in thousands of steps to a
    /// ninth of the depth. Energy, advected: from 1 cell on it does not rise by itself. Below 1 cell up to 0.005 of
    /// it is won among cliffs, far below also at shores, and 0.01 in the first step after velocities are written
    /// there. Energy, both: from 1 cell on no face gains more than its water loses by falling: linear over uneven
    /// depths, advected where a depth changes by half; from 1e12 on rounding may add any amount. Air that presses
    /// water dry adds 1.4 times what it has to give where momentum is linear, half of it where advected, any amount
    /// if explicit. Dry land: what pushes water away from it gives the face at the water's edge a velocity that no
    /// water follows.
    /// A new water is dry, over a bed at 0, at rest, walled in, gravity 9.81, density 1000, no drag,
    /// CD_MOMENTUM_LINEAR, CD_METHOD_IMPLICIT with lambda 0.55. All computing is in double precision; CD_FLOAT32 is
    /// what depth, bed, velocities and the fields are stored in. Steps store 0 for depths below 2^-80 m and
    /// velocities below 2^-80 (float32), 2^-500 m/s. Parameters may be as large as 1e60.
    /// Every function returns CD_ERROR_NULL for a null pointer and CD_ERROR_HANDLE for a handle of another kind;
    /// the comments name the other errors. Functions that chain and membrane have too mean the same here.</summary>
    public sealed unsafe class Water : LibraryObject
    {
        internal new WaterHandle Handle { get { return (WaterHandle)base.Handle; } }

        /// <summary>Makes a water. nx, ny &gt;= 1; dx, dy [m] in [1e-30, 1e30]. allocator may be null (malloc). The
        /// caller owns *out_water and releases it with cd_water_destroy; on failure *out_water is left alone. Errors:
        /// CD_ERROR_VALUE, CD_ERROR_ENUM, CD_ERROR_SIZE, CD_ERROR_MEMORY; CD_ERROR_UNSUPPORTED for a precision that
        /// this build leaves out.</summary>
        public Water(long nx, long ny, double dx, double dy, Precision precision = Precision.Float64,
            AllocatorCallbacks allocator = null)
        {
            void* allocatorStruct = allocator == null ? null : allocator.Struct();
            IntPtr made;
            Native.CheckVersion();
            int status;
            try
            {
                status = Native.cd_water_create(Native.Size(nx, "cd_water_create", "nx"), Native.Size(ny,
                    "cd_water_create", "ny"), dx, dy, (int)precision, allocatorStruct, &made);
            }
            catch (EntryPointNotFoundException)
            {
                throw Native.LeftOut("cd_water_create");
            }
            Native.Check(status, allocator);
            Own(new WaterHandle(made));
            Handle.Keep("allocator", allocator);
        }

        private static readonly Dictionary<Field, FieldRow> rows = new Dictionary<Field, FieldRow>
        {
            { Field.Depth, new FieldRow(new[] { 1, 0, 0, 2, 0, 0 }, false, false) },
            { Field.Bed, new FieldRow(new[] { 1, 0, 0, 2, 0, 0 }, false, false) },
            { Field.Surface, new FieldRow(new[] { 1, 0, 0, 2, 0, 0 }, false, false) },
            { Field.VelocityX, new FieldRow(new[] { 1, 1, 0, 2, 0, 0 }, false, false) },
            { Field.VelocityY, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, false, false) },
            { Field.Source, new FieldRow(new[] { 1, 0, 0, 2, 0, 0 }, false, false) },
            { Field.Pressure, new FieldRow(new[] { 1, 0, 0, 2, 0, 0 }, false, false) },
            { Field.ForceX, new FieldRow(new[] { 1, 1, 0, 2, 0, 0 }, false, false) },
            { Field.ForceY, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, false, false) },
            { Field.Mask, new FieldRow(new[] { 1, 0, 0, 2, 0, 0 }, false, false) },
            { Field.WallX, new FieldRow(new[] { 1, 1, 0, 2, 0, 0 }, false, false) },
            { Field.WallY, new FieldRow(new[] { 1, 0, 0, 2, 1, 0 }, false, false) },
        };

        internal override Whole Extents(Field field)
        {
            FieldRow row;
            if (!rows.TryGetValue(field, out row)) return new Whole();
            var shape = GetShape();
            return new Whole(row, new[] { shape.Nx, shape.Ny }, new bool[0], false, 1);
        }

        internal override Precision Stored { get { return GetShape().Precision; } }

        internal override void ReadWhole(Field field, Whole whole, float* outValues, long count)
        {
            var range = whole.Range(false);
            ReadF32Core(field, range[0], range[1], range[2], range[3], outValues, count);
        }

        internal override void ReadWhole(Field field, Whole whole, double* outValues, long count)
        {
            var range = whole.Range(false);
            ReadF64Core(field, range[0], range[1], range[2], range[3], outValues, count);
        }

        internal override void WriteWhole(Field field, Whole whole, float* values, long count)
        {
            var range = whole.Range(false);
            WriteF32Core(field, range[0], range[1], range[2], range[3], values, count);
        }

        internal override void WriteWhole(Field field, Whole whole, double* values, long count)
        {
            var range = whole.Range(false);
            WriteF64Core(field, range[0], range[1], range[2], range[3], values, count);
        }

        /// <summary>What cd_water_create was given, or what has been loaded since. Each output may be null.</summary>
        public WaterShape GetShape()
        {
            UIntPtr outNx;
            UIntPtr outNy;
            double outDx;
            double outDy;
            int outPrecision;
            Check(Native.cd_water_get_shape(Handle, &outNx, &outNy, &outDx, &outDy, &outPrecision));
            return new WaterShape((long)outNx, (long)outNy, outDx, outDy, (Precision)outPrecision);
        }

        /// <summary>How steps are made: CD_METHOD_IMPLICIT; CD_METHOD_SYMPLECTIC_EULER, here in its symmetric form,
        /// second order in time and bounded up to cd_water_stable_dt; CD_METHOD_FORWARD_EULER, first order, bounded at
        /// no dt. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for CD_METHOD_STIFF_SECOND; CD_ERROR_MEMORY.</summary>
        public Method Method
        {
            get
            {
                int outMethod;
                Check(Native.cd_water_get_method(Handle, &outMethod));
                return (Method)outMethod;
            }
            set
            {
                var method = value;
                Changed();
                Check(Native.cd_water_set_method(Handle, (int)method));
            }
        }

        /// <summary>lambda of CD_METHOD_IMPLICIT, in [0, 1]; below 1/2 it grows without bound at most dt. Errors:
        /// CD_ERROR_VALUE.</summary>
        public double Lambda
        {
            get
            {
                double outLambda;
                Check(Native.cd_water_get_lambda(Handle, &outLambda));
                return outLambda;
            }
            set
            {
                var lambda = value;
                Changed();
                Check(Native.cd_water_set_lambda(Handle, lambda));
            }
        }

        /// <summary>Linear or advected momentum; see above. Sets lambda too, to what suits the mode: 0.55 for linear,
        /// 1/2 for advected. Advected momentum costs memory. Errors: CD_ERROR_ENUM; CD_ERROR_MEMORY.</summary>
        public Momentum Momentum
        {
            get
            {
                int outMomentum;
                Check(Native.cd_water_get_momentum(Handle, &outMomentum));
                return (Momentum)outMomentum;
            }
            set
            {
                var momentum = value;
                Changed();
                Check(Native.cd_water_set_momentum(Handle, (int)momentum));
            }
        }

        /// <summary>Which way the next step sweeps first: along x (0, the default of a new water) or along y (1). Every
        /// step turns it round. A scene and its transpose, begun opposite ways, stay each other's transpose to the bit.
        /// Errors: CD_ERROR_VALUE for anything but 0 and 1.</summary>
        public bool First
        {
            get
            {
                int outAlongY;
                Check(Native.cd_water_get_first(Handle, &outAlongY));
                return outAlongY != 0;
            }
            set
            {
                var alongY = value;
                Changed();
                Check(Native.cd_water_set_first(Handle, alongY ? 1 : 0));
            }
        }

        /// <summary>Spreads a step over the caller's threads. Null turns it off. It costs memory, for work that threads
        /// do not share. Errors: CD_ERROR_NULL for a table without run; CD_ERROR_MEMORY.</summary>
        public void SetParallel(ParallelCallbacks parallel)
        {
            void* parallelStruct = parallel == null ? null : parallel.Struct();
            Changed();
            Check(Native.cd_water_set_parallel(Handle, parallelStruct));
            Handle.Keep("parallel", parallel);
        }

        /// <summary>The instructions that steps are made of, from here on: for tests and measurements, as all give the
        /// same bits and a new water has the fastest that its processor runs. Not part of the saved state. Errors:
        /// CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for kernels that are not among cd_runnable_kernels.</summary>
        public Kernels Kernels
        {
            get
            {
                int outKernels;
                Check(Native.cd_water_get_kernels(Handle, &outKernels));
                return (Kernels)outKernels;
            }
            set
            {
                var kernels = value;
                Changed();
                Check(Native.cd_water_set_kernels(Handle, (int)kernels));
            }
        }

        /// <summary>Gravity [m/s^2], 0 or in [1e-60, 1e6]; default 9.81.</summary>
        public double Gravity
        {
            get
            {
                double outGravity;
                Check(Native.cd_water_get_gravity(Handle, &outGravity));
                return outGravity;
            }
            set
            {
                var gravity = value;
                Changed();
                Check(Native.cd_water_set_gravity(Handle, gravity));
            }
        }

        /// <summary>Density [kg/m^3], in [1e-6, 1e6]; default 1000. Only pressure, impulses and energies know
        /// it.</summary>
        public double Density
        {
            get
            {
                double outDensity;
                Check(Native.cd_water_get_density(Handle, &outDensity));
                return outDensity;
            }
            set
            {
                var density = value;
                Changed();
                Check(Native.cd_water_set_density(Handle, density));
            }
        }

        /// <summary>Drag [1/s], &gt;= 0: velocities die out by exp(-drag t). Default 0.</summary>
        public double Drag
        {
            get
            {
                double outDrag;
                Check(Native.cd_water_get_drag(Handle, &outDrag));
                return outDrag;
            }
            set
            {
                var drag = value;
                Changed();
                Check(Native.cd_water_set_drag(Handle, drag));
            }
        }

        /// <summary>Manning's roughness of the bed [s/m^(1/3)], in [0, 1e3]: 0.01 for glass, 0.03 for a river, 0.1 for
        /// a flooded wood. Default 0. Water that runs down a slope S, any way, settles at d^(2/3) sqrt(S) /
        /// manning.</summary>
        public double Manning
        {
            get
            {
                double outManning;
                Check(Native.cd_water_get_manning(Handle, &outManning));
                return outManning;
            }
            set
            {
                var manning = value;
                Changed();
                Check(Native.cd_water_set_manning(Handle, manning));
            }
        }

        /// <summary>What is at a side. `value` now, and how fast it changes, `rate` per second, from now on, both at
        /// most 1e60 in size, in CD_FLOAT32 1e30: CD_BORDER_OPEN level of the water outside [m], which is at rest: for
        /// a tide set level and rate anew as it goes. Low waves leave without an echo; some hundredths of high ones
        /// come back. With d the depth in the cell at the side, D the level's depth over the same bed, water leaves by
        /// u = 2 (sqrt(g d) - sqrt(g D)), linear by u = sqrt(g d) (1 - D / d), and the discharge is u d. Where u is
        /// faster than waves, as over a side that lies higher than the level, water falls off: a stream slower than its
        /// waves leaves at critical depth, u = sqrt(g d), a faster one as it comes. CD_BORDER_LEVEL level [m] that is
        /// held at the side itself: with D its depth over the bed of the cell there and q the discharge one face
        /// inside, what leaves tends, as waves cross half a cell, to q + 2 D (sqrt(g d) - sqrt(g D)), advected with q D
        /// / d for q where d &lt; D. Advected water that comes in at U stands U^2 / 2 g lower, at most D / 3. Waves are
        /// thrown back; with lambda = 1/2 some may grow, slowly. What outruns its waves falls off as above.
        /// CD_BORDER_INFLOW discharge per metre of the side [m^2/s] into the water, velocity times depth; into a cell
        /// below critical depth it comes in at that. If negative it leaves, as far as there is water. CD_BORDER_WALL,
        /// CD_BORDER_PERIODIC value and rate mean nothing Both sides of a direction are periodic or neither is: setting
        /// one sets the other, and leaving it leaves both, the opposite one as a wall. Errors: CD_ERROR_ENUM;
        /// CD_ERROR_VALUE.</summary>
        public void SetSide(Side side, Border kind, double value, double rate)
        {
            Changed();
            Check(Native.cd_water_set_side(Handle, (int)side, (int)kind, value, rate));
        }

        /// <summary>Value and rate as of now; 0 where they mean nothing. Each output may be null. Errors:
        /// CD_ERROR_ENUM.</summary>
        public WaterSide GetSide(Side side)
        {
            int outKind;
            double outValue;
            double outRate;
            Check(Native.cd_water_get_side(Handle, (int)side, &outKind, &outValue, &outRate));
            return new WaterSide((Border)outKind, outValue, outRate);
        }

        /// <summary>Depth of an inflow [m], 0 or in [1e-6, 1e30]; default 0: that of the cell at the side. Else
        /// advected water comes in at the speed of its discharge in that depth, as under a gate so far open: faster
        /// than its waves, it has that depth in the first cell; if slower, or if it drowns the gate, that of what comes
        /// after. Other sides, outflow and linear momentum do not use it; cd_water_set_side keeps it. Errors:
        /// CD_ERROR_ENUM; CD_ERROR_VALUE.</summary>
        public void SetInflowDepth(Side side, double depth)
        {
            Changed();
            Check(Native.cd_water_set_inflow_depth(Handle, (int)side, depth));
        }

        /// <summary>Depth of an inflow [m], 0 or in [1e-6, 1e30]; default 0: that of the cell at the side. Else
        /// advected water comes in at the speed of its discharge in that depth, as under a gate so far open: faster
        /// than its waves, it has that depth in the first cell; if slower, or if it drowns the gate, that of what comes
        /// after. Other sides, outflow and linear momentum do not use it; cd_water_set_side keeps it. Errors:
        /// CD_ERROR_ENUM; CD_ERROR_VALUE.</summary>
        public double GetInflowDepth(Side side)
        {
            double outDepth;
            Check(Native.cd_water_get_inflow_depth(Handle, (int)side, &outDepth));
            return outDepth;
        }

        /// <summary>What a write to CD_BED leaves as it is; default CD_BED_LIFTS_WATER. Errors:
        /// CD_ERROR_ENUM.</summary>
        public BedRule BedRule
        {
            get
            {
                int outRule;
                Check(Native.cd_water_get_bed_rule(Handle, &outRule));
                return (BedRule)outRule;
            }
            set
            {
                var rule = value;
                Changed();
                Check(Native.cd_water_set_bed_rule(Handle, (int)rule));
            }
        }

        /// <summary>Switches a field on: no sources, pressure, force or walls yet, all cells there. On already: nothing
        /// happens. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED for a field of other objects;
        /// CD_ERROR_MEMORY.</summary>
        public void EnableField(Field field)
        {
            Changed();
            Check(Native.cd_water_enable_field(Handle, (int)field));
        }

        /// <summary>Switches a field off and releases its memory. Errors: CD_ERROR_ENUM; CD_ERROR_UNSUPPORTED if it is
        /// always there.</summary>
        public void DisableField(Field field)
        {
            Changed();
            Check(Native.cd_water_disable_field(Handle, (int)field));
        }

        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void WriteF32(Field field, long firstX, long firstY, long nX, long nY, params float[] values)
        {
            fixed (float* valuesPointer = values)
                WriteF32Core(field, firstX, firstY, nX, nY, valuesPointer, Native.Length(values));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void WriteF32(Field field, long firstX, long firstY, long nX, long nY, ReadOnlySpan<float> values)
        {
            fixed (float* valuesPointer = &MemoryMarshal.GetReference(values))
                WriteF32Core(field, firstX, firstY, nX, nY, values.Length == 0 ? null : valuesPointer, values.Length);
        }

#endif
        private void WriteF32Core(Field field, long firstX, long firstY, long nX, long nY, float* values,
            long valuesLength)
        {
            long count = Native.Count(valuesLength, 1, "cd_water_write_f32", "values");
            Changed();
            Check(Native.cd_water_write_f32(Handle, (int)field, Native.Size(firstX, "cd_water_write_f32", "first_x"),
                Native.Size(firstY, "cd_water_write_f32", "first_y"), Native.Size(nX, "cd_water_write_f32", "n_x"),
                Native.Size(nY, "cd_water_write_f32", "n_y"), values, Native.Size(count, "cd_water_write_f32",
                "count")));
        }

        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void WriteF64(Field field, long firstX, long firstY, long nX, long nY, params double[] values)
        {
            fixed (double* valuesPointer = values)
                WriteF64Core(field, firstX, firstY, nX, nY, valuesPointer, Native.Length(values));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void WriteF64(Field field, long firstX, long firstY, long nX, long nY, ReadOnlySpan<double> values)
        {
            fixed (double* valuesPointer = &MemoryMarshal.GetReference(values))
                WriteF64Core(field, firstX, firstY, nX, nY, values.Length == 0 ? null : valuesPointer, values.Length);
        }

#endif
        private void WriteF64Core(Field field, long firstX, long firstY, long nX, long nY, double* values,
            long valuesLength)
        {
            long count = Native.Count(valuesLength, 1, "cd_water_write_f64", "values");
            Changed();
            Check(Native.cd_water_write_f64(Handle, (int)field, Native.Size(firstX, "cd_water_write_f64", "first_x"),
                Native.Size(firstY, "cd_water_write_f64", "first_y"), Native.Size(nX, "cd_water_write_f64", "n_x"),
                Native.Size(nY, "cd_water_write_f64", "n_y"), values, Native.Size(count, "cd_water_write_f64",
                "count")));
        }

        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void ReadF32(Field field, long firstX, long firstY, long nX, long nY, float[] outValues)
        {
            fixed (float* outValuesPointer = outValues)
                ReadF32Core(field, firstX, firstY, nX, nY, outValuesPointer, Native.Length(outValues));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void ReadF32(Field field, long firstX, long firstY, long nX, long nY, Span<float> outValues)
        {
            fixed (float* outValuesPointer = &MemoryMarshal.GetReference(outValues))
                ReadF32Core(field, firstX, firstY, nX, nY, outValues.Length == 0 ? null : outValuesPointer,
                    outValues.Length);
        }

#endif
        private void ReadF32Core(Field field, long firstX, long firstY, long nX, long nY, float* outValues,
            long outValuesLength)
        {
            long count = Native.Count(outValuesLength, 1, "cd_water_read_f32", "out_values");
            Check(Native.cd_water_read_f32(Handle, (int)field, Native.Size(firstX, "cd_water_read_f32", "first_x"),
                Native.Size(firstY, "cd_water_read_f32", "first_y"), Native.Size(nX, "cd_water_read_f32", "n_x"),
                Native.Size(nY, "cd_water_read_f32", "n_y"), outValues, Native.Size(count, "cd_water_read_f32",
                "count")));
        }

        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void ReadF64(Field field, long firstX, long firstY, long nX, long nY, double[] outValues)
        {
            fixed (double* outValuesPointer = outValues)
                ReadF64Core(field, firstX, firstY, nX, nY, outValuesPointer, Native.Length(outValues));
        }

#if CONTDYN_SPANS
        /// <summary>Writes or reads values[j][i], dense, of the rectangle of cells or faces [first_x, first_x + n_x) x
        /// [first_y, first_y + n_y); `count` is n_x * n_y. There are nx + 1 x-faces in a row and ny + 1 rows of
        /// y-faces. Numbers are rounded once, to the precision of the side that is narrower. Never allocates. Errors:
        /// CD_ERROR_ENUM, CD_ERROR_UNSUPPORTED, CD_ERROR_DISABLED, CD_ERROR_RANGE; write: CD_ERROR_VALUE, with the
        /// first bad index.</summary>
        public void ReadF64(Field field, long firstX, long firstY, long nX, long nY, Span<double> outValues)
        {
            fixed (double* outValuesPointer = &MemoryMarshal.GetReference(outValues))
                ReadF64Core(field, firstX, firstY, nX, nY, outValues.Length == 0 ? null : outValuesPointer,
                    outValues.Length);
        }

#endif
        private void ReadF64Core(Field field, long firstX, long firstY, long nX, long nY, double* outValues,
            long outValuesLength)
        {
            long count = Native.Count(outValuesLength, 1, "cd_water_read_f64", "out_values");
            Check(Native.cd_water_read_f64(Handle, (int)field, Native.Size(firstX, "cd_water_read_f64", "first_x"),
                Native.Size(firstY, "cd_water_read_f64", "first_y"), Native.Size(nX, "cd_water_read_f64", "n_x"),
                Native.Size(nY, "cd_water_read_f64", "n_y"), outValues, Native.Size(count, "cd_water_read_f64",
                "count")));
        }

        /// <summary>Where a field lies in the water's own memory, in its precision, to read without a copy: the value
        /// of (i, j) is at byte *out_data + i * x_stride + j * y_stride. All but CD_SURFACE, CD_MASK and the walls. The
        /// pointer is good until the field is switched off or the water released; the numbers change with every write
        /// and step. Do not write through it. Errors: CD_ERROR_ENUM, CD_ERROR_DISABLED, CD_ERROR_UNSUPPORTED.</summary>
        public View View(Field field)
        {
            return new View(this, field);
        }

        internal override IntPtr Lie(Field field, long[] strides)
        {
            IntPtr data;
            UIntPtr* s = stackalloc UIntPtr[4];
            Check(Native.cd_water_view(Handle, (int)field, &data, s + 0, s + 1));
            strides[0] = (long)s[0];
            strides[1] = (long)s[1];
            return data;
        }

        /// <summary>Adds volume [m^3] over a disc, or takes it if negative, as far as there is water in each cell's
        /// share. out_added, which may be null, tells what it came to. The account counts it. Errors: CD_ERROR_VALUE,
        /// CD_ERROR_DIVERGED.</summary>
        public double AddVolume(double x, double y, double radius, double volume)
        {
            double outAdded;
            Changed();
            Check(Native.cd_water_add_volume(Handle, x, y, radius, volume, &outAdded));
            return outAdded;
        }

        /// <summary>Adds volume [m^3] evenly over the cells there of a rectangle, or takes it; out_added as above.
        /// Errors: CD_ERROR_RANGE; CD_ERROR_VALUE, CD_ERROR_DIVERGED.</summary>
        public double AddVolumeRectangle(long firstX, long firstY, long nX, long nY, double volume)
        {
            double outAdded;
            Changed();
            Check(Native.cd_water_add_volume_rectangle(Handle, Native.Size(firstX, "cd_water_add_volume_rectangle",
                "first_x"), Native.Size(firstY, "cd_water_add_volume_rectangle", "first_y"), Native.Size(nX,
                "cd_water_add_volume_rectangle", "n_x"), Native.Size(nY, "cd_water_add_volume_rectangle", "n_y"),
                volume, &outAdded));
            return outAdded;
        }

        /// <summary>Adds a source of rate [m^3/s] over a disc to CD_SOURCE, or a drain if negative, and switches that
        /// field on. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.</summary>
        public void AddSource(double x, double y, double radius, double rate)
        {
            Changed();
            Check(Native.cd_water_add_source(Handle, x, y, radius, rate));
        }

        /// <summary>The same evenly over the cells there of a rectangle. Errors: CD_ERROR_RANGE; CD_ERROR_VALUE;
        /// CD_ERROR_MEMORY.</summary>
        public void AddSourceRectangle(long firstX, long firstY, long nX, long nY, double rate)
        {
            Changed();
            Check(Native.cd_water_add_source_rectangle(Handle, Native.Size(firstX, "cd_water_add_source_rectangle",
                "first_x"), Native.Size(firstY, "cd_water_add_source_rectangle", "first_y"), Native.Size(nX,
                "cd_water_add_source_rectangle", "n_x"), Native.Size(nY, "cd_water_add_source_rectangle", "n_y"),
                rate));
        }

        /// <summary>A splash: water of the disc, down to `height` [m] &gt;= 0 at its centre and as far as there is
        /// water, is heaped up on the wet cells around it, out to twice the radius, if there are any; volume is kept.
        /// Errors: CD_ERROR_VALUE, _DIVERGED.</summary>
        public void Splash(double x, double y, double radius, double height)
        {
            Changed();
            Check(Native.cd_water_splash(Handle, x, y, radius, height));
        }

        /// <summary>Adds an impulse (x, y) [N s] over a disc: a face's velocity changes by its share of it / the mass
        /// of water at it, shares in proportion to that mass too; on dry faces nothing happens. Errors: CD_ERROR_VALUE,
        /// CD_ERROR_DIVERGED.</summary>
        public void Impulse(double x, double y, double radius, double impulseX, double impulseY)
        {
            Changed();
            Check(Native.cd_water_impulse(Handle, x, y, radius, impulseX, impulseY));
        }

        /// <summary>How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `n_along`
        /// and `n_across`, 1 to 256: new ones are none (mass 0), those that stay keep what they are unless the plates
        /// change. Without hulls n_along and n_across mean nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. Each
        /// output may be null.</summary>
        public void SetHulls(long count, long nAlong, long nAcross)
        {
            Changed();
            Check(Native.cd_water_set_hulls(Handle, Native.Size(count, "cd_water_set_hulls", "count"),
                Native.Size(nAlong, "cd_water_set_hulls", "n_along"), Native.Size(nAcross, "cd_water_set_hulls",
                "n_across")));
        }

        /// <summary>How many hulls there are, `count`, 0 to 4096, default 0, and how many plates each has, `n_along`
        /// and `n_across`, 1 to 256: new ones are none (mass 0), those that stay keep what they are unless the plates
        /// change. Without hulls n_along and n_across mean nothing. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY. Each
        /// output may be null.</summary>
        public WaterHulls GetHulls()
        {
            UIntPtr outCount;
            UIntPtr outNAlong;
            UIntPtr outNAcross;
            Check(Native.cd_water_get_hulls(Handle, &outCount, &outNAlong, &outNAcross));
            return new WaterHulls((long)outCount, (long)outNAlong, (long)outNAcross);
        }

        /// <summary>Makes a hull of a mass [kg] in [1e-12, 1e15] and length and width [m], &gt;= 1e-60 and at most 512
        /// cells. heights[j][i]: of the floor's plate i along, j to port, above the keel [m], in [0, 1e60], or -1 where
        /// there is none; `count` is n_along n_across; null: flat. Where it is, and how it moves, stays. Errors:
        /// CD_ERROR_VALUE, also for no plate.</summary>
        public void SetHull(long index, double mass, double length, double width, params double[] heights)
        {
            fixed (double* heightsPointer = heights)
                SetHullCore(index, mass, length, width, heightsPointer, Native.Length(heights));
        }

#if CONTDYN_SPANS
        /// <summary>Makes a hull of a mass [kg] in [1e-12, 1e15] and length and width [m], &gt;= 1e-60 and at most 512
        /// cells. heights[j][i]: of the floor's plate i along, j to port, above the keel [m], in [0, 1e60], or -1 where
        /// there is none; `count` is n_along n_across; null: flat. Where it is, and how it moves, stays. Errors:
        /// CD_ERROR_VALUE, also for no plate.</summary>
        public void SetHull(long index, double mass, double length, double width, ReadOnlySpan<double> heights)
        {
            fixed (double* heightsPointer = &MemoryMarshal.GetReference(heights))
                SetHullCore(index, mass, length, width, heights.Length == 0 ? null : heightsPointer, heights.Length);
        }

#endif
        private void SetHullCore(long index, double mass, double length, double width, double* heights,
            long heightsLength)
        {
            long count = Native.Count(heightsLength, 1, "cd_water_set_hull", "heights");
            Changed();
            Check(Native.cd_water_set_hull(Handle, Native.Size(index, "cd_water_set_hull", "index"), mass, length,
                width, heights, Native.Size(count, "cd_water_set_hull", "count")));
        }

        /// <summary>Makes a hull with a flat round floor: those plates of a square whose middles lie in the disc, all
        /// stretched so that their area is the disc's. The radius [m] is &gt;= 1e-60, the square at most 512 cells
        /// wide. Errors: CD_ERROR_VALUE.</summary>
        public void SetDisc(long index, double mass, double radius)
        {
            Changed();
            Check(Native.cd_water_set_disc(Handle, Native.Size(index, "cd_water_set_disc", "index"), mass, radius));
        }

        /// <summary>What a hull is: mass (0: none), length, width, the area of its plates [m^2]. Each output may be
        /// null; heights: `count` of them, or null and any count.</summary>
        public WaterHull GetHull(long index, double[] outHeights)
        {
            fixed (double* outHeightsPointer = outHeights)
                return GetHullCore(index, outHeightsPointer, Native.Length(outHeights));
        }

#if CONTDYN_SPANS
        /// <summary>What a hull is: mass (0: none), length, width, the area of its plates [m^2]. Each output may be
        /// null; heights: `count` of them, or null and any count.</summary>
        public WaterHull GetHull(long index, Span<double> outHeights)
        {
            fixed (double* outHeightsPointer = &MemoryMarshal.GetReference(outHeights))
                return GetHullCore(index, outHeights.Length == 0 ? null : outHeightsPointer, outHeights.Length);
        }

#endif
        private WaterHull GetHullCore(long index, double* outHeights, long outHeightsLength)
        {
            long count = Native.Count(outHeightsLength, 1, "cd_water_get_hull", "out_heights");
            double outMass;
            double outLength;
            double outWidth;
            double outArea;
            Check(Native.cd_water_get_hull(Handle, Native.Size(index, "cd_water_get_hull", "index"), &outMass,
                &outLength, &outWidth, &outArea, outHeights, Native.Size(count, "cd_water_get_hull", "count")));
            return new WaterHull(outMass, outLength, outWidth, outArea);
        }

        /// <summary>What a hull is: mass (0: none), length, width, the area of its plates [m^2]. Each output may be
        /// null; heights: `count` of them, or null and any count.</summary>
        public void RemoveHull(long index)
        {
            Changed();
            Check(Native.cd_water_remove_hull(Handle, Native.Size(index, "cd_water_remove_hull", "index")));
        }

        /// <summary>Launches a hull at (x, y) in the scene, its bow towards (ahead_x, ahead_y) of any length but 0, at
        /// rest. It lies as it would in time. The water that it displaces goes, evenly, to all cells whose surface is
        /// within its draft of that under it; where there is no such cell, or the bed bears it, it displaces none. What
        /// it displaced before is not given back: to move a hull set its pose. Errors: CD_ERROR_VALUE;
        /// CD_ERROR_DISABLED if it has no mass, or no cell is under it, or gravity is 0; CD_ERROR_DIVERGED of a water
        /// that did.</summary>
        public void LaunchHull(long index, double x, double y, double aheadX, double aheadY)
        {
            Changed();
            Check(Native.cd_water_launch_hull(Handle, Native.Size(index, "cd_water_launch_hull", "index"), x, y,
                aheadX, aheadY));
        }

        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void SetHullPose(long index, params double[] pose)
        {
            fixed (double* posePointer = pose)
                SetHullPoseCore(index, posePointer, Native.Length(pose));
        }

#if CONTDYN_SPANS
        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void SetHullPose(long index, ReadOnlySpan<double> pose)
        {
            fixed (double* posePointer = &MemoryMarshal.GetReference(pose))
                SetHullPoseCore(index, pose.Length == 0 ? null : posePointer, pose.Length);
        }

#endif
        private void SetHullPoseCore(long index, double* pose, long poseLength)
        {
            long count = Native.Count(poseLength, 1, "cd_water_set_hull_pose", "pose");
            Changed();
            Check(Native.cd_water_set_hull_pose(Handle, Native.Size(index, "cd_water_set_hull_pose", "index"), pose,
                Native.Size(count, "cd_water_set_hull_pose", "count")));
        }

        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void GetHullPose(long index, double[] outPose)
        {
            fixed (double* outPosePointer = outPose)
                GetHullPoseCore(index, outPosePointer, Native.Length(outPose));
        }

#if CONTDYN_SPANS
        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void GetHullPose(long index, Span<double> outPose)
        {
            fixed (double* outPosePointer = &MemoryMarshal.GetReference(outPose))
                GetHullPoseCore(index, outPose.Length == 0 ? null : outPosePointer, outPose.Length);
        }

#endif
        private void GetHullPoseCore(long index, double* outPose, long outPoseLength)
        {
            long count = Native.Count(outPoseLength, 1, "cd_water_get_hull_pose", "out_pose");
            Check(Native.cd_water_get_hull_pose(Handle, Native.Size(index, "cd_water_get_hull_pose", "index"), outPose,
                Native.Size(count, "cd_water_get_hull_pose", "count")));
        }

        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void SetHullVelocity(long index, params double[] velocity)
        {
            fixed (double* velocityPointer = velocity)
                SetHullVelocityCore(index, velocityPointer, Native.Length(velocity));
        }

#if CONTDYN_SPANS
        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void SetHullVelocity(long index, ReadOnlySpan<double> velocity)
        {
            fixed (double* velocityPointer = &MemoryMarshal.GetReference(velocity))
                SetHullVelocityCore(index, velocity.Length == 0 ? null : velocityPointer, velocity.Length);
        }

#endif
        private void SetHullVelocityCore(long index, double* velocity, long velocityLength)
        {
            long count = Native.Count(velocityLength, 1, "cd_water_set_hull_velocity", "velocity");
            Changed();
            Check(Native.cd_water_set_hull_velocity(Handle, Native.Size(index, "cd_water_set_hull_velocity", "index"),
                velocity, Native.Size(count, "cd_water_set_hull_velocity", "count")));
        }

        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void GetHullVelocity(long index, double[] outVelocity)
        {
            fixed (double* outVelocityPointer = outVelocity)
                GetHullVelocityCore(index, outVelocityPointer, Native.Length(outVelocity));
        }

#if CONTDYN_SPANS
        /// <summary>The body's pose, 7 numbers, and its velocity, 6; see above. The middle lies in the scene, all
        /// others are at most 1e15 in size, and the direction of the bow is given back with length 1. New hulls lie at
        /// 0, heading along x. An obstacle that moves through the water, as heavy as the water in its place or heavier,
        /// has both set before each step; with its keel a third of the water's depth below the bed it presses all water
        /// away. Errors: CD_ERROR_VALUE.</summary>
        public void GetHullVelocity(long index, Span<double> outVelocity)
        {
            fixed (double* outVelocityPointer = &MemoryMarshal.GetReference(outVelocity))
                GetHullVelocityCore(index, outVelocity.Length == 0 ? null : outVelocityPointer, outVelocity.Length);
        }

#endif
        private void GetHullVelocityCore(long index, double* outVelocity, long outVelocityLength)
        {
            long count = Native.Count(outVelocityLength, 1, "cd_water_get_hull_velocity", "out_velocity");
            Check(Native.cd_water_get_hull_velocity(Handle, Native.Size(index, "cd_water_get_hull_velocity", "index"),
                outVelocity, Native.Size(count, "cd_water_get_hull_velocity", "count")));
        }

        /// <summary>The pose in which the floor lies on the water since the last step or launch, to be drawn: 7
        /// numbers.</summary>
        public void GetHullFloor(long index, double[] outPose)
        {
            fixed (double* outPosePointer = outPose)
                GetHullFloorCore(index, outPosePointer, Native.Length(outPose));
        }

#if CONTDYN_SPANS
        /// <summary>The pose in which the floor lies on the water since the last step or launch, to be drawn: 7
        /// numbers.</summary>
        public void GetHullFloor(long index, Span<double> outPose)
        {
            fixed (double* outPosePointer = &MemoryMarshal.GetReference(outPose))
                GetHullFloorCore(index, outPose.Length == 0 ? null : outPosePointer, outPose.Length);
        }

#endif
        private void GetHullFloorCore(long index, double* outPose, long outPoseLength)
        {
            long count = Native.Count(outPoseLength, 1, "cd_water_get_hull_floor", "out_pose");
            Check(Native.cd_water_get_hull_floor(Handle, Native.Size(index, "cd_water_get_hull_floor", "index"),
                outPose, Native.Size(count, "cd_water_get_hull_floor", "count")));
        }

        /// <summary>What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port
        /// and up [N] and moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors:
        /// CD_ERROR_VALUE.</summary>
        public void SetHullForce(long index, params double[] force)
        {
            fixed (double* forcePointer = force)
                SetHullForceCore(index, forcePointer, Native.Length(force));
        }

#if CONTDYN_SPANS
        /// <summary>What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port
        /// and up [N] and moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors:
        /// CD_ERROR_VALUE.</summary>
        public void SetHullForce(long index, ReadOnlySpan<double> force)
        {
            fixed (double* forcePointer = &MemoryMarshal.GetReference(force))
                SetHullForceCore(index, force.Length == 0 ? null : forcePointer, force.Length);
        }

#endif
        private void SetHullForceCore(long index, double* force, long forceLength)
        {
            long count = Native.Count(forceLength, 1, "cd_water_set_hull_force", "force");
            Changed();
            Check(Native.cd_water_set_hull_force(Handle, Native.Size(index, "cd_water_set_hull_force", "index"), force,
                Native.Size(count, "cd_water_set_hull_force", "count")));
        }

        /// <summary>What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port
        /// and up [N] and moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors:
        /// CD_ERROR_VALUE.</summary>
        public void GetHullForce(long index, double[] outForce)
        {
            fixed (double* outForcePointer = outForce)
                GetHullForceCore(index, outForcePointer, Native.Length(outForce));
        }

#if CONTDYN_SPANS
        /// <summary>What acts on a hull from outside until it is set anew, an engine: 6 numbers, forces ahead, to port
        /// and up [N] and moments of yaw, pitch and roll [N m], at most 1e30 in size. Default 0. Errors:
        /// CD_ERROR_VALUE.</summary>
        public void GetHullForce(long index, Span<double> outForce)
        {
            fixed (double* outForcePointer = &MemoryMarshal.GetReference(outForce))
                GetHullForceCore(index, outForce.Length == 0 ? null : outForcePointer, outForce.Length);
        }

#endif
        private void GetHullForceCore(long index, double* outForce, long outForceLength)
        {
            long count = Native.Count(outForceLength, 1, "cd_water_get_hull_force", "out_force");
            Check(Native.cd_water_get_hull_force(Handle, Native.Size(index, "cd_water_get_hull_force", "index"),
                outForce, Native.Size(count, "cd_water_get_hull_force", "count")));
        }

        /// <summary>Drag against the water under it, along the hull and across it [N s/m], which slows turning too, and
        /// Coulomb friction on the bed; in [0, 1e30], default 0. Errors: CD_ERROR_VALUE.</summary>
        public void SetHullDrag(long index, double along, double across, double friction)
        {
            Changed();
            Check(Native.cd_water_set_hull_drag(Handle, Native.Size(index, "cd_water_set_hull_drag", "index"), along,
                across, friction));
        }

        /// <summary>Drag against the water under it, along the hull and across it [N s/m], which slows turning too, and
        /// Coulomb friction on the bed; in [0, 1e30], default 0. Errors: CD_ERROR_VALUE.</summary>
        public WaterHullDrag GetHullDrag(long index)
        {
            double outAlong;
            double outAcross;
            double outFriction;
            Check(Native.cd_water_get_hull_drag(Handle, Native.Size(index, "cd_water_get_hull_drag", "index"),
                &outAlong, &outAcross, &outFriction));
            return new WaterHullDrag(outAlong, outAcross, outFriction);
        }

        /// <summary>What a hull felt from water and bed in the last step: 6 numbers, forces x, y, up [N], moments yaw,
        /// pitch, roll [N m].</summary>
        public void GetHullLoad(long index, double[] outLoad)
        {
            fixed (double* outLoadPointer = outLoad)
                GetHullLoadCore(index, outLoadPointer, Native.Length(outLoad));
        }

#if CONTDYN_SPANS
        /// <summary>What a hull felt from water and bed in the last step: 6 numbers, forces x, y, up [N], moments yaw,
        /// pitch, roll [N m].</summary>
        public void GetHullLoad(long index, Span<double> outLoad)
        {
            fixed (double* outLoadPointer = &MemoryMarshal.GetReference(outLoad))
                GetHullLoadCore(index, outLoad.Length == 0 ? null : outLoadPointer, outLoad.Length);
        }

#endif
        private void GetHullLoadCore(long index, double* outLoad, long outLoadLength)
        {
            long count = Native.Count(outLoadLength, 1, "cd_water_get_hull_load", "out_load");
            Check(Native.cd_water_get_hull_load(Handle, Native.Size(index, "cd_water_get_hull_load", "index"), outLoad,
                Native.Size(count, "cd_water_get_hull_load", "count")));
        }

        /// <summary>Energies of all hulls [J]: of their motion; mass g z, and what their skins hold. Each output may be
        /// null.</summary>
        public WaterHullEnergy GetHullEnergy()
        {
            double outKinetic;
            double outPotential;
            Check(Native.cd_water_get_hull_energy(Handle, &outKinetic, &outPotential));
            return new WaterHullEnergy(outKinetic, outPotential);
        }

        /// <summary>How high [m] the water would stand at n places, at[k] = {x, y}, with no hull pressing on it: its
        /// surface and the head that hulls press with. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside;
        /// CD_ERROR_RANGE for more than fit in memory.</summary>
        public void SampleHeads(double[] at, Outside outside, double[] outHeads)
        {
            fixed (double* atPointer = at)
            fixed (double* outHeadsPointer = outHeads)
                SampleHeadsCore(atPointer, Native.Length(at), outside, outHeadsPointer, Native.Length(outHeads));
        }

#if CONTDYN_SPANS
        /// <summary>How high [m] the water would stand at n places, at[k] = {x, y}, with no hull pressing on it: its
        /// surface and the head that hulls press with. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside;
        /// CD_ERROR_RANGE for more than fit in memory.</summary>
        public void SampleHeads(ReadOnlySpan<double> at, Outside outside, Span<double> outHeads)
        {
            fixed (double* atPointer = &MemoryMarshal.GetReference(at))
            fixed (double* outHeadsPointer = &MemoryMarshal.GetReference(outHeads))
                SampleHeadsCore(at.Length == 0 ? null : atPointer, at.Length, outside,
                    outHeads.Length == 0 ? null : outHeadsPointer, outHeads.Length);
        }

#endif
        private void SampleHeadsCore(double* at, long atLength, Outside outside, double* outHeads, long outHeadsLength)
        {
            long n = Native.Count(atLength, 2, "cd_water_sample_heads", "at");
            Native.Same(outHeads, outHeadsLength, n, "cd_water_sample_heads", "out_heads");
            Check(Native.cd_water_sample_heads(Handle, at, Native.Size(n, "cd_water_sample_heads", "n"), (int)outside,
                outHeads));
        }

        /// <summary>Makes `count` steps of dt [s] each, 0 or in [1e-30, 1e30]: with 0 no time passes, as with 0 steps.
        /// Never allocates. Time is proportional to count * cells, and to the parts that steps are made in (see above).
        /// Errors: CD_ERROR_VALUE; CD_ERROR_DIVERGED if a number leaves the finite range: all steps are made, the
        /// message gives the first bad one, the water can be read, and steps again after cd_water_reset, a load, or
        /// once finite depths and velocities have been written.</summary>
        public void Step(double dt, long count = 1)
        {
            Changed();
            Check(Native.cd_water_step(Handle, dt, Native.Size(count, "cd_water_step", "count")));
        }

        /// <summary>The longest dt at which CD_METHOD_SYMPLECTIC_EULER stays bounded for small waves on the water as it
        /// lies now, whatever method is set: the least of both axes, each exact in the limit of many cells for water of
        /// one depth, a safe lower bound otherwise; for a stream over an uneven bed take 0.8 of it. INFINITY if nothing
        /// can swing.</summary>
        public double StableDt()
        {
            double outDt;
            Check(Native.cd_water_stable_dt(Handle, &outDt));
            return outDt;
        }

        /// <summary>Simulated time [s] and steps made since create or reset, those before a load or a copied state
        /// included.</summary>
        public double GetTime()
        {
            double outTime;
            Check(Native.cd_water_get_time(Handle, &outTime));
            return outTime;
        }

        /// <summary>Simulated time [s] and steps made since create or reset, those before a load or a copied state
        /// included.</summary>
        public ulong GetSteps()
        {
            ulong outSteps;
            Check(Native.cd_water_get_steps(Handle, &outSteps));
            return outSteps;
        }

        /// <summary>How many times lines have been solved along a direction since the water was made: of every sweep
        /// the most parts that a line made its step in, each a factorization of its own, since depths change. Not part
        /// of the saved state.</summary>
        public ulong GetFactorizations()
        {
            ulong outCount;
            Check(Native.cd_water_get_factorizations(Handle, &outCount));
            return outCount;
        }

        /// <summary>What the last call of cd_water_step had to hold back so that no cell gave more than it had and got:
        /// in how many cells, counted once per sweep and part, and how much less water [m^3] went through faces. Each
        /// output may be null.</summary>
        public WaterLimited GetLimited()
        {
            ulong outCells;
            double outVolume;
            Check(Native.cd_water_get_limited(Handle, &outCells, &outVolume));
            return new WaterLimited(outCells, outVolume);
        }

        /// <summary>Lets water sleep where it hardly moves: steps leave parts of 16 x 16 cells as they are, at no cost,
        /// where all waves are lower than `height` [m], in [0, 1e60], and so are all that a step could carry there.
        /// Default 0: nothing sleeps. Neglected are, at each face, a rise of the surface below height / 16, a velocity
        /// below height sqrt(g / d), and water that stands less than the height over the higher bed. What falls asleep
        /// stops, so energy is lost and none gained; volume is kept. Waves lower than the height meet sleeping water as
        /// a wall. The energy bound of long steps, which is one of whole lines, is then one of what is awake of a line.
        /// Awake stay parts with sources or forces, under hulls, and at open, level and inflow sides; and all of the
        /// water while there are higher waves at a periodic side. Which parts sleep follows from the state alone,
        /// whatever hook and kernels; where all are awake a step has the bits of one of water that never sleeps. A
        /// step's time is in proportion to the cells awake, each up to half as dear again. A splash, a volume, an
        /// impulse, a write of cells or faces and what is set of a hull wake what they touch; after any other call that
        /// may change the water the next step looks at all of it, in half a step's time. Costs a byte for ten cells.
        /// The height is kept with the state. Errors: CD_ERROR_VALUE; CD_ERROR_MEMORY.</summary>
        public double Sleep
        {
            get
            {
                double outHeight;
                Check(Native.cd_water_get_sleep(Handle, &outHeight));
                return outHeight;
            }
            set
            {
                var height = value;
                Changed();
                Check(Native.cd_water_set_sleep(Handle, height));
            }
        }

        /// <summary>How many cells were awake in the last step; all, before it and where nothing sleeps. Not part of
        /// the saved state.</summary>
        public long GetAwake()
        {
            UIntPtr outCells;
            Check(Native.cd_water_get_awake(Handle, &outCells));
            return (long)outCells;
        }

        /// <summary>Volume [m^3]: the sum of all depths times the cells' area.</summary>
        public double GetVolume()
        {
            double outVolume;
            Check(Native.cd_water_get_volume(Handle, &outVolume));
            return outVolume;
        }

        /// <summary>The volume account [m^3], kept in double whatever the precision: what was there when it was started
        /// (by create, reset, cd_water_restart_account, or a write of CD_DEPTH, CD_SURFACE or CD_MASK), what came in
        /// since then (sides, sources, volumes added, beds that keep the surface), what went out, and what the present
        /// volume has above initial + in - out, which is rounding. Each output may be null.</summary>
        public WaterAccount GetAccount()
        {
            double outInitial;
            double outIn;
            double outOut;
            double outError;
            Check(Native.cd_water_get_account(Handle, &outInitial, &outIn, &outOut, &outError));
            return new WaterAccount(outInitial, outIn, outOut, outError);
        }

        /// <summary>The volume account [m^3], kept in double whatever the precision: what was there when it was started
        /// (by create, reset, cd_water_restart_account, or a write of CD_DEPTH, CD_SURFACE or CD_MASK), what came in
        /// since then (sides, sources, volumes added, beds that keep the surface), what went out, and what the present
        /// volume has above initial + in - out, which is rounding. Each output may be null.</summary>
        public void RestartAccount()
        {
            Changed();
            Check(Native.cd_water_restart_account(Handle));
        }

        /// <summary>Energies [J]; each output may be null. Kinetic: density / 2 times area, mean depth of both cells
        /// and velocity^2 of faces, at a shore as steps begin with it. Potential: density g times area, depth and
        /// height of the column's middle.</summary>
        public WaterEnergy GetEnergy()
        {
            double outKinetic;
            double outPotential;
            Check(Native.cd_water_get_energy(Handle, &outKinetic, &outPotential));
            return new WaterEnergy(outKinetic, outPotential);
        }

        /// <summary>Area [m^2] of the cells with depth &gt; 0.</summary>
        public double GetWetArea()
        {
            double outArea;
            Check(Native.cd_water_get_wet_area(Handle, &outArea));
            return outArea;
        }

        /// <summary>The largest Courant number of a step of dt [s], in [0, 1e30], over directions and wet faces: (|u| +
        /// sqrt(g d)) dt / dx. Errors: CD_ERROR_VALUE.</summary>
        public double GetCourant(double dt)
        {
            double outCourant;
            Check(Native.cd_water_get_courant(Handle, dt, &outCourant));
            return outCourant;
        }

        /// <summary>The water at n places, at[k] = {x, y} in metres inside the scene: surface [m] and depth [m],
        /// bilinear between cell centres that are there, level beyond the outermost ones; normal of the surface (3
        /// numbers, unit length, z up); velocity [m/s] (2 numbers), bilinear between faces. A dry place has the bed for
        /// its surface. Each output may be null. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside;
        /// CD_ERROR_RANGE for more than fit in memory.</summary>
        public void Sample(double[] at, Outside outside, double[] outSurface, double[] outDepth, double[] outNormal,
            double[] outVelocity)
        {
            fixed (double* atPointer = at)
            fixed (double* outSurfacePointer = outSurface)
            fixed (double* outDepthPointer = outDepth)
            fixed (double* outNormalPointer = outNormal)
            fixed (double* outVelocityPointer = outVelocity)
                SampleCore(atPointer, Native.Length(at), outside, outSurfacePointer, Native.Length(outSurface),
                    outDepthPointer, Native.Length(outDepth), outNormalPointer, Native.Length(outNormal),
                    outVelocityPointer, Native.Length(outVelocity));
        }

#if CONTDYN_SPANS
        /// <summary>The water at n places, at[k] = {x, y} in metres inside the scene: surface [m] and depth [m],
        /// bilinear between cell centres that are there, level beyond the outermost ones; normal of the surface (3
        /// numbers, unit length, z up); velocity [m/s] (2 numbers), bilinear between faces. A dry place has the bed for
        /// its surface. Each output may be null. Errors: CD_ERROR_ENUM; CD_ERROR_VALUE for a place outside;
        /// CD_ERROR_RANGE for more than fit in memory.</summary>
        public void Sample(ReadOnlySpan<double> at, Outside outside, Span<double> outSurface, Span<double> outDepth,
            Span<double> outNormal, Span<double> outVelocity)
        {
            fixed (double* atPointer = &MemoryMarshal.GetReference(at))
            fixed (double* outSurfacePointer = &MemoryMarshal.GetReference(outSurface))
            fixed (double* outDepthPointer = &MemoryMarshal.GetReference(outDepth))
            fixed (double* outNormalPointer = &MemoryMarshal.GetReference(outNormal))
            fixed (double* outVelocityPointer = &MemoryMarshal.GetReference(outVelocity))
                SampleCore(at.Length == 0 ? null : atPointer, at.Length, outside,
                    outSurface.Length == 0 ? null : outSurfacePointer, outSurface.Length,
                    outDepth.Length == 0 ? null : outDepthPointer, outDepth.Length,
                    outNormal.Length == 0 ? null : outNormalPointer, outNormal.Length,
                    outVelocity.Length == 0 ? null : outVelocityPointer, outVelocity.Length);
        }

#endif
        private void SampleCore(double* at, long atLength, Outside outside, double* outSurface, long outSurfaceLength,
            double* outDepth, long outDepthLength, double* outNormal, long outNormalLength, double* outVelocity,
            long outVelocityLength)
        {
            long n = Native.Count(atLength, 2, "cd_water_sample", "at");
            Native.Same(outSurface, outSurfaceLength, n, "cd_water_sample", "out_surface");
            Native.Same(outDepth, outDepthLength, n, "cd_water_sample", "out_depth");
            Native.Same(outNormal, outNormalLength, n * 3, "cd_water_sample", "out_normal");
            Native.Same(outVelocity, outVelocityLength, n * 2, "cd_water_sample", "out_velocity");
            Check(Native.cd_water_sample(Handle, at, Native.Size(n, "cd_water_sample", "n"), (int)outside, outSurface,
                outDepth, outNormal, outVelocity));
        }

        /// <summary>Bytes the water holds from its allocator.</summary>
        public long GetMemory()
        {
            UIntPtr outBytes;
            Check(Native.cd_water_get_memory(Handle, &outBytes));
            return (long)outBytes;
        }

        /// <summary>A 64-bit hash of everything cd_water_save would write. Equal on every machine, compiler and vector
        /// width.</summary>
        public ulong Hash()
        {
            ulong outHash;
            Check(Native.cd_water_hash(Handle, &outHash));
            return outHash;
        }

        /// <summary>Writes a vertex for every cell, cell (i, j) as number j nx + i, into the caller's buffer: vertex k
        /// at byte k * stride, its position, the cell's centre on the surface, as 3 floats at position_offset; its unit
        /// normal as 3 floats at normal_offset; its depth as 1 float at depth_offset, 0 where it is dry and -1 where
        /// the cell is absent, for a shader to fade out shores. normal_offset or depth_offset SIZE_MAX: none. Bytes
        /// between are left alone; any offset and stride will do that keeps them apart. Errors: CD_ERROR_RANGE if size
        /// is less than cells * stride, or an offset and its bytes reach past stride, or two overlap.</summary>
        public void WriteVertices<T>(T[] buffer, long stride, long positionOffset, long normalOffset,
            long depthOffset) where T : struct
        {
            using (var bufferPinned = new Pinned<T>(buffer))
                WriteVerticesCore(bufferPinned.Pointer, bufferPinned.Length, stride, positionOffset, normalOffset,
                    depthOffset);
        }

#if CONTDYN_SPANS
        /// <summary>Writes a vertex for every cell, cell (i, j) as number j nx + i, into the caller's buffer: vertex k
        /// at byte k * stride, its position, the cell's centre on the surface, as 3 floats at position_offset; its unit
        /// normal as 3 floats at normal_offset; its depth as 1 float at depth_offset, 0 where it is dry and -1 where
        /// the cell is absent, for a shader to fade out shores. normal_offset or depth_offset SIZE_MAX: none. Bytes
        /// between are left alone; any offset and stride will do that keeps them apart. Errors: CD_ERROR_RANGE if size
        /// is less than cells * stride, or an offset and its bytes reach past stride, or two overlap.</summary>
        public void WriteVertices(Span<byte> buffer, long stride, long positionOffset, long normalOffset,
            long depthOffset)
        {
            fixed (byte* bufferPointer = &MemoryMarshal.GetReference(buffer))
                WriteVerticesCore(buffer.Length == 0 ? null : bufferPointer, buffer.Length, stride, positionOffset,
                    normalOffset, depthOffset);
        }

#endif
        private void WriteVerticesCore(void* buffer, long bufferLength, long stride, long positionOffset,
            long normalOffset, long depthOffset)
        {
            long size = bufferLength;
            Check(Native.cd_water_write_vertices(Handle, buffer, Native.Size(size, "cd_water_write_vertices", "size"),
                Native.Size(stride, "cd_water_write_vertices", "stride"), Native.Size(positionOffset,
                "cd_water_write_vertices", "position_offset"), Native.SizeOrNone(normalOffset,
                "cd_water_write_vertices", "normal_offset"), Native.SizeOrNone(depthOffset, "cd_water_write_vertices",
                "depth_offset")));
        }

        /// <summary>How many indices cd_water_write_indices writes now: 6 per square of four neighbouring cells that
        /// are there, 3 per square of which three are. skip_dry 1: squares without a wet cell are left out, so that it
        /// changes with the water. Errors: CD_ERROR_VALUE for a skip_dry neither 0 nor 1.</summary>
        public long GetIndexCount(bool skipDry)
        {
            UIntPtr outCount;
            Check(Native.cd_water_get_index_count(Handle, skipDry ? 1 : 0, &outCount));
            return (long)outCount;
        }

        /// <summary>Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte
        /// order), counter- clockwise seen from above. `size` is that of the buffer in bytes. 65535 with 2 bytes and
        /// 2^32 - 1 with 4 are never written. Errors: CD_ERROR_VALUE for another index_size, or skip_dry neither 0 nor
        /// 1; CD_ERROR_RANGE if size is too small; CD_ERROR_UNSUPPORTED for more than 65535 or 2^32 - 1
        /// cells.</summary>
        public void WriteIndices<T>(bool skipDry, T[] buffer, long indexSize) where T : struct
        {
            using (var bufferPinned = new Pinned<T>(buffer))
                WriteIndicesCore(skipDry, bufferPinned.Pointer, bufferPinned.Length, indexSize);
        }

#if CONTDYN_SPANS
        /// <summary>Writes the triangles as vertex numbers of index_size 2 or 4 bytes (unsigned, the machine's byte
        /// order), counter- clockwise seen from above. `size` is that of the buffer in bytes. 65535 with 2 bytes and
        /// 2^32 - 1 with 4 are never written. Errors: CD_ERROR_VALUE for another index_size, or skip_dry neither 0 nor
        /// 1; CD_ERROR_RANGE if size is too small; CD_ERROR_UNSUPPORTED for more than 65535 or 2^32 - 1
        /// cells.</summary>
        public void WriteIndices(bool skipDry, Span<byte> buffer, long indexSize)
        {
            fixed (byte* bufferPointer = &MemoryMarshal.GetReference(buffer))
                WriteIndicesCore(skipDry, buffer.Length == 0 ? null : bufferPointer, buffer.Length, indexSize);
        }

#endif
        private void WriteIndicesCore(bool skipDry, void* buffer, long bufferLength, long indexSize)
        {
            long size = bufferLength;
            Check(Native.cd_water_write_indices(Handle, skipDry ? 1 : 0, buffer, Native.Size(size,
                "cd_water_write_indices", "size"), Native.Size(indexSize, "cd_water_write_indices", "index_size")));
        }

        /// <summary>The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but
        /// the callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_water_save_size and tells what it wrote. load needs a water of as many cells and the same precision,
        /// takes the cells' size over, and switches fields on and off as they were. Bytes that are damaged, cut short,
        /// of a later version or another kind are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT,
        /// CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public long SaveSize()
        {
            UIntPtr outSize;
            Check(Native.cd_water_save_size(Handle, &outSize));
            return (long)outSize;
        }

        /// <summary>The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but
        /// the callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_water_save_size and tells what it wrote. load needs a water of as many cells and the same precision,
        /// takes the cells' size over, and switches fields on and off as they were. Bytes that are damaged, cut short,
        /// of a later version or another kind are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT,
        /// CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public long Save<T>(T[] buffer) where T : struct
        {
            using (var bufferPinned = new Pinned<T>(buffer))
                return SaveCore(bufferPinned.Pointer, bufferPinned.Length);
        }

#if CONTDYN_SPANS
        /// <summary>The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but
        /// the callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_water_save_size and tells what it wrote. load needs a water of as many cells and the same precision,
        /// takes the cells' size over, and switches fields on and off as they were. Bytes that are damaged, cut short,
        /// of a later version or another kind are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT,
        /// CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public long Save(Span<byte> buffer)
        {
            fixed (byte* bufferPointer = &MemoryMarshal.GetReference(buffer))
                return SaveCore(buffer.Length == 0 ? null : bufferPointer, buffer.Length);
        }

#endif
        private long SaveCore(void* buffer, long bufferLength)
        {
            long size = bufferLength;
            UIntPtr outWritten;
            Check(Native.cd_water_save(Handle, buffer, Native.Size(size, "cd_water_save", "size"), &outWritten));
            return (long)outWritten;
        }

        /// <summary>The same into a new array.</summary>
        public byte[] Save()
        {
            var bytes = new byte[SaveSize()];
            Array.Resize(ref bytes, (int)Save(bytes));
            return bytes;
        }

        /// <summary>The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but
        /// the callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_water_save_size and tells what it wrote. load needs a water of as many cells and the same precision,
        /// takes the cells' size over, and switches fields on and off as they were. Bytes that are damaged, cut short,
        /// of a later version or another kind are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT,
        /// CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public void Load<T>(T[] bytes) where T : struct
        {
            using (var bytesPinned = new Pinned<T>(bytes))
                LoadCore(bytesPinned.Pointer, bytesPinned.Length);
        }

#if CONTDYN_SPANS
        /// <summary>The whole state as bytes: shape, parameters, fields, time, account: all the future depends on but
        /// the callbacks. Little-endian on every machine, versioned, with a checksum. save needs size &gt;=
        /// cd_water_save_size and tells what it wrote. load needs a water of as many cells and the same precision,
        /// takes the cells' size over, and switches fields on and off as they were. Bytes that are damaged, cut short,
        /// of a later version or another kind are refused. Errors: save: CD_ERROR_RANGE. load: CD_ERROR_FORMAT,
        /// CD_ERROR_MISMATCH, CD_ERROR_MEMORY.</summary>
        public void Load(ReadOnlySpan<byte> bytes)
        {
            fixed (byte* bytesPointer = &MemoryMarshal.GetReference(bytes))
                LoadCore(bytes.Length == 0 ? null : bytesPointer, bytes.Length);
        }

#endif
        private void LoadCore(void* bytes, long bytesLength)
        {
            long size = bytesLength;
            Changed();
            Check(Native.cd_water_load(Handle, bytes, Native.Size(size, "cd_water_load", "size")));
        }

        /// <summary>Makes `water` what `source` is, as save and load would, without the bytes: the two must agree in
        /// cells and precision. Allocates only if they differ in the fields switched on. Errors: CD_ERROR_MISMATCH,
        /// CD_ERROR_MEMORY.</summary>
        public void CopyState(Water source)
        {
            Changed();
            Check(Native.cd_water_copy_state(Handle, Native.NotNull(source, "source").Handle));
        }

        /// <summary>Depths, velocities, time, steps and account back to 0, hulls to where new ones lie, at rest. Bed,
        /// parameters and the other fields stay, and what hulls are. What is at sides begins again with time: a level
        /// or discharge that changes is what it was at time 0, or by its rate would have been if it was set later; then
        /// set it anew.</summary>
        public void Reset()
        {
            Changed();
            Check(Native.cd_water_reset(Handle));
        }
    }
}
