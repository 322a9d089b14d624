// Arrays in and out, lengths that do not fit, whole fields, views.
using System;
using System.Linq;
using Contdyn;

static class Arrays
{
    struct Vertex
    {
        public float X, Y, Z, NormalX, NormalY, NormalZ, Depth;
    }

    static readonly double[] positions = Enumerable.Range(1, 16).Select(k => k / 8.0).ToArray();

    static Chain Rope(Precision precision = Precision.Float64)
    {
        var made = new Chain(2, 3, 2, precision);
        made.Write(Field.Position, positions);
        return made;
    }

    public static void All()
    {
        Tests.Run("reads give what was written", Reads);
        Tests.Run("whole fields", WholeFields);
        Tests.Run("sizes of rings, ropes and faces", Sizes);
        Tests.Run("results", Results);
        Tests.Run("lengths that do not fit", Lengths);
        Tests.Run("views", Views);
    }

    static void Reads()
    {
        foreach (Precision precision in Enum.GetValues(typeof(Precision)))
        {
            var made = Rope(precision);
            Tests.True(made.Read(Field.Position).SequenceEqual(positions), "doubles");
            var singles = new float[16];
            made.Read(Field.Position, singles);
            Tests.True(singles.Select(x => (double)x).SequenceEqual(positions), "floats");
            var part = new double[4];
            made.ReadF64(Field.Position, 1, 1, 2, 2, part);
            Tests.True(part.SequenceEqual(positions.Skip(12)), "a part");
            var other = new Chain(2, 3, 2, precision);
            other.Write(Field.Position, singles);
            Tests.Equal(other.Hash(), made.Hash());
        }
    }

    static void WholeFields()
    {
        int read = 0;
        for (int variant = 0; variant < 3; ++variant)
        {
            var chain = new Chain(2, 5, 3);
            var sheet = new Membrane(4, 3, 3);
            if (variant == 1)
            {
                chain.Ring = true;
                sheet.SetRing(true, true);
            }
            if (variant == 2)
            {
                chain.RestLength = 1;
                sheet.SetRestLength(1, 1);
            }
            var pool = new Water(5, 4, 0.5, 0.25);
            var enable = new Action<Field>[] { chain.EnableField, sheet.EnableField, pool.EnableField };
            var all = new LibraryObject[] { chain, sheet, pool };
            for (int k = 0; k < all.Length; ++k)
                foreach (Field field in Enum.GetValues(typeof(Field)))
                {
                    try
                    {
                        enable[k](field);
                    }
                    catch (ContdynException raised)
                    {
                        Tests.True(raised.Status == Status.ErrorUnsupported || raised.Status == Status.ErrorEnum,
                            raised.Message);
                        continue;
                    }
                    double[] values = all[k].Read(field);
                    Tests.True(values.Length > 0, "values");
                    ++read;
                }
        }
        Tests.True(read > 60, "fields");
        Tests.Refused(Status.ErrorEnum, "cd_chain_read_f64", () => Rope().GetSize(Field.Depth));
    }

    static void Sizes()
    {
        var chain = new Chain(2, 5, 3);
        var sheet = new Membrane(4, 3, 3);
        Field[] ofChain = { Field.Position, Field.Mass, Field.Stiffness };
        Field[] ofSheet = { Field.Position, Field.StiffnessU, Field.StiffnessV };
        Func<LibraryObject, Field[], string> sizes = (made, fields) => string.Join(" ", fields.Select(made.GetSize));
        Tests.Equal(sizes(chain, ofChain), "36 6 5");
        Tests.Equal(chain.GetSize(Field.Bend), 6);
        chain.Ring = true;
        Tests.Equal(sizes(chain, ofChain), "36 6 6");
        chain.Ring = false;
        chain.RestLength = 1;
        Tests.Equal(sizes(chain, ofChain), "36 12 10");
        Tests.Equal(sizes(sheet, ofSheet), "60 16 15");
        sheet.SetRing(true, false);
        Tests.Equal(sizes(sheet, ofSheet), "60 20 15");
        sheet.SetRing(false, true);
        Tests.Equal(sizes(sheet, ofSheet), "60 16 20");
        Tests.Equal(sizes(new Water(5, 4, 1, 1), new[] { Field.Depth, Field.VelocityX, Field.VelocityY }), "20 24 25");
    }

