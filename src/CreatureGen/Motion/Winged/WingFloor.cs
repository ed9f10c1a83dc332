using CreatureGen.Maths;

namespace CreatureGen.Motion.Winged;

/// <summary>Keeps wings that beat close to the ground off it: their stroke ends higher above it, and begins where it did.</summary>
internal static class WingFloor
{
    /// <summary>How far the trailing edge hangs below the wing's axis as it is turned against the air, parts of the wing's reach.</summary>
    private const double Chord = 0.25;

    /// <summary>Radians over which raising begins.</summary>
    private const double Onset = 0.15;

    /// <summary>How far the bottom of a stroke is raised, radians.</summary>
    /// <param name="shoulder">Its height above the ground, metres.</param>
    /// <param name="reach">From the shoulder to the tip, metres, above 0.</param>
    /// <param name="lowest">How far below level the wing would go, radians.</param>
    public static double Lift(double shoulder, double reach, double lowest)
    {
        double below = lowest - PortableMath.Asin(Scalar.Clamp((shoulder / reach) - Chord, 0, 1));
        return below > 0 ? below * Scalar.Smooth(below / Onset) : 0;
    }
}
