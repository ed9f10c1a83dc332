using System;
using System.Collections.Generic;
using System.Linq;
using System.Text;
using CreatureGen.Creatures;
using CreatureGen.Events;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Tests.Events;

/// <summary>How many of the moments that the acts themselves know a preset hears, by clip: blows by the contact that the act tells, rustling by the phase in which the act shakes the trunk. Neither is read off the motion.</summary>
internal sealed class ScriptedFigures(string preset)
{
    /// <summary>Seconds before a contact, and after it, in which its blow is heard: a limb is fastest before it strikes.</summary>
    private const float Before = 0.2f;
    private const float After = 0.05f;

    /// <summary>Swings of the trunk in a shake, as the act has it.</summary>
    private const int Swings = 6;

    // Struck with a limb or a tail; who gores strikes with the brow, which whooshes do not listen to.
    private static readonly string[] blows = ["Claw", "Kick", "TailSweep", "Sting"];

    // Acts in which nothing strikes and no trunk shakes.
    private static readonly string[] quiet = ["Idle", "LookAround", "Sit", "Lie", "Sleep", "Call", "Sniff", "Groom"];

    private readonly AngularRule rule = AngularRules.All.Single(one => one.Name == preset);
    private readonly SortedDictionary<string, FootstepFigures.Row> rows = new(StringComparer.Ordinal);

    /// <summary>Of all clips together.</summary>
    public FootstepFigures.Row All => rows.Values.Aggregate(default(FootstepFigures.Row), (sum, row) => sum + row);

    /// <summary>Counts what is found in acts of a creature that has what the preset listens to.</summary>
    public void Add(Creature creature)
    {
        foreach (Clip clip in ClipBaker.BakeActs(creature).Concat(ClipBaker.Bake(creature).Where(clip => clip.Name is "Idle" or "LookAround")))
        {
            bool told = preset == "whoosh" ? blows.Contains(clip.Name) : clip.Name == "Shake";
            if (told || quiet.Contains(clip.Name))
            {
                List<float> found = [.. AngularEventDetector.Find(clip, creature.Skeleton, rule).Events.Select(e => e.Time)];
                rows[clip.Name] = rows.GetValueOrDefault(clip.Name) + Compare(told ? Spans(creature, clip) : [], found);
            }
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

    /// <summary>Stretches of time in each of which something is to be heard.</summary>
    private IEnumerable<(float From, float To)> Spans(Creature creature, Clip clip)
    {
        if (preset == "whoosh")
        {
            return clip.Events.Where(e => e.Name == "whoosh").Select(e => (e.Time - Before, e.Time + After));
        }

        ActAbility shake = new MotionProfile(creature).Acts.Find(clip.Name);
        (float from, float to) = (shake.SecondsTo(0), shake.SecondsTo(1));
        return Enumerable.Range(0, Swings).Select(swing => (from + (swing * (to - from) / Swings), from + ((swing + 1) * (to - from) / Swings)));
    }

    /// <summary>Several moments within one stretch are one: both hind feet of a kick. So are those outside within a twentieth of a second.</summary>
    private static FootstepFigures.Row Compare(IEnumerable<(float From, float To)> told, List<float> found)
    {
        var row = default(FootstepFigures.Row);
        foreach ((float from, float to) in told.ToArray())
        {
            row += new FootstepFigures.Row(1, found.RemoveAll(t => t >= from && t < to) > 0 ? 1 : 0, 0, 0f);
        }

        float last = float.MinValue;
        foreach (float moment in found.Order())
        {
            row += new FootstepFigures.Row(0, 0, moment - last > After ? 1 : 0, 0f);
            last = moment;
        }

        return row;
    }
}
