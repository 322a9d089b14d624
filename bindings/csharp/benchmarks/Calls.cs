// What calls cost, in nanoseconds: the least of many rounds.
using System;
using System.Diagnostics;
using Contdyn;

static class Calls
{
    const int Rounds = 100, Count = 10000;

    static void Row(string name, Action<int> run)
    {
        long best = long.MaxValue;
        for (int round = 0; round < Rounds; ++round)
        {
            var watch = Stopwatch.StartNew();
            run(Count);
            best = Math.Min(best, watch.ElapsedTicks);
        }
        Console.WriteLine("| {0} | {1:0} |", name, best * 1e9 / Stopwatch.Frequency / Count);
    }

    static void Main()
    {
        var rope = new Chain(1, 10, 3);
        var gravity = new double[3];
        var at = rope.View(Field.Position);
        double sum = 0;
        Row("`Mass`, read", count => { for (int k = 0; k < count; ++k) sum += rope.Mass; });
        Row("`SetGravity`, of an array", count => { for (int k = 0; k < count; ++k) rope.SetGravity(gravity); });
        Row("`Step` of 11 nodes, 3 components", count => { for (int k = 0; k < count; ++k) rope.Step(1e-3); });
        Row("one number of a view", count => { for (int k = 0; k < count; ++k) sum += at[0, 5, 1]; });
        GC.KeepAlive(sum);
    }
}
