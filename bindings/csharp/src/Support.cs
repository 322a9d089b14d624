// What the methods in Api.cs are made with: errors, lengths, handles, callbacks, whole fields and views.
#if NETSTANDARD2_1_OR_GREATER || NETCOREAPP2_1_OR_GREATER || UNITY_2021_2_OR_NEWER
#define CONTDYN_SPANS
#endif
using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.ExceptionServices;
using System.Runtime.InteropServices;

namespace Contdyn
{
    /// <summary>Why a call failed: its status, and as its message the library's, which names the function, the argument
    /// and its value.</summary>
    public sealed class ContdynException : Exception
    {
        public Status Status { get; private set; }

        internal ContdynException(Status status, string message) : base(message)
        {
            Status = status;
        }
    }

    internal static unsafe partial class Native
    {
#if (UNITY_IOS || UNITY_WEBGL) && !UNITY_EDITOR
        internal const string Library = "__Internal";
#else
        internal const string Library = "contdyn";
#endif

        internal static string Text(IntPtr text)
        {
            return Marshal.PtrToStringAnsi(text);
        }

        internal static ContdynException LeftOut(string function)
        {
            return new ContdynException(Status.ErrorUnsupported, function + ": this build of the library leaves it out");
        }

        internal static void Check(int status, Callbacks callbacks = null)
        {
            if (callbacks != null) callbacks.Rethrow();
            if (status != 0) throw new ContdynException((Status)status, Text(cd_error_message()));
        }

        /// <summary>That the library is the one that Native.cs was made for: before 1.0 every minor version may change
        /// the API.</summary>
        internal static void CheckVersion()
        {
            if (cd_version() / 1000 == Major * 1000 + Minor) return;
            throw new ContdynException(Status.ErrorUnsupported, "the library is contdyn " + Text(cd_version_string()) +
                ", and this assembly is written for " + Major + "." + Minor);
        }

        private static Exception Range(string function, string name, string what)
        {
            return new ContdynException(Status.ErrorRange, function + ": " + name + what);
        }

        internal static UIntPtr Size(long value, string function, string name)
        {
            if (value < 0 || UIntPtr.Size == 4 && value > uint.MaxValue)
                throw Range(function, name, " is " + value + ", must be at least 0 and fit a size");
            return (UIntPtr)(ulong)value;
        }

        /// <summary>Of an argument that may be SizeMax.</summary>
        internal static UIntPtr SizeOrNone(long value, string function, string name)
        {
            if (value != Contdyn.Library.SizeMax) return Size(value, function, name);
            return UIntPtr.Size == 4 ? (UIntPtr)uint.MaxValue : (UIntPtr)ulong.MaxValue;
        }

        internal static long Length(Array array)
        {
            return array == null ? 0 : array.LongLength;
        }

        /// <summary>How many places numbers are for, `each` of them for one.</summary>
        internal static long Count(long length, long each, string function, string name)
        {
            if (length % each != 0)
                throw Range(function, name, " has " + length + " numbers, must be a multiple of " + each);
            return length / each;
        }

        internal static void Same(void* pointer, long length, long wanted, string function, string name)
        {
            if (pointer != null && length != wanted)
                throw Range(function, name, " has " + length + " numbers, must have " + wanted);
        }

        internal static T NotNull<T>(T value, string name) where T : class
        {
            if (value == null) throw new ArgumentNullException(name);
            return value;
        }
    }

    /// <summary>An array of plain structs that the collector leaves where it is.</summary>
    internal unsafe struct Pinned<T> : IDisposable where T : struct
    {
        private GCHandle pin;
        internal readonly long Length;

        internal Pinned(T[] array)
        {
            pin = GCHandle.Alloc(array, GCHandleType.Pinned);
            Length = Native.Length(array) * Marshal.SizeOf(typeof(T));
        }

        internal void* Pointer { get { return (void*)pin.AddrOfPinnedObject(); } }

        public void Dispose()
        {
            pin.Free();
        }
    }

    /// <summary>Owns one object of the library, and what it may call.</summary>
    internal abstract class ObjectHandle : SafeHandle
    {
        private readonly Dictionary<string, Callbacks> kept = new Dictionary<string, Callbacks>();

        protected ObjectHandle(IntPtr handle) : base(IntPtr.Zero, true)
        {
            SetHandle(handle);
        }

