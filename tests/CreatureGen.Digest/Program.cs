using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;

namespace CreatureGen.Digest;

/// <summary>Prints the entries of a golden file as the library would have them now, or renews the file.</summary>
internal static class Program
{
    private const string Usage = "usage: CreatureGen.Digest renew FILE | renew-poses FILE | print FILE [THREADS [CULTURE]]";

    private static int Main(string[] arguments)
    {
        if (arguments is not (["renew", _] or ["renew-poses", _] or ["print", _] or ["print", _, _] or ["print", _, _, _]))
        {
            Console.Error.WriteLine(Usage);
            return 2;
        }

        if (arguments.Length > 3)
        {
            Surroundings.Enter(arguments[3]);
        }

        string old = File.ReadAllText(arguments[1]);
        if (arguments[0] == "renew-poses")
        {
            File.WriteAllText(arguments[1], PoseEntry.Format(old, PoseEntry.Parse(old).Select(e => PoseEntry.Compute(e.Plan, e.Seed))));
            return 0;
        }

        int threads = arguments.Length > 2 ? int.Parse(arguments[2], CultureInfo.InvariantCulture) : 1;
        GoldenEntry[] entries = Compute(GoldenEntry.Parse(old), threads);
        if (arguments[0] == "renew")
        {
            File.WriteAllText(arguments[1], GoldenEntry.Format(old, entries));
            return 0;
        }

        Console.OutputEncoding = new System.Text.UTF8Encoding(false);
        Console.Out.Write("# " + Surroundings.Describe() + "\n");
        Console.Out.Write(GoldenEntry.Format("", entries));
        return 0;
    }

    /// <summary>One thread goes through the entries in order; several share them, last ones first.</summary>
    private static GoldenEntry[] Compute(IReadOnlyList<GoldenEntry> old, int threads)
    {
        var entries = new GoldenEntry[old.Count];
        int taken = -1;
        void Work()
        {
            for (int i = Interlocked.Increment(ref taken); i < entries.Length; i = Interlocked.Increment(ref taken))
            {
                int place = threads == 1 ? i : entries.Length - 1 - i;
                entries[place] = GoldenEntry.Compute(old[place].Kind, old[place].Seed);
            }
        }

        var workers = new Thread[threads];
        for (int i = 0; i < threads; i++)
        {
            workers[i] = new Thread(Work);
            workers[i].Start();
        }

        Array.ForEach(workers, w => w.Join());
        return entries;
    }
}
