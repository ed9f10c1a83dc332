using System;
using System.Globalization;
using BenchmarkDotNet.Running;
using CreatureGen.Benchmarks.Beside;
using CreatureGen.Benchmarks.Crowds;
using CreatureGen.Benchmarks.Growth;
using CreatureGen.Benchmarks.Table;

namespace CreatureGen.Benchmarks;

/// <summary><c>table [CHECKOUTS]</c> measures all rows beside an earlier commit, in the runtime for browsers, and beside peers of which the folder has checkouts, then how costs grow, and puts it into docs/performance.md; <c>growth</c> does the last alone; <c>beside COMMIT [ROW]</c> measures rows in turns with an earlier commit's alone; <c>stages</c> prints what the stages of a creature take; <c>crowd</c> what moving many creatures costs; <c>clips</c> what clips take and lose as they are kept; <c>events [PRESET] [FIRST] [COUNT]</c> how good the rules for events are, by gait; <c>digest</c> prints a hash of the files of many seeds; anything else goes to BenchmarkDotNet.</summary>
public static class Program
{
    private const int DefaultDigestSeeds = 300;

    /// <summary>The commit that the goals of speed are shares of.</summary>
    private const string DefaultCommit = "a1261cd";

    /// <summary>Of each kind.</summary>
    private const int DefaultClipSeeds = 10;

    /// <summary>Seeds on which no preset was tuned.</summary>
    private const ulong DefaultEventSeed = 1001;

    private const int DefaultEventCreatures = 100;

    /// <summary>Runs what the arguments ask for.</summary>
    public static int Main(string[] args)
    {
        string verb = args.Length > 0 ? args[0] : "";
        switch (verb)
        {
            case "table":
                SpeedTable.Make(DefaultCommit, args.Length > 1 ? args[1] : null, Console.Out);
                GrowthTable.Make(Console.Out);
                return 0;
            case "growth":
                GrowthTable.Make(Console.Out);
                return 0;
            case "stages":
                FiguresTable.Print(Console.Out);
                return 0;
            case "beside":
                SpeedTable.PrintBeside(args.Length > 1 ? args[1] : DefaultCommit, args.Length > 2 ? args[2] : "", Console.Out);
                return 0;
            case "crowd":
                CrowdTable.Print(Console.Out, args.Length > 1 ? args[1] : "");
                return 0;
            case "clips":
                ClipTable.Print(Console.Out, args.Length > 1 ? int.Parse(args[1], CultureInfo.InvariantCulture) : DefaultClipSeeds);
                return 0;
            case "events":
                EventTable.Print(Console.Out, args.Length > 1 ? args[1] : "footstep", args.Length > 2 ? ulong.Parse(args[2], CultureInfo.InvariantCulture) : DefaultEventSeed, args.Length > 3 ? int.Parse(args[3], CultureInfo.InvariantCulture) : DefaultEventCreatures);
                return 0;
            case "digest":
                int seeds = args.Length > 1 ? int.Parse(args[1], CultureInfo.InvariantCulture) : DefaultDigestSeeds;
                GlbDigest.Print(Console.Out, seeds);
                return 0;
            default:
                BenchmarkSwitcher.FromAssembly(typeof(Program).Assembly).Run(args);
                return 0;
        }
    }
}
