using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using CreatureGen.Creatures;
using CreatureGen.Events;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sampling;

namespace CreatureGen.Tests.Events;

/// <summary>How many of the moments that the places of the joints tell a preset hears, by clip.</summary>
internal sealed class PresetFigures(string preset)
{
    /// <summary>Seconds from a moment within which it is found.</summary>
    public const float Near = 0.05f;

    private readonly AngularRule rule = AngularRules.All.Single(one => one.Name == preset);
    private readonly SortedDictionary<string, FootstepFigures.Row> rows = new(StringComparer.Ordinal);

    /// <summary>Of all clips together.</summary>
    public FootstepFigures.Row All => rows.Values.Aggregate(default(FootstepFigures.Row), (sum, row) => sum + row);

    /// <summary>What creatures the preset is for.</summary>
    public RequestedKind Kind => preset switch { "flap" => RequestedKind.Flying, "splash" => RequestedKind.Swimming, _ => RequestedKind.Walking };

    /// <summary>Counts what is found in the clips that the preset is for.</summary>
    public void Add(Creature creature)
    {
        foreach (Clip clip in ClipsFor(creature))
        {
            var truth = new PresetTruth(creature.Skeleton, clip);
            float[] told = preset switch { "flap" => truth.Flaps(), "bite" => truth.Bites(), _ => truth.Splashes() };
            float[] found = [.. AngularEventDetector.Find(clip, creature.Skeleton, rule).Events.Select(e => e.Time)];
            rows[clip.Name] = rows.GetValueOrDefault(clip.Name) + Compare(told, found, clip.End == ClipEnd.Loops ? clip.Duration : 0f);
        }
    }

    /// <inheritdoc/>
    public override string ToString()
    {
        var text = new StringBuilder();
        foreach ((string name, FootstepFigures.Row row) in rows.Append(new("all", All)))
        {
            text.AppendLine(row.Line(preset + " " + name));
        }

        return text.ToString();
    }

    private IEnumerable<Clip> ClipsFor(Creature creature) => preset switch
    {
        "flap" => ClipBaker.Bake(creature).Where(clip => clip.End == ClipEnd.Loops),
        "bite" => ClipBaker.BakeActs(creature).Where(clip => clip.Name is "Bite" or "Call" or "Threaten" or "Sit" or "Kick"),
        _ => ClipBaker.Bake(creature).Where(clip => clip.End == ClipEnd.Loops && clip.Speed > 0f),
    };

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
