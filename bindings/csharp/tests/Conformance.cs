// The scenes of bindings/conformance: the same hashes as in every other language.
using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.RegularExpressions;
using Contdyn;

static class Conformance
{
    static Dictionary<string, int> enumerators;

    sealed class Statement
    {
        public int Line;
        public List<string> Words = new List<string>();
    }

    // Lines that begin with a space go on with the statement before.
    static List<Statement> Statements()
    {
        var found = new List<Statement>();
        int number = 0;
        foreach (var line in File.ReadAllLines(Path.Combine(Tests.Bindings, "conformance", "scenes.txt")))
        {
            ++number;
            if (line == "" || line[0] == '#') continue;
            if (line[0] != ' ') found.Add(new Statement { Line = number });
            found[found.Count - 1].Words.AddRange(line.Split(new[] { ' ' }, StringSplitOptions.RemoveEmptyEntries));
        }
        return found;
    }

    // The arguments of a call; an array is one of them.
    static List<object> Arguments(IEnumerable<string> words)
    {
        var taken = new List<object>();
        List<string> into = null;
        foreach (var word in words)
        {
            if (word == "[") taken.Add(into = new List<string>());
            else if (word == "]") into = null;
            else if (into != null) into.Add(word);
            else taken.Add(word);
        }
        return taken;
    }

    static double Number(string word)
    {
        int value;
        if (word == "INFINITY") return double.PositiveInfinity;
        return enumerators.TryGetValue(word, out value) ? value : double.Parse(word, CultureInfo.InvariantCulture);
    }

    // A word, or an array of them, as a parameter's type takes it.
    static object Converted(object argument, Type type, Precision precision)
    {
        var array = argument as List<string>;
        if (array != null && type == typeof(double[])) return array.Select(Number).ToArray();
        if (array != null) return array.Select(word => (float)Number(word)).ToArray();
        var text = (string)argument;
        if (text == "null") return null;
        if (text == "precision") return precision;
        if (type.IsEnum) return Enum.ToObject(type, (int)Number(text));
        if (type == typeof(bool)) return Number(text) != 0;
        return Convert.ChangeType(Number(text), type, CultureInfo.InvariantCulture);
    }

    static string Pascal(string name)
    {
        return string.Concat(name.Split('_').Select(part => char.ToUpper(part[0]) + part.Substring(1)));
    }

    static Type Named(string name)
    {
        return typeof(Chain).Assembly.GetType("Contdyn." + Pascal(name));
    }

    sealed class Player
    {
        readonly Precision precision;
        readonly Kernels kernels;
        List<string> madeBy;
        LibraryObject made;
        public int Compared;

        public Player(Precision precision, Kernels kernels)
        {
            this.precision = precision;
            this.kernels = kernels;
        }

        object Invoke(MethodBase method, object target, List<object> given)
        {
            var types = method.GetParameters();
            var values = types.Select((p, k) => k < given.Count ? Converted(given[k], p.ParameterType, precision)
                : p.ParameterType.IsArray ? Array.CreateInstance(p.ParameterType.GetElementType(), 0) : p.DefaultValue);
            try
            {
                var constructor = method as ConstructorInfo;
                return constructor != null ? constructor.Invoke(values.ToArray())
                    : method.Invoke(target, values.ToArray());
            }
            catch (TargetInvocationException raised)
            {
                throw raised.InnerException;
            }
        }

        LibraryObject Make()
        {
            var type = Named(madeBy[1]);
            var result = (LibraryObject)Invoke(type.GetConstructors()[0], null, Arguments(madeBy.Skip(2)));
            type.GetProperty("Kernels").SetValue(result, kernels, null);
            return result;
        }

        void CallNamed(string name, IEnumerable<string> words)
        {
            var type = made.GetType();
            var setter = name.StartsWith("set_") ? type.GetProperty(Pascal(name.Substring(4))) : null;
            var method = setter != null ? setter.GetSetMethod() : type.GetMethods().First(m => m.Name == Pascal(name) &&
                m.GetParameters().All(p => p.ParameterType.IsArray || !p.ParameterType.IsGenericType));
            Invoke(method, made, Arguments(words));
        }

        static object Plain(LibraryObject made, string name)
        {
            return made.GetType().GetMethod(name, Type.EmptyTypes).Invoke(made, null);
        }

        static MethodInfo Generic(LibraryObject made, string name)
        {
            return made.GetType().GetMethods().First(m => m.Name == name && m.IsGenericMethod)
                .MakeGenericMethod(typeof(byte));
        }

        public void Play(List<string> words)
        {
            var last = made;
            switch (words[0])
            {
                case "scene":
                    made = null;
                    break;
                case "create":
                    madeBy = words;
                    made = Make();
                    break;
                case "copy":
                    made = Make();
                    made.GetType().GetMethod("CopyState").Invoke(made, new object[] { last });
                    break;
                case "save_and_load":
                    made = Make();
                    Generic(made, "Load").Invoke(made, new[] { Plain(last, "Save") });
                    break;
                case "hash":
                    Tests.Equal("0x" + ((ulong)Plain(last, "Hash")).ToString("x16"), words[1 + (int)precision]);
                    ++Compared;
                    break;
                case "refused":
                    Tests.Refused((Status)enumerators[words[1]], "cd_", () => CallNamed(words[2], words.Skip(3)));
                    break;
                default:
                    CallNamed(words[0], words.Skip(1));
                    break;
            }
        }
    }

    public static void All()
    {
        var text = File.ReadAllText(Path.Combine(Tests.Bindings, "api.json"));
        const string described = "\"name\": \"(CD_\\w+)\",\\s+\"short\": \"(\\w+)\",\\s+\"value\": (\\d+)";
        enumerators = Regex.Matches(text, described).Cast<Match>()
            .ToDictionary(m => m.Groups[1].Value, m => int.Parse(m.Groups[3].Value));
        Tests.Run("enumerators have C's values", () =>
        {
            Type type = null;
            int checkedOnes = 0;
            text = text.Substring(0, text.IndexOf("\"callbacks\""));
            foreach (Match match in Regex.Matches(text, described + "|\"name\": \"(cd_\\w+)\""))
            {
                var found = match.Groups;
                if (found[4].Success)
                {
                    type = Named(found[4].Value.Substring(3));
                    continue;
                }
                var value = (int)Enum.Parse(type, Pascal(found[2].Value));
                Tests.Equal(value, int.Parse(found[3].Value), found[1].Value);
                ++checkedOnes;
            }
            Tests.True(checkedOnes > 60, "enumerators");
        });
        Tests.Run("conformance", () =>
        {
            var statements = Statements();
            int compared = 0;
            foreach (Kernels kernels in Enum.GetValues(typeof(Kernels)))
                foreach (Precision precision in Enum.GetValues(typeof(Precision)))
                {
                    if ((Library.RunnableKernels() >> (int)kernels & 1) == 0) continue;
                    var player = new Player(precision, kernels);
                    foreach (var statement in statements)
                    {
                        try
                        {
                            player.Play(statement.Words);
                        }
                        catch (Exception raised)
                        {
                            throw new Exception("line " + statement.Line + ", " + precision + ", " + kernels, raised);
                        }
                    }
                    compared += player.Compared;
                }
            Tests.True(compared > 10, "hashes");
            Console.WriteLine(compared + " hashes compared");
        });
        Tests.Run("another step is another hash", () =>
        {
            var rope = new Chain(1, 12, 2);
            var before = rope.Hash();
            rope.Step(0.01);
            Tests.True(rope.Hash() != before, "the same hash");
        });
    }
}
