using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Events;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Events;

public sealed class PresetAccuracyTests(ITestOutputHelper output)
{
    /// <summary>Seconds from a moment within which it is found.</summary>
    private const float Near = 0.05f;

    [Theory]
    [InlineData("flap", RequestedKind.Flying, 201, 6)]
    [InlineData("flap", RequestedKind.Flying, 1001, 30, Explicit = true)]
    [InlineData("bite", RequestedKind.Walking, 201, 6)]
    [InlineData("bite", RequestedKind.Walking, 1001, 16, Explicit = true)]
    [InlineData("splash", RequestedKind.Swimming, 201, 12)]
    [InlineData("splash", RequestedKind.Swimming, 1001, 40, Explicit = true)]
    [InlineData("whoosh", RequestedKind.Walking, 201, 4)]
    [InlineData("whoosh", RequestedKind.Walking, 1001, 16, Explicit = true)]
    public void Presets_hear_what_the_places_of_the_joints_tell(string preset, RequestedKind kind, int first, int count)
    {
        (double leastFound, double mostFalse) = preset switch { "flap" => (0.9, 0.2), "whoosh" => (0.85, 0.15), "bite" => (0.75, 0.15), _ => (0.7, 0.25) };
        AngularRule rule = AngularRules.All.Single(one => one.Name == preset);
        var rows = new SortedDictionary<string, FootstepFigures.Row>(StringComparer.Ordinal);
        for (int i = 0; i < count; i++)
        {
            Creature creature = CreatureGenerator.Generate((ulong)(first + i), CreatureOptions.Default with { Kind = kind });
            foreach (Clip clip in ClipsFor(creature, preset))
            {
                float[] told = TruthOf(creature, clip, preset);
                float[] found = [.. AngularEventDetector.Find(clip, creature.Skeleton, rule).Events.Select(e => e.Time)];
                rows[clip.Name] = rows.GetValueOrDefault(clip.Name) + Compare(told, found, clip.End == ClipEnd.Loops ? clip.Duration : 0f);
            }
        }

        FootstepFigures.Row all = rows.Values.Aggregate(default(FootstepFigures.Row), (sum, row) => sum + row);
        foreach ((string name, FootstepFigures.Row row) in rows.Append(new("all", all)))
        {
            output.WriteLine(FormattableString.Invariant($"| {preset} {name} | {row.Steps} | {100.0 * row.Found / Math.Max(1, row.Steps):0.0} % | {100.0 * row.False / Math.Max(1, row.Found + row.False):0.0} % | {1000 * row.Apart / Math.Max(1, row.Found):0} ms |"));
        }

        Assert.True(all.Steps >= count, $"{all.Steps} moments");
        Assert.True(all.Found >= leastFound * all.Steps && all.False <= mostFalse * (all.Found + all.False), $"{all}");
    }

    private static IEnumerable<Clip> ClipsFor(Creature creature, string preset) => preset switch
    {
        "flap" => ClipBaker.Bake(creature).Where(clip => clip.End == ClipEnd.Loops),
        "splash" => ClipBaker.Bake(creature).Where(clip => clip.End == ClipEnd.Loops && clip.Speed > 0f),
        "bite" => ClipBaker.BakeActs(creature).Where(clip => clip.Name is "Bite" or "Call" or "Threaten" or "Sit" or "Kick"),
        _ => ClipBaker.BakeActs(creature).Where(clip => clip.Name is "Claw" or "Kick" or "TailSweep" or "Sit" or "Sniff").Concat(ClipBaker.Bake(creature).Where(clip => clip.Name is "Idle" or "LookAround")),
    };

    private static float[] TruthOf(Creature creature, Clip clip, string preset)
    {
        var truth = new PresetTruth(creature.Skeleton, clip);
        return preset switch { "flap" => truth.Flaps(), "bite" => truth.Bites(), "splash" => truth.Splashes(), _ => truth.Whooshes() };
    }

    private static FootstepFigures.Row Compare(float[] told, float[] found, float loop)
    {
        var left = found.ToList();
        var row = default(FootstepFigures.Row);
        foreach (float moment in told)
        {
            float Apart(float other) => Math.Min(Math.Abs(other - moment), loop > 0f ? loop - Math.Abs(other - moment) : float.MaxValue);
            int best = Enumerable.Range(0, left.Count).Where(i => Apart(left[i]) <= Near).OrderBy(i => Apart(left[i])).FirstOrDefault(-1);
            row += new FootstepFigures.Row(1, best >= 0 ? 1 : 0, 0, best >= 0 ? Apart(left[best]) : 0f);
            if (best >= 0)
            {
                left.RemoveAt(best);
            }
        }

        return row + new FootstepFigures.Row(0, 0, left.Count, 0f);
    }
}
