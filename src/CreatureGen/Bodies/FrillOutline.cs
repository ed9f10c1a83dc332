using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>How high a frill stands along its root.</summary>
internal static class FrillOutline
{
    /// <summary>Height as a share of the frill's length, before the notches of its rim.</summary>
    /// <param name="across">0 on the midline to 1 at either end.</param>
    public static double HeightAt(double across)
    {
        // Longest a little off the midline, low at the ends.
        return (0.30 + (0.70 * Scalar.Smooth((1 - across) / 0.62))) * (0.94 + (0.10 * PortableMath.Sin(PortableMath.Pi * across)));
    }
}
