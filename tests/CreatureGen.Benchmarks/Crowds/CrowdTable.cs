using System;
using System.Collections.Generic;
using System.IO;
using CreatureGen.Motion;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Crowds;

/// <summary>What an update costs in a crowd, by way of going and by stage.</summary>
internal static class CrowdTable
{
    private const double Target = 4;

    /// <summary>Measures and prints.</summary>
    /// <param name="output">Where to.</param>
    /// <param name="only">Part of the names of the crowds that are wanted; all if empty.</param>
    public static void Print(TextWriter output, string only)
    {
        output.WriteLine(FormattableString.Invariant($"{Crowd.Count} creatures at 60 Hz on level ground, one core, the quickest of many rounds; µs per update (and of {Crowd.Few} that stay in cache), target {Target} at 60 joints and 4 legs; stages are those of the few, measured apart"));
        output.WriteLine();
        output.WriteLine("| crowd | joints | update | of few | " + string.Join(" | ", Enum.GetNames<CrowdStage>()) + " |");
        output.WriteLine("| --- | ---: | ---: | ---: |" + string.Concat(System.Linq.Enumerable.Repeat(" ---: |", Enum.GetNames<CrowdStage>().Length)));
        foreach ((string name, RequestedKind kind, Predicate<MotionProfile> chosen, Func<MotionProfile, MotionInput> asked) in Kinds())
        {
            if (!name.Contains(only, StringComparison.OrdinalIgnoreCase))
            {
                continue;
            }

            var crowd = new Crowd(name, kind, chosen, asked);
            double update = crowd.Update();
            double few = crowd.UpdateOfFew();
            string stages = string.Join(" | ", Array.ConvertAll(crowd.Stages(), s => FormattableString.Invariant($"{s:F2}")));
            output.WriteLine(FormattableString.Invariant($"| {name} | {crowd.Joints:F0} | {update:F2} | {few:F2} | {stages} |"));
        }
    }

    private static IEnumerable<(string Name, RequestedKind Kind, Predicate<MotionProfile> Chosen, Func<MotionProfile, MotionInput> Asked)> Kinds()
    {
        yield return ("four legs, stand", RequestedKind.Walking, Legs(2), _ => default);
        yield return ("four legs, walk", RequestedKind.Walking, Legs(2), p => Crowd.At(p, 0));
        yield return ("four legs, trot", RequestedKind.Walking, Legs(2), p => Crowd.At(p, 1));
        yield return ("four legs, fastest", RequestedKind.Walking, Legs(2), p => Crowd.At(p, 9));
        yield return ("four legs, turn", RequestedKind.Walking, Legs(2), p => Crowd.At(p, 0) with { YawRate = 0.5f });
        yield return ("two legs, walk", RequestedKind.Walking, Legs(1), p => Crowd.At(p, 0));
        yield return ("six legs, walk", RequestedKind.Walking, Legs(3), p => Crowd.At(p, 0));
        yield return ("no legs, crawl", RequestedKind.Walking, p => p.Slither != null, p => new MotionInput(0.5f));
        yield return ("wings, fly", RequestedKind.Flying, p => p.Flight != null, _ => new MotionInput(5f, Medium: MotionMedium.Air));
        yield return ("fins, swim", RequestedKind.Swimming, p => p.Swim != null, _ => new MotionInput(1f));
    }

    private static Predicate<MotionProfile> Legs(int rows) => profile => profile.Legs != null && profile.Legs.Rows == rows;
}
