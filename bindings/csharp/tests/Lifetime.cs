// Objects release what they hold, once; nothing dangles; callbacks.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using System.Threading.Tasks;
using Contdyn;

static class Lifetime
{
    // Counts what an object holds.
    sealed class Heap
    {
        readonly Dictionary<IntPtr, IntPtr> held = new Dictionary<IntPtr, IntPtr>();
        public readonly AllocatorCallbacks Table = new AllocatorCallbacks();

        public Heap()
        {
            Table.Allocate = (size, alignment) =>
            {
                lock (held)
                {
                    var block = Marshal.AllocHGlobal(new IntPtr(size + alignment));
                    var aligned = new IntPtr((block.ToInt64() / alignment + 1) * alignment);
                    held[aligned] = block;
                    return aligned;
                }
            };
            Table.Release = (pointer, size, alignment) =>
            {
                lock (held)
                {
                    Marshal.FreeHGlobal(held[pointer]);
                    held.Remove(pointer);
                }
            };
        }

        public int Live { get { lock (held) return held.Count; } }
    }

    // Colliders that nothing is near to, each of a callback of its own.
    static WeakReference[] GiveFloors(Chain rope, int[] asked)
    {
        return asked.Select((none, index) =>
        {
            var floor = new DistanceCallbacks();
            floor.Distance = (time, count, components, positions, distances, normals) =>
            {
                ++asked[index];
                for (int k = 0; k < count; ++k)
                    Marshal.Copy(new double[] { 1 }, 0, distances + k * sizeof(double), 1);
                for (int k = 0; k < count; ++k)
                    Marshal.Copy(new double[] { 0, 1 }, 0, normals + 2 * k * sizeof(double), 2);
            };
            rope.SetCallback(index, floor, new double[] { 0, 0 }, 0);
            return new WeakReference(floor);
        }).ToArray();
    }

    static Chain Large()
    {
        var made = new Chain(100, 20, 3);
        made.SetGravity(0, -1, 0);
        made.SetEnd(End.First, Node.Pinned);
        return made;
    }

    static void Dropped(Heap heap)
    {
        for (int k = 0; k < 10; ++k) new Chain(1, 10, 3, Precision.Float32, heap.Table).Step(0.01);
    }

    public static void All()
    {
        Tests.Run("a disposed object, its views and copies from it", () =>
        {
            var heap = new Heap();
            var rope = new Chain(1, 4, 2, Precision.Float64, heap.Table);
            var at = rope.View(Field.Position);
            Tests.True(heap.Live > 0, "held");
            rope.Dispose();
            rope.Dispose();
            Tests.Equal(heap.Live, 0);
            Tests.Throws<ObjectDisposedException>(() => rope.Step(0.01));
            Tests.Throws<ObjectDisposedException>(() => at[0, 0, 0].ToString());
            Tests.Throws<ObjectDisposedException>(() => new Chain(1, 4, 2).CopyState(rope));
        });
        Tests.Run("a view of a field that was switched off", () =>
        {
            var rope = new Chain(1, 4, 2);
            rope.EnableField(Field.Force);
            var force = rope.View(Field.Force);
            Tests.Equal(force[0, 0, 0], 0.0);
            rope.DisableField(Field.Force);
            Tests.Refused(Status.ErrorDisabled, "cd_chain_view", () => force[0, 0, 0].ToString());
            rope.EnableField(Field.Force);
            Tests.Equal(force[0, 4, 1], 0.0);
        });
        Tests.Run("collected objects give their memory back", () =>
        {
            var heap = new Heap();
            var thread = new Thread(() => Dropped(heap)); // none of its frames keeps them
            thread.Start();
            thread.Join();
            for (int k = 0; k < 10 && heap.Live > 0; ++k)
            {
                GC.Collect();
                GC.WaitForPendingFinalizers();
            }
            Tests.Equal(heap.Live, 0);
        });
        Tests.Run("a failed create makes nothing", () =>
        {
            var empty = new AllocatorCallbacks { Allocate = (s, a) => IntPtr.Zero, Release = (p, s, a) => { } };
            Tests.Refused(Status.ErrorMemory, "cd_water_create", () => new Water(4, 4, 1, 1, Precision.Float64, empty));
            Tests.Refused(Status.ErrorValue, "cd_chain_create: components is 5", () => new Chain(1, 10, 5));
            var throwing = new AllocatorCallbacks { Allocate = (s, a) => { throw new TimeoutException(); } };
            throwing.Release = empty.Release;
            Tests.Throws<TimeoutException>(() => new Chain(1, 4, 2, Precision.Float64, throwing));
        });
        Tests.Run("failed calls change nothing", () =>
        {
            var rope = new Chain(1, 4, 1);
            var before = rope.Hash();
            Tests.Refused(Status.ErrorValue, "mass is -1", () => rope.Mass = -1);
            Tests.Equal(rope.Hash(), before);
            rope.Method = Method.ForwardEuler;
            rope.Stiffness = 1e50;
            rope.WriteF64(Field.Position, 0, 1, 2, 1, 1e300);
            Tests.Refused(Status.ErrorDiverged, "cd_chain_step", () => rope.Step(1, 1000));
            rope.Reset();
            Tests.Refused(Status.ErrorMismatch, "cd_chain_copy_state", () => rope.CopyState(new Chain(1, 5, 1)));
            Tests.Refused(Status.ErrorFormat, "cd_chain_load", () => rope.Load(new byte[] { 1, 2, 3 }));
        });
        Tests.Run("objects go to other threads", () =>
        {
            var here = Large();
            here.Step(0.01, 10);
            var hashes = Enumerable.Range(0, 4).AsParallel().Select(k =>
            {
                using (var rope = Large())
                {
                    rope.Step(0.01, 10);
                    return rope.Hash();
                }
            });
            Tests.True(hashes.All(hash => hash == here.Hash()), "hashes");
        });
        Tests.Run("work is spread, and the bits are the same", () =>
        {
            Chain alone = Large(), spread = Large();
            long pieces = 0;
            spread.SetParallel(new ParallelCallbacks
            {
                Run = (count, task) => Parallel.For(0, count, index =>
                {
                    task(index);
                    Interlocked.Increment(ref pieces);
                })
            });
            GC.Collect(); // the object keeps its callbacks
            GC.WaitForPendingFinalizers();
            alone.Step(0.01, 20);
            spread.Step(0.01, 20);
            Tests.True(pieces > 1, "pieces");
            Tests.Equal(spread.Hash(), alone.Hash());
            long before = pieces;
            spread.SetParallel(null);
            spread.Step(0.01);
            Tests.Equal(pieces, before);
        });
        Tests.Run("each collider keeps its own callback", () =>
        {
            var rope = new Chain(1, 4, 2) { RestLength = 1 };
            var asked = new int[8];
            WeakReference[] given = null;
            rope.Colliders = asked.Length;
            var thread = new Thread(() => given = GiveFloors(rope, asked)); // whose stack holds none of them any longer
            thread.Start();
            thread.Join();
            GC.Collect();
            GC.WaitForPendingFinalizers();
            Tests.True(given.All(callbacks => callbacks.IsAlive), "callbacks are kept");
            rope.Step(0.01);
            Tests.True(asked.All(times => times > 0), "callbacks are asked");
        });
        Tests.Run("an exception in a callback comes out of the call", () =>
        {
            var made = Large();
            made.SetParallel(new ParallelCallbacks { Run = (count, task) => { throw new TimeoutException(); } });
            Tests.Throws<TimeoutException>(() => made.Step(0.01));
            made.SetParallel(null);
            made.Step(0.01);
        });
    }
}
