using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading;
using CreatureGen.Blueprints;

namespace CreatureGen.Digest;

/// <summary>Prints the entries of a golden file as the library would have them now, renews the file, or keeps blueprints in the format of now.</summary>
internal static class Program
{
    private const string AssetsName = "assets.txt";
    private const string Usage = "usage: CreatureGen.Digest renew FILE | renew-poses FILE | save FOLDER | print FILE [THREADS [CULTURE]] | print-others FOLDER THREADS CULTURE";

    private static int Main(string[] arguments)
    {
        if (arguments is not (["renew", _] or ["renew-poses", _] or ["save", _] or ["print", _] or ["print", _, _] or ["print", _, _, _] or ["print-others", _, _, _]))
        {
            Console.Error.WriteLine(Usage);
            return 2;
        }

        if (arguments.Length > 3)
        {
            Surroundings.Enter(arguments[3]);
        }

        if (arguments[0] == "save")
        {
            Console.Out.WriteLine(SavedCreatures.Write(arguments[1]));
            return 0;
        }

        if (arguments[0] == "print-others")
        {
            return PrintOthers(arguments[1]);
        }

        string old = File.ReadAllText(arguments[1]);
        if (arguments[0] == "renew-poses")
        {
            File.WriteAllText(arguments[1], PoseEntry.Format(old, PoseEntry.Parse(old).Select(e => PoseEntry.Compute(e.Plan, e.Seed))));
            RenewAssets(arguments[1]);
            return 0;
        }

        int threads = arguments.Length > 2 ? int.Parse(arguments[2], CultureInfo.InvariantCulture) : 1;
        GoldenEntry[] entries = Compute(GoldenEntry.Parse(old), threads);
        if (arguments[0] == "renew")
        {
            return Renew(arguments[1], old, entries);
        }

        Console.OutputEncoding = new System.Text.UTF8Encoding(false);
        Console.Out.Write("# " + Surroundings.Describe() + "\n");
        Console.Out.Write(GoldenEntry.Format("", entries));
        return 0;
    }

    /// <summary>Writes the golden file anew and adds its digest to the list of versions beside it; nothing is written while the algorithm's number stands for other bytes.</summary>
    private static int Renew(string file, string old, GoldenEntry[] entries)
    {
        string versions = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(file))!, "versions.txt");
        try
        {
            File.WriteAllText(versions, GoldenVersion.Append(File.ReadAllText(versions), GoldenVersion.Of(CreatureBlueprint.CurrentAlgorithm, entries)));
        }
        catch (InvalidOperationException refusal)
        {
            Console.Error.WriteLine(refusal.Message);
            return 1;
        }

        File.WriteAllText(file, GoldenEntry.Format(old, entries));
        RenewAssets(file);
        return 0;
    }

    /// <summary>Renews the golden file of assets beside another golden file: what changes those changes it.</summary>
    private static void RenewAssets(string file)
    {
        string assets = Path.Combine(Path.GetDirectoryName(Path.GetFullPath(file))!, AssetsName);
        File.WriteAllText(assets, AssetEntry.Renew(File.ReadAllText(assets)));
    }

    /// <summary>What the golden files of poses and of assets in a folder would hold now.</summary>
    private static int PrintOthers(string folder)
    {
        Console.OutputEncoding = new System.Text.UTF8Encoding(false);
        Console.Out.Write("# " + Surroundings.Describe() + "\n");
        string poses = File.ReadAllText(Path.Combine(folder, "poses.txt"));
        Console.Out.Write(PoseEntry.Format(poses, PoseEntry.Parse(poses).Select(e => PoseEntry.Compute(e.Plan, e.Seed))));
        Console.Out.Write(AssetEntry.Renew(File.ReadAllText(Path.Combine(folder, AssetsName))));
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

        if (threads == 1)
        {
            // The runtime for the browser has no other.
            Work();
            return entries;
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
