using System.Collections.Generic;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>Measures how the creatures of many seeds move.</summary>
internal sealed class MetricsVerb : IVerb
{
    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "metrics",
        null,
        "measure the motion of the creatures of seeds: every gait, on flat and rough ground, at 30, 60 and 144 Hz",
        [
            new("metrics --seeds 1-20", "slip, sinking, clearance, joint limits, reach, jumps and feet down, gait by gait"),
            new("metrics --seeds 0-299 --kind walking --threads 8 --json > motion.json", "every run of 300 walkers, for a script"),
        ],
        [SeedOptions.Seed, SeedOptions.Seeds, .. CreatureArguments.Syntax, CommonOptions.Threads, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        SeedList seeds = SeedOptions.Read(arguments);
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        int threads = CommonOptions.ReadThreads(arguments);
        using var progress = new ProgressLine(surroundings, "creatures measured", seeds.Count, surroundings.OutIsTerminal && arguments.Has(CommonOptions.Json.Name) ? ProgressKind.Hidden : ProgressKind.Shown);
        using IMotionReport report = arguments.Has(CommonOptions.Json.Name)
            ? new MotionJson(surroundings.Out)
            : new MotionTable(surroundings.Out, Ink.For(surroundings, surroundings.OutIsTerminal));
        OrderedWork<ulong, IReadOnlyList<MeasuredRun>>.Run(seeds, threads, seed => MeasuredRun.AllOf(seed, options), runs =>
        {
            foreach (MeasuredRun run in runs)
            {
                report.Add(run);
            }

            progress.Step();
        }, surroundings.Cancellation);
        progress.Dispose();
        report.End();
        return ExitCode.Done;
    }
}