        public override bool IsInvalid { get { return handle == IntPtr.Zero; } }

        // name: of what calls back, with its number where the object has several, as colliders are.
        internal void Keep(string name, Callbacks callbacks)
        {
            kept[name] = callbacks;
        }

        internal void Rethrow()
        {
            foreach (var callbacks in kept.Values)
                if (callbacks != null) callbacks.Rethrow();
        }
    }

    /// <summary>Functions that the library calls. Set them before they are given to an object, which keeps them.
    /// </summary>
    public abstract unsafe class Callbacks
    {
        private Delegate[] natives;
        private IntPtr[] members;
        private GCHandle pin;
        private Exception raised;

        internal abstract void* Struct();

        internal void* Made(params Delegate[] functions)
        {
            if (members == null)
            {
                natives = functions; // what is called must not be collected
                members = new IntPtr[functions.Length];
                for (int k = 0; k < functions.Length; ++k)
                    if (functions[k] != null) members[k] = Marshal.GetFunctionPointerForDelegate(functions[k]);
                pin = GCHandle.Alloc(members, GCHandleType.Pinned);
            }
            return (void*)pin.AddrOfPinnedObject();
        }

        ~Callbacks()
        {
            if (pin.IsAllocated) pin.Free();
            GC.KeepAlive(natives);
        }

        /// <summary>Exceptions must not pass through the library: the call that called back throws them.</summary>
        internal void Raised(Exception exception)
        {
            raised = raised ?? exception;
        }

        internal void Rethrow()
        {
            var first = raised;
            raised = null;
            if (first != null) ExceptionDispatchInfo.Capture(first).Throw();
        }
    }

    /// <summary>How many places a field has along the two directions of its range: for each which size counts it, 0 for
    /// none, how many more there are, and which flag of a ring adds one, 0 for none.</summary>
    internal sealed class FieldRow
    {
        internal readonly int[] Extents;
        internal readonly bool Components, OneButInRopes;

        internal FieldRow(int[] extents, bool components, bool oneButInRopes)
        {
            Extents = extents;
            Components = components;
            OneButInRopes = oneButInRopes;
        }
    }

    /// <summary>Extents of a whole field and how many values a place has; all 0 for a field that the object has not,
    /// which the library then tells.</summary>
    internal struct Whole
    {
        internal readonly long A, B, Values;

        internal Whole(FieldRow row, long[] sizes, bool[] ring, bool isRope, long components)
        {
            A = row.OneButInRopes && !isRope ? 1 : Extent(row, 0, sizes, ring);
            B = Extent(row, 3, sizes, ring);
            Values = row.Components ? components : 1;
        }

        private static long Extent(FieldRow row, int at, long[] sizes, bool[] ring)
        {
            int size = row.Extents[at], flag = row.Extents[at + 2];
            return row.Extents[at + 1] + (size > 0 ? sizes[size - 1] : 0) + (flag > 0 && ring[flag - 1] ? 1 : 0);
        }

        internal long Count { get { return A * B * Values; } }

        internal long[] Range(bool alternates)
        {
            return alternates ? new[] { 0, A, 0, B } : new[] { 0, 0, A, B };
        }
    }

    /// <summary>An object of the library. Use it in a `using` statement, Dispose it, or leave that to the collector.
    /// One thread at a time may use it.</summary>
    public abstract unsafe class LibraryObject : IDisposable
    {
        private ObjectHandle handle;

        internal ObjectHandle Handle { get { return handle; } }
        internal long Version { get; private set; }

        internal void Own(ObjectHandle made)
        {
            handle = made;
        }

        /// <summary>Before a call that may change where fields lie.</summary>
        internal void Changed()
        {
            ++Version;
        }

        internal void Check(int status)
        {
            handle.Rethrow();
            Native.Check(status);
        }

        /// <summary>Releases the object: calls on it and its views throw ObjectDisposedException afterwards.</summary>
        public void Dispose()
        {
            Changed();
            handle.Dispose();
        }

        internal abstract IntPtr Lie(Field field, long[] strides);
        internal abstract Whole Extents(Field field);
        internal abstract Precision Stored { get; }
        internal abstract void ReadWhole(Field field, Whole whole, float* outValues, long count);
        internal abstract void ReadWhole(Field field, Whole whole, double* outValues, long count);
        internal abstract void WriteWhole(Field field, Whole whole, float* values, long count);
        internal abstract void WriteWhole(Field field, Whole whole, double* values, long count);