    static void Results()
    {
        var made = Rope();
        made.SetGravity(0, -9.81);
        var gravity = new double[2];
        made.GetGravity(gravity);
        Tests.Equal(gravity[1], -9.81);
        var energy = made.GetEnergy();
        Tests.True(energy.Kinetic == 0 && energy.Elastic > 0, "energy");
        made.Method = Method.StiffSecond;
        Tests.Equal(made.Method, Method.StiffSecond);
        var pool = new Water(4, 4, 1, 1);
        pool.Write(Field.Depth, Enumerable.Repeat(2.0, 16).ToArray());
        double[] depth = new double[2], normal = new double[6];
        pool.Sample(new[] { 1.0, 1, 2, 2.5 }, Outside.Refused, null, depth, normal, null);
        Tests.True(depth.SequenceEqual(new[] { 2.0, 2 }), "depth");
        Tests.True(normal.SequenceEqual(new[] { 0.0, 0, 1, 0, 0, 1 }), "normal");
        var vertices = new Vertex[16];
        pool.WriteVertices(vertices, 28, 0, 12, 24);
        Tests.True(vertices.All(v => v.Depth == 2 && v.NormalZ == 1 && v.Z == 2), "vertices");
        pool.WriteVertices(new float[48], 12, 0, Library.SizeMax, Library.SizeMax);
        var indices = new ushort[pool.GetIndexCount(false)];
        pool.WriteIndices(false, indices, 2);
        Tests.True(indices.Max() == 15, "indices");
        made.Attach(0, 1, 5, 0);
        made.Attach(0, 1, 5, 0, 1, 2);
        Tests.Equal(made.GetAttachment(0, 1).Stiffness, 5.0);
    }

    static void Lengths()
    {
        var made = Rope();
        Tests.Refused(Status.ErrorRange, "cd_chain_set_gravity: count is 3", () => made.SetGravity(1, 2, 3));
        Tests.Refused(Status.ErrorRange, "cd_chain_write_f64", () => made.Write(Field.Position, new double[3]));
        Tests.Refused(Status.ErrorRange, "cd_chain_read_f64", () => made.Read(Field.Position, new double[3]));
        Tests.Refused(Status.ErrorRange, "normal has 3 numbers, must have 2",
            () => made.SetPlane(0, new double[2], new[] { 1.0, 0, 0 }, 0));
        Tests.Refused(Status.ErrorRange, "node is -2", () => made.Impulse(0, -2, 1, 2));
        Tests.Refused(Status.ErrorRange, "cd_chain_step: count is -1", () => made.Step(0.1, -1));
        Tests.Refused(Status.ErrorRange, "cd_chain_create: springs is -1", () => new Chain(1, -1, 2));
        Tests.Refused(Status.ErrorEnum, "cd_chain_set_end", () => made.SetEnd(End.First, (Node)77));
        Tests.Refused(Status.ErrorNull, "gravity is null", () => made.SetGravity(null));
        var pool = new Water(4, 4, 1, 1);
        Tests.Refused(Status.ErrorRange, "position_offset is -1",
            () => pool.WriteVertices(new float[48], 12, Library.SizeMax, Library.SizeMax, Library.SizeMax));
        Tests.Refused(Status.ErrorRange, "at has 3 numbers, must be a multiple of 2",
            () => pool.Sample(new double[3], Outside.Refused, null, null, null, null));
        Tests.Refused(Status.ErrorRange, "out_depth has 3 numbers, must have 1",
            () => pool.Sample(new double[2], Outside.Nearest, null, new double[3], null, null));
        Tests.Throws<ArgumentNullException>(() => made.CopyState(null));
    }

    static void Views()
    {
        foreach (Precision precision in Enum.GetValues(typeof(Precision)))
        {
            var made = Rope(precision);
            made.SetGravity(0, -1);
            var at = made.View(Field.Position);
            for (int round = 0; round < 3; ++round)
            {
                var copy = made.Read(Field.Position);
                for (int strand = 0; strand < 2; ++strand)
                    for (int node = 0; node < 4; ++node)
                        for (int component = 0; component < 2; ++component)
                            Tests.Equal(at[strand, node, component], copy[strand * 8 + node * 2 + component]);
                made.Step(0.5);
            }
            Tests.True(at[0, 0, 1] < 1, "it falls");
            Tests.True(at.Extents.SequenceEqual(new long[] { 2, 4, 2 }), "extents");
            Tests.Throws<IndexOutOfRangeException>(() => at[2, 0, 0].ToString());
            Tests.Throws<IndexOutOfRangeException>(() => at[0, -1, 0].ToString());
        }
        var sheet = new Membrane(4, 2, 1, Precision.Float32);
        sheet.WriteF64(Field.Position, 3, 1, 1, 1, 5);
        Tests.Equal(sheet.View(Field.Position)[3, 1], 5.0);
        var pool = new Water(4, 3, 1, 1, Precision.Float32);
        pool.WriteF32(Field.Depth, 3, 2, 1, 1, 7);
        Tests.Equal(pool.View(Field.Depth)[3, 2], 7.0);
        Tests.Refused(Status.ErrorUnsupported, "cd_water_view", () => pool.View(Field.Surface));
    }
}
