// Every method is called, with success; getters tell what setters were given; a disposed object refuses all.
using System;
using System.IO;
using Contdyn;

static class Functions
{
    static void Sweep<T>(Call<T>[] calls, Func<T> make, Action<T> lengthen, Func<T, byte[]> save)
        where T : LibraryObject
    {
        foreach (var entry in calls)
            Tests.Run(entry.Name, () =>
            {
                T other = make(), made = make();
                var saved = save(other);
                try
                {
                    try
                    {
                        entry.Run(made, other, saved);
                    }
                    catch (ContdynException raised)
                    {
                        if (raised.Status != Status.ErrorUnsupported && raised.Status != Status.ErrorRange) throw;
                        made = make(); // some are of ropes, cloth, colliders and hulls only
                        lengthen(made);
                        entry.Run(made, other, saved);
                    }
                    Tests.True(entry.Told(made), "not told");
                }
                catch (ContdynException raised)
                {
                    if (!entry.MayFail || (raised.Status != Status.ErrorUnsupported && raised.Status != Status.ErrorNull))
                        throw;
                }
                made.Dispose();
                Tests.Throws<ObjectDisposedException>(() => entry.Run(made, other, saved));
            });
    }

    public static void All()
    {
        Sweep(EveryFunction.ChainCalls, EveryFunction.MakeChain, o =>
        {
            o.RestLength = 1;
            o.Colliders = 1;
            o.Loads = true;
        }, o => o.Save());
        Sweep(EveryFunction.MembraneCalls, EveryFunction.MakeMembrane, o =>
        {
            o.SetRestLength(1, 1);
            o.Colliders = 1;
            o.Loads = true;
        }, o => o.Save());
        Sweep(EveryFunction.WaterCalls, EveryFunction.MakeWater, o =>
        {
            o.SetHulls(1, 1, 1);
            o.SetDisc(0, 1, 1);
        }, o => o.Save());
        Tests.Run("functions of no object", () =>
        {
            Tests.Equal(Library.StatusName(Status.ErrorValue), "CD_ERROR_VALUE");
            Tests.Equal(Library.StatusName((Status)1000), "CD_ERROR_UNKNOWN");
            Tests.Equal(Library.KernelsName(Kernels.Avx512), "AVX-512");
            using (var chain = new Chain(3, 4, 2))
            {
                SavedShape of = Library.SavedShape(chain.Save());
                Tests.True(of.Kind == Kind.Chain && of.First == 3 && of.Second == 4 && of.Components == 2, "saved shape");
            }
            Tests.Equal(Library.RunnableKernels() & 1, 1u);
            var version = Library.Version();
            Tests.Equal(Library.VersionString(),
                version / 1000000 + "." + version / 1000 % 1000 + "." + version % 1000);
            var project = File.ReadAllText(Path.Combine(Tests.Bindings, "csharp", "Contdyn.csproj"));
            Tests.True(project.Contains("<Version>" + Library.VersionString() + "</Version>"), "the project's version");
            Tests.True(Library.BuildInfo().Contains("objects: "), "what the build has");
            Tests.Refused(Status.ErrorValue, "mass is -1", () => new Chain(1, 2, 2).Mass = -1);
            Tests.True(Library.ErrorMessage().Contains("mass is -1"), "the message");
        });
    }
}
