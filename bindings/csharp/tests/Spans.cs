// The overloads that take spans, in what is built with CONTDYN_SPANS.
#if CONTDYN_SPANS
using System;
using System.Linq;
using Contdyn;

static class Spans
{
    public static void All()
    {
        Tests.Run("spans", () =>
        {
            Chain rope = new Chain(2, 3, 2), other = new Chain(2, 3, 2);
            var positions = Enumerable.Range(1, 16).Select(k => k / 8.0).ToArray();
            rope.Write(Field.Position, positions);
            other.Write(Field.Position, new ReadOnlySpan<double>(positions));
            Tests.Equal(other.Hash(), rope.Hash());
            other.WriteF32(Field.Position, 0, 2, 0, 4, new ReadOnlySpan<float>(new float[16]));
            other.Load(new ReadOnlySpan<byte>(rope.Save()));
            Tests.Equal(other.Hash(), rope.Hash());
            var read = new double[16];
            rope.Read(Field.Position, new Span<double>(read));
            Tests.True(read.SequenceEqual(positions), "positions");
            var part = new double[3];
            rope.ReadF64(Field.Position, 1, 1, 2, 1, new Span<double>(part, 1, 2)); // a part of an array
            Tests.True(part.SequenceEqual(new[] { 0, positions[12], positions[13] }), "a part");
            rope.SetGravity(new ReadOnlySpan<double>(new[] { 0.0, -9.81 }));
            var gravity = new double[2];
            rope.GetGravity(new Span<double>(gravity));
            Tests.Equal(gravity[1], -9.81);
            Tests.Refused(Status.ErrorRange, "cd_chain_set_gravity: count is 3",
                () => rope.SetGravity(new ReadOnlySpan<double>(new double[3])));
            var pool = new Water(4, 4, 1, 1);
            var depth = new double[1];
            pool.Sample(new ReadOnlySpan<double>(new[] { 1.0, 1.0 }), Outside.Refused, default(Span<double>),
                new Span<double>(depth), default(Span<double>), default(Span<double>)); // none of the others
            Tests.Refused(Status.ErrorRange, "out_depth has 1 numbers, must have 2", () => pool.Sample(
                new ReadOnlySpan<double>(new double[4]), Outside.Refused, default(Span<double>),
                new Span<double>(depth), default(Span<double>), default(Span<double>)));
        });
    }
}
#endif
