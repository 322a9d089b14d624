// Runs the tests. The first argument is the folder `bindings`.
using System;
using System.Collections.Generic;
using System.IO;
using Contdyn;

// One method with arguments with which it succeeds.
sealed class Call<T>
{
    public readonly string Name;
    public readonly bool MayFail;
    public readonly Action<T, T, byte[]> Run;
    public readonly Func<T, bool> Told; // whether the getter tells what the setter was given

    public Call(string name, bool mayFail, Action<T, T, byte[]> run, Func<T, bool> told)
    {
        Name = name;
        MayFail = mayFail;
        Run = run;
        Told = told;
    }
}

static class Call
{
    public static void Use(object value)
    {
        Tests.True(value != null, "a result");
    }
}

static class Tests
{
    public static string Bindings;
    static int passed, failed;

    public static void Run(string name, Action test)
    {
        try
        {
            test();
            ++passed;
        }
        catch (Exception raised)
        {
            ++failed;
            Console.Error.WriteLine("FAILED: " + name + ": " + raised);
        }
    }

    public static void True(bool condition, string what)
    {
        if (!condition) throw new Exception(what);
    }

    public static void Equal<T>(T found, T wanted, string what = "")
    {
        True(EqualityComparer<T>.Default.Equals(found, wanted), what + ": " + found + ", not " + wanted);
    }

    // The call must throw with this status, and its message must have these words.
    public static void Refused(Status status, string words, Action call)
    {
        try
        {
            call();
        }
        catch (ContdynException raised)
        {
            Equal(raised.Status, status, raised.Message);
            True(raised.Message.Contains(words), raised.Message + ": " + words);
            return;
        }
        throw new Exception("not refused: " + words);
    }

    public static void Throws<T>(Action call) where T : Exception
    {
        try
        {
            call();
        }
        catch (T)
        {
            return;
        }
        throw new Exception("throws no " + typeof(T).Name);
    }

    static int Main(string[] arguments)
    {
        Bindings = arguments[0];
        Conformance.All();
        Functions.All();
        Arrays.All();
        Lifetime.All();
#if CONTDYN_SPANS
        Spans.All();
#endif
        Console.WriteLine(passed + " tests passed, " + failed + " failed");
        return failed == 0 && passed > 0 ? 0 : 1;
    }
}
