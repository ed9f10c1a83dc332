using System;
using CreatureGen.Anatomy;

namespace CreatureGen.Motion.Flying;

/// <summary>Angles of a leg away from its rest pose, radians: hip, knee, ankle and ball, positive swinging what hangs backward.</summary>
internal readonly struct LegPosture
{
    public LegPosture(double hip, double knee, double ankle, double ball)
    {
        Hip = hip;
        Knee = knee;
        Ankle = ankle;
        Ball = ball;
    }

    public double Hip { get; }

    public double Knee { get; }

    public double Ankle { get; }

    public double Ball { get; }

    /// <summary>Folded under the body in flight.</summary>
    public static LegPosture Tucked(LimbArchetype archetype) => archetype switch
    {
        LimbArchetype.Theropod or LimbArchetype.Bird => new LegPosture(0.60, 0.70, 0.45, 0.90),
        LimbArchetype.DigitigradeHind => new LegPosture(0.75, 0.55, 0.30, 0.85),
        LimbArchetype.UnguligradeHind => new LegPosture(0.70, 0.60, 0.30, 0.85),
        LimbArchetype.PlantigradeHind => new LegPosture(0.55, 0.90, 0.70, 0.40),
        LimbArchetype.DigitigradeFore or LimbArchetype.UnguligradeFore => new LegPosture(0.50, -1.45, 1.70, 0.80),
        LimbArchetype.PlantigradeFore => new LegPosture(0.50, -1.50, 1.20, 0.60),
        LimbArchetype.Column => new LegPosture(0.40, 0.60, 0.50, 0.30),
        LimbArchetype.Arm => new LegPosture(0.45, -0.80, 0.20, 0.30),
        LimbArchetype.Sprawl => new LegPosture(0.80, -0.35, 0.40, 0.40),
        LimbArchetype.Insect => new LegPosture(0.70, -1.30, 0.70, 0.50),
        LimbArchetype.Raptorial or LimbArchetype.Jumper or LimbArchetype.FrogHind or LimbArchetype.FrogFore => new LegPosture(0.30, -0.30, 0.10, 0.10),
        _ => throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "there is no posture for this archetype"),
    };

    /// <summary>Hanging loosely when it stands in the air.</summary>
    public static LegPosture Hanging(LimbArchetype archetype) => archetype switch
    {
        LimbArchetype.Theropod or LimbArchetype.Bird => new LegPosture(-0.10, 0.45, 0.20, 0.70),
        LimbArchetype.DigitigradeHind or LimbArchetype.UnguligradeHind => new LegPosture(0.10, 0.50, -0.20, 0.70),
        LimbArchetype.PlantigradeHind => new LegPosture(-0.05, 0.45, 0.40, 0.30),
        LimbArchetype.DigitigradeFore or LimbArchetype.UnguligradeFore => new LegPosture(0.20, -0.90, 1.20, 0.70),
        LimbArchetype.PlantigradeFore => new LegPosture(0.15, -0.80, 0.70, 0.50),
        LimbArchetype.Column => new LegPosture(0.10, 0.35, 0.30, 0.20),
        LimbArchetype.Arm => new LegPosture(0.20, -0.60, 0.15, 0.25),
        LimbArchetype.Sprawl => new LegPosture(0.35, -0.45, 0.30, 0.30),
        LimbArchetype.Insect => new LegPosture(0.60, -1.05, 0.60, 0.40),
        LimbArchetype.Raptorial or LimbArchetype.Jumper or LimbArchetype.FrogHind or LimbArchetype.FrogFore => new LegPosture(0.15, -0.40, 0.15, 0.15),
        _ => throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "there is no posture for this archetype"),
    };

    /// <summary>Stretched towards the ground before it touches down.</summary>
    public static LegPosture Reaching(LimbArchetype archetype) => archetype switch
    {
        LimbArchetype.Theropod or LimbArchetype.Bird => new LegPosture(-0.45, 0.10, -0.05, -0.25),
        LimbArchetype.DigitigradeHind or LimbArchetype.UnguligradeHind => new LegPosture(-0.40, 0.15, -0.10, -0.10),
        LimbArchetype.PlantigradeHind => new LegPosture(-0.45, 0.20, -0.05, -0.10),
        LimbArchetype.DigitigradeFore or LimbArchetype.UnguligradeFore or LimbArchetype.PlantigradeFore => new LegPosture(-0.30, -0.20, 0.15, 0.05),
        LimbArchetype.Arm => new LegPosture(-0.10, -0.40, 0, 0),
        LimbArchetype.Sprawl => new LegPosture(-0.10, -0.15, 0.05, 0),
        LimbArchetype.Insect => new LegPosture(-0.05, -0.15, 0, 0),
        LimbArchetype.Column or LimbArchetype.Raptorial or LimbArchetype.Jumper or LimbArchetype.FrogHind or LimbArchetype.FrogFore => new LegPosture(-0.20, 0.10, 0, 0),
        _ => throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "there is no posture for this archetype"),
    };

    /// <summary>So much of one posture and the rest of another.</summary>
    public static LegPosture Between(LegPosture a, LegPosture b, double fraction) => new(
        a.Hip + ((b.Hip - a.Hip) * fraction),
        a.Knee + ((b.Knee - a.Knee) * fraction),
        a.Ankle + ((b.Ankle - a.Ankle) * fraction),
        a.Ball + ((b.Ball - a.Ball) * fraction));
}