        /// <summary>How many values a whole field has.</summary>
        public long GetSize(Field field)
        {
            var whole = Extents(field);
            if (whole.Count == 0) ReadWhole(field, whole, (double*)null, 0); // says which fields there are
            return whole.Count;
        }

        /// <summary>All values of a field.</summary>
        public double[] Read(Field field)
        {
            var values = new double[GetSize(field)];
            Read(field, values);
            return values;
        }

        /// <summary>All values of a field, into an array of as many.</summary>
        public void Read(Field field, double[] values)
        {
            fixed (double* pointer = values) ReadWhole(field, Extents(field), pointer, Native.Length(values));
        }

        /// <summary>All values of a field as float, into an array of as many.</summary>
        public void Read(Field field, float[] values)
        {
            fixed (float* pointer = values) ReadWhole(field, Extents(field), pointer, Native.Length(values));
        }

        /// <summary>Writes all values of a field.</summary>
        public void Write(Field field, double[] values)
        {
            fixed (double* pointer = values) WriteWhole(field, Extents(field), pointer, Native.Length(values));
        }

        /// <summary>Writes all values of a field.</summary>
        public void Write(Field field, float[] values)
        {
            fixed (float* pointer = values) WriteWhole(field, Extents(field), pointer, Native.Length(values));
        }
#if CONTDYN_SPANS

        /// <summary>All values of a field, into a span of as many.</summary>
        public void Read(Field field, Span<double> values)
        {
            fixed (double* pointer = &MemoryMarshal.GetReference(values))
                ReadWhole(field, Extents(field), pointer, values.Length);
        }

        /// <summary>All values of a field as float, into a span of as many.</summary>
        public void Read(Field field, Span<float> values)
        {
            fixed (float* pointer = &MemoryMarshal.GetReference(values))
                ReadWhole(field, Extents(field), pointer, values.Length);
        }

        /// <summary>Writes all values of a field.</summary>
        public void Write(Field field, ReadOnlySpan<double> values)
        {
            fixed (double* pointer = &MemoryMarshal.GetReference(values))
                WriteWhole(field, Extents(field), pointer, values.Length);
        }

        /// <summary>Writes all values of a field.</summary>
        public void Write(Field field, ReadOnlySpan<float> values)
        {
            fixed (float* pointer = &MemoryMarshal.GetReference(values))
                WriteWhole(field, Extents(field), pointer, values.Length);
        }
#endif
    }

    /// <summary>A field where it lies in its object's memory. It follows steps and writes and never dangles: it asks
    /// the library anew after every call that may have moved the field, and then throws if the field or the object is
    /// gone.</summary>
    public sealed unsafe class View
    {
        private readonly LibraryObject owner;
        private readonly Field field;
        private readonly long[] strides = new long[4];
        private byte* data;
        private Whole whole;
        private bool single;
        private long version = -1;

        internal View(LibraryObject owner, Field field)
        {
            this.owner = owner;
            this.field = field;
            Refresh();
        }

        private void Refresh()
        {
            data = (byte*)owner.Lie(field, strides);
            whole = owner.Extents(field);
            single = owner.Stored == Precision.Float32;
            version = owner.Version;
        }

        /// <summary>How many places there are along the two directions, and how many values each has.</summary>
        public long[] Extents
        {
            get
            {
                if (version != owner.Version) Refresh();
                return new[] { whole.A, whole.B, whole.Values };
            }
        }

        /// <summary>The number at a place, such as strand, node and component.</summary>
        public double this[long i, long j, long k = 0]
        {
            get
            {
                if (version != owner.Version) Refresh();
                if ((ulong)i >= (ulong)whole.A || (ulong)j >= (ulong)whole.B || (ulong)k >= (ulong)whole.Values)
                    throw new IndexOutOfRangeException("no place (" + i + ", " + j + ", " + k + ") in " + whole.A +
                        " x " + whole.B + " x " + whole.Values);
                byte* at = data + i * strides[0] + j * strides[1] + k * strides[2];
                double number = single ? *(float*)at : *(double*)at;
                GC.KeepAlive(owner);
                return number;
            }
        }
    }
}
