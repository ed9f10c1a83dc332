using CreatureGen.Maths;

namespace CreatureGen.Anatomy.Legs;

/// <summary>
/// What the rules of placement must know of a built form of leg: how thick it may be, how far it swings and how its foot stands, so that a leg that fits here fits as it is grown.
/// </summary>
/// <param name="Posture">Whether it stands under the body or out to the side; decides what "unit" means below: the leg's length, or its reach.</param>
internal sealed record LegBuild(LimbPosture Posture)
{
    /// <summary>Swing of a leg that hangs in the air, degrees.</summary>
    public const double HangingSwingDegrees = 10;

    /// <summary>Smallest radius of the root relative to the unit.</summary>
    public double MinGirth { get; init; }

    /// <summary>Largest radius of the root relative to the unit.</summary>
    public double GreatestGirth { get; init; }

    /// <summary>Radius of the root around the body relative to that along it.</summary>
    public double SideGirth { get; init; }

    /// <summary>Radius of the shank below which a leg looks too thin for what it carries, relative to the edge of a cube as large as its share of the trunk; 0 where the root sees to it.</summary>
    public double CarryingShank { get; init; }

    /// <summary>Largest swing of the hip to the front and to the rear in quick gaits, degrees.</summary>
    public double SwingDegrees { get; init; }

    /// <summary>How far before the root the foot's centre stands, in units.</summary>
    public double FootForward { get; init; }

    /// <summary>How far outside the root the foot's centre stands, in units.</summary>
    public double FootOutward { get; init; }

    /// <summary>Length of the sole behind the foot's centre, relative to the root's radius and the foot's factor.</summary>
    public double Heel { get; init; }

    /// <summary>Length of the sole before the foot's centre with the toes, relative to the same.</summary>
    public double Toe { get; init; }

    /// <summary>Half width of the sole, relative to the same.</summary>
    public double HalfWidth { get; init; }

    /// <summary>Sine of the standing swing.</summary>
    public double SwingSine() => PortableMath.Sin(Scalar.Radians(SwingDegrees));

    /// <summary>Sine of the hanging swing.</summary>
    public static double HangingSwingSine() => PortableMath.Sin(Scalar.Radians(HangingSwingDegrees));
}
