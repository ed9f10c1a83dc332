using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Placement;

/// <summary>
/// What the rules must know of a built form of leg: how thick it may be, how far it swings and how its foot stands. The numbers are those of the limb profiles that
/// shape the leg later, so that a leg that fits here fits there.
/// </summary>
/// <param name="Posture">Whether it stands under the body or out to the side; decides what "unit" means below: the leg's length, or its reach.</param>
/// <param name="MinGirth">Smallest radius of the root relative to the unit.</param>
/// <param name="GreatestGirth">Largest radius of the root relative to the unit.</param>
/// <param name="SideGirth">Radius of the root around the body relative to that along it.</param>
/// <param name="SwingDegrees">Largest swing of the hip to the front and to the rear in quick gaits, degrees.</param>
/// <param name="FootForward">How far before the root the foot's centre stands, in units.</param>
/// <param name="FootOutward">How far outside the root the foot's centre stands, in units.</param>
/// <param name="Heel">Length of the sole behind the foot's centre, relative to the root's radius and the foot's factor.</param>
/// <param name="Toe">Length of the sole before the foot's centre with the toes, relative to the same.</param>
/// <param name="HalfWidth">Half width of the sole, relative to the same.</param>
internal sealed record LegBuild(
    LimbPosture Posture,
    double MinGirth,
    double GreatestGirth,
    double SideGirth,
    double SwingDegrees,
    double FootForward,
    double FootOutward,
    double Heel,
    double Toe,
    double HalfWidth)
{
    /// <summary>Swing of a leg that hangs in the air, degrees.</summary>
    public const double HangingSwingDegrees = 10;

    private static readonly LegBuild digitigradeHind = new(LimbPosture.Under, 0.19, 0.34, 0.8, 35, 0.03, 0.02, 0.26, 0.40, 0.42);
    private static readonly LegBuild digitigradeFore = new(LimbPosture.Under, 0.19, 0.34, 0.8, 35, 0.11, 0.01, 0.26, 0.40, 0.42);
    private static readonly LegBuild unguligradeHind = new(LimbPosture.Under, 0.165, 0.34, 0.8, 32, 0, 0, 0.31, 0.31, 0.31);
    private static readonly LegBuild unguligradeFore = new(LimbPosture.Under, 0.165, 0.34, 0.8, 32, 0.07, 0.01, 0.31, 0.31, 0.31);
    private static readonly LegBuild plantigradeHind = new(LimbPosture.Under, 0.24, 0.31, 0.85, 32, 0.14, 0.03, 0.30, 0.38, 0.55);
    private static readonly LegBuild plantigradeFore = new(LimbPosture.Under, 0.24, 0.31, 0.85, 32, 0.15, 0.03, 0.30, 0.38, 0.55);
    private static readonly LegBuild column = new(LimbPosture.Under, 0.18, 0.34, 0.85, 28, 0.01, 0.03, 0.66, 0.66, 0.68);
    private static readonly LegBuild theropod = new(LimbPosture.Under, 0.145, 0.34, 0.8, 35, 0.06, 0.03, 0.21, 1.15, 0.60);
    private static readonly LegBuild sprawl = new(LimbPosture.Splayed, 0.20, 0.45, 0.8, 30, 0.32, 1.12, 0.28, 0.75, 0.50);
    private static readonly LegBuild insect = new(LimbPosture.Splayed, 0.08, 0.20, 1, 20, 0, 1.92, 0.16, 0.30, 0.16);
    private static readonly LegBuild bird = new(LimbPosture.Under, 0.05, 0.34, 0.8, 35, 0.06, 0.06, 0.19, 1.25, 0.62);
    private static readonly LegBuild jumper = new(LimbPosture.Splayed, 0.06, 0.20, 1, 20, -0.98, 0.76, 0.16, 0.30, 0.16);
    private static readonly LegBuild frogHind = new(LimbPosture.Splayed, 0.12, 0.45, 0.8, 25, 0.56, 1.36, 0.24, 0.90, 0.55);
    private static readonly LegBuild frogFore = new(LimbPosture.Splayed, 0.12, 0.45, 0.8, 25, 0.22, 0.48, 0.26, 0.90, 0.55);
    private static readonly LegBuild arm = new(LimbPosture.Under, 0.10, 0.34, 0.9, HangingSwingDegrees, 0.20, 0.20, 0.26, 0.40, 0.40);

    /// <summary>The build of an archetype.</summary>
    public static LegBuild Of(LimbArchetype archetype) => archetype switch
    {
        LimbArchetype.DigitigradeHind => digitigradeHind,
        LimbArchetype.DigitigradeFore => digitigradeFore,
        LimbArchetype.UnguligradeHind => unguligradeHind,
        LimbArchetype.UnguligradeFore => unguligradeFore,
        LimbArchetype.PlantigradeHind => plantigradeHind,
        LimbArchetype.PlantigradeFore => plantigradeFore,
        LimbArchetype.Column => column,
        LimbArchetype.Theropod => theropod,
        LimbArchetype.Sprawl => sprawl,
        LimbArchetype.Insect => insect,
        LimbArchetype.Arm or LimbArchetype.Raptorial => arm,
        LimbArchetype.Bird => bird,
        LimbArchetype.Jumper => jumper,
        LimbArchetype.FrogHind => frogHind,
        LimbArchetype.FrogFore => frogFore,
        _ => throw new ArgumentOutOfRangeException(nameof(archetype), archetype, "expected a known archetype"),
    };

    /// <summary>Sine of the standing swing.</summary>
    public double SwingSine() => PortableMath.Sin(Scalar.Radians(SwingDegrees));

    /// <summary>Sine of the hanging swing.</summary>
    public static double HangingSwingSine() => PortableMath.Sin(Scalar.Radians(HangingSwingDegrees));
}

/// <summary>Where a leg stands.</summary>
internal enum LimbPosture
{
    /// <summary>Under the body: it swings with its length.</summary>
    Under,

    /// <summary>Out to the side: it swings with its reach.</summary>
    Splayed,
}
