using System;
using System.Collections.Generic;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;

namespace CreatureGen.Console.Verbs;

/// <summary>Measures how the creatures of many seeds move.</summary>
internal sealed class MetricsVerb : IVerb
{
    private static readonly OptionSyntax course = new("--course", null, "measure what a player can do instead: random speeds, turns and keys on flat, hilly, stepped and moving ground, at even and uneven rates");

    private static readonly OptionSyntax ground = new("--ground", "GROUND", "with --course: this ground alone: flat, rough, stairs, slope, gap, platform, lift, water, stones or pipe");

    private static readonly OptionSyntax acts = new("--acts", null, "measure everything that they can do beside going instead: joint limits and speeds, sinking, how near contacts are to their targets, slip of planted feet, jolts of the trunk");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "metrics",
        null,
        "measure the motion of the creatures of seeds: every gait, on flat and rough ground, at 30, 60 and 144 Hz",
        [
            new("metrics --seeds 1-20", "slip, sinking, clearance, joint limits, reach, jumps and feet down, gait by gait"),
            new("metrics --seeds 0-299 --kind walking --threads 8 --json > motion.json", "every run of 300 walkers, for a script"),
            new("metrics --course --seeds 1-20", "joint limits and speeds, slip, lag and acceleration in starts, stops and turns"),
            new("metrics --course --ground water --seeds 1-20", "the same where they wade, swim and come ashore"),
            new("metrics --acts --seeds 1-20 --json", "bites, meals, dances, naps of twenty creatures"),
        ],
        [SeedOptions.Seed, SeedOptions.Seeds, .. CreatureArguments.Syntax, course, ground, acts, CommonOptions.Threads, CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        if (arguments.Has(course.Name) && arguments.Has(acts.Name))
        {
            throw arguments.Wrong($"{course.Name} and {acts.Name}; expected one of them");
        }

        if (arguments.Has(ground.Name) && !arguments.Has(course.Name))
        {
            throw arguments.Wrong($"{ground.Name} without {course.Name}; expected both");
        }

        if (arguments.Has(ground.Name))
        {
            CourseGround over = arguments.Choice(ground.Name, WordList<CourseGround>.Instance, CourseGround.Flat);
            Measure(arguments, surroundings, (seed, options) => MeasuredCourse.AllOn(over, seed, options));
        }
        else if (arguments.Has(course.Name))
        {
            Measure(arguments, surroundings, MeasuredCourse.AllOf);
        }
        else if (arguments.Has(acts.Name))
        {
            Measure(arguments, surroundings, MeasuredAct.AllOf);
        }
        else
        {
            Measure(arguments, surroundings, MeasuredRun.AllOf);
        }

        return ExitCode.Done;
    }

    private static void Measure<TRun>(ParsedArguments arguments, Surroundings surroundings, Func<ulong, CreatureOptions, IReadOnlyList<TRun>> measure)
        where TRun : IMeasuredRun<TRun>
    {
        SeedList seeds = SeedOptions.Read(arguments);
        CreatureOptions options = CreatureArguments.Read(arguments, surroundings);
        int threads = CommonOptions.ReadThreads(arguments);
        using var progress = new ProgressLine(surroundings, "creatures measured", seeds.Count, surroundings.OutIsTerminal && arguments.Has(CommonOptions.Json.Name) ? ProgressKind.Hidden : ProgressKind.Shown);
        using IRunReport<TRun> report = arguments.Has(CommonOptions.Json.Name)
            ? new RunJson<TRun>(surroundings.Out)
            : new RunTable<TRun>(surroundings.Out, Ink.For(surroundings, surroundings.OutIsTerminal));
        OrderedWork<ulong, IReadOnlyList<TRun>>.Run(seeds, threads, seed => measure(seed, options), runs =>
        {
            foreach (TRun run in runs)
            {
                report.Add(run);
            }

            progress.Step();
        }, surroundings.Cancellation);
        progress.Dispose();
        report.End();
    }
}
