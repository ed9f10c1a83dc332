using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Rigging;

namespace CreatureGen.Events;

/// <summary>Rules for grown creatures, tuned on them.</summary>
public static class AngularRules
{
    /// <summary>A foot comes down: its leg has swung forward and is now carried back, as evenly as the body goes on over it. Of creatures that go ahead.</summary>
    public static AngularRule Footstep { get; } = new("footstep")
    {
        Track = "Footsteps",
        Roles = new[] { JointRole.Hip },
        Excluded = new[] { "Arm_*" },
        ThresholdPower = 0.9,
        Sweep = new AngularSweep(new Vector3(0f, 0f, -1f)) { Ends = new[] { JointRole.Ball, JointRole.Ankle }, LowestPart = 0.3f },
        Winner = IntervalWinner.Strongest,
        Scope = IntervalScope.EachJoint,
    };

    /// <summary>An arm, a leg or a tail cuts through the air: its end is fastest about its root, and not only because the trunk turns over a foot that stands.</summary>
    public static AngularRule Whoosh { get; } = new("whoosh")
    {
        Track = "Whooshes",
        Roles = new[] { JointRole.Hip, JointRole.Tail },
        ThresholdPower = 2.3,
        ThresholdFraction = 0.7f,
        FractionScope = IntervalScope.Together,
        Sweep = AngularSweep.ThroughAir with { Ends = new[] { JointRole.Ball, JointRole.Ankle, JointRole.End } },
        Interval = 0.3f,
        Winner = IntervalWinner.Strongest,
        Scope = IntervalScope.EachJoint,
    };

    /// <summary>Wings begin to beat down.</summary>
    public static AngularRule Flap { get; } = new("flap")
    {
        Track = "Flaps",
        Roles = new[] { JointRole.Wing },
        ThresholdPower = 1.9,
        Sweep = new AngularSweep(new Vector3(0f, -1f, 0f)) { Ends = new[] { JointRole.End }, BeginsAt = 0.2f, ReturnsAt = 0.3f, MinPart = 0.35f },
        Interval = 0.035f,
        Winner = IntervalWinner.Strongest,
    };

    /// <summary>Cloth, harness or armour rustles as the trunk shakes.</summary>
    public static AngularRule Stuff { get; } = new("stuff")
    {
        Track = "Foley",
        Roles = new[] { JointRole.Chest },
        ThresholdPower = 3.2,
        ThresholdFraction = 0.5f,
        Space = AngularSpace.Model,
        Interval = 0.15f,
        Winner = IntervalWinner.Strongest,
    };

    /// <summary>A jaw snaps shut.</summary>
    public static AngularRule Bite { get; } = new("bite")
    {
        Track = "Bites",
        Roles = new[] { JointRole.Jaw },
        ThresholdPower = 2.8,
        ThresholdFraction = 0.5f,
        Change = AngularChange.Slowing,
        NearRest = 0.35f,
        Interval = 0.15f,
        Winner = IntervalWinner.Strongest,
    };

    /// <summary>A tail or a fin beats the water: its end is fastest about its root.</summary>
    public static AngularRule Splash { get; } = new("splash")
    {
        Track = "Splashes",
        Roles = new[] { JointRole.Tail, JointRole.Fin, JointRole.Spine },
        ThresholdPower = 1.46,
        ThresholdFraction = 0.7f,
        FractionScope = IntervalScope.Together,
        Sweep = AngularSweep.AnyWay with { Ends = new[] { JointRole.End } },
        Interval = 0.07f,
        Winner = IntervalWinner.Strongest,
    };

    /// <summary>All presets.</summary>
    public static IReadOnlyList<AngularRule> All { get; } = new[] { Footstep, Whoosh, Flap, Stuff, Bite, Splash };
}
