using System.Collections.Generic;
using CreatureGen.Animation.Gaits;
using CreatureGen.Creatures;

namespace CreatureGen.Animation.Clips;

/// <summary>A clip to bake: what the creature is asked to do, and its name.</summary>
internal sealed class ClipPlan
{
    private ClipPlan(string name, MotionInput input, Gait? gait)
    {
        Name = name;
        Input = input;
        Gait = gait;
    }

    /// <summary>Name of the clip.</summary>
    public string Name { get; }

    /// <summary>What the creature is asked to do.</summary>
    public MotionInput Input { get; }

    /// <summary>The gait it keeps to; null for none.</summary>
    public Gait? Gait { get; }

    /// <summary>Whether the motion repeats at the beat of a gait or a stroke; standing still has none.</summary>
    public bool IsCyclic => Input.Speed != 0f || Input.Medium == MotionMedium.Air;

    /// <summary>Everything a creature does by itself: Idle, each of its gaits at its most comfortable speed, flight, swimming, crawling.</summary>
    public static IReadOnlyList<ClipPlan> Of(MotionProfile profile)
    {
        var plans = new List<ClipPlan> { new("Idle", default, null) };
        if (profile.Gaits != null)
        {
            foreach (GaitSpeed speed in profile.Gaits.Speeds)
            {
                plans.Add(new ClipPlan(NameOf(speed.Gait), new MotionInput(speed.Comfortable), speed.Gait));
            }
        }

        if (profile.Flight != null)
        {
            plans.Add(new ClipPlan("Fly", new MotionInput(profile.Flight.CruiseSpeed, Medium: MotionMedium.Air), null));
            plans.Add(new ClipPlan("Hover", new MotionInput(0f, Medium: MotionMedium.Air), null));
        }

        if (profile.Swim != null)
        {
            plans.Add(new ClipPlan("Swim", new MotionInput(profile.Swim.CruiseSpeed), null));
        }

        if (profile.Slither != null)
        {
            plans.Add(new ClipPlan("Slither", new MotionInput(profile.Slither.CruiseSpeed), null));
        }

        return plans;
    }

    /// <summary>Games look for Walk and Run, whatever walks.</summary>
    private static string NameOf(Gait gait) => gait.Name switch
    {
        "BipedWalk" => "Walk",
        "BipedRun" => "Run",
        _ => gait.Name,
    };
}
