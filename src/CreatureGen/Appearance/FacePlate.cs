using System;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The plates on the face of an insect: a shield above its jaws (clypeus) and a lip below it, and the seams around them and up over the forehead. Without them its head is a ball, and with a round one a disc.</summary>
internal static class FacePlate
{
    // The shield: its middle and half its height, rings, half its breadth at its lower and its upper edge, radians around the head, and by how many rings it comes down a radian beside its middle, arched above and hollow below.
    private const float Ring = 3.6f;
    private const float Height = 2.1f;
    private const double LowerBreadth = 0.95;
    private const double UpperBreadth = 0.6;
    private const float Arch = 0.9f;

    // The lip: the same.
    private const float LipRing = 0.35f;
    private const float LipHeight = 0.95f;
    private const double LipBreadth = 0.9;

    // Breadth of an edge and of the seam around a plate, in its half heights.
    private const float Blur = 0.14f;
    private const float Seam = 0.15f;

    // The seam over the forehead: the rings from which it goes up, in which it forks, and where its arms end, how far they are apart there, and half its breadth, radians.
    private const float Fork = 8.2f;
    private const float Arms = 12f;
    private const float Spread = 0.75f;
    private const float Line = 0.045f;

    /// <summary>Half the breadth of an arm at its end, in that of the line.</summary>
    private const float Running = 0.5f;

    /// <summary>Shares of the plates' colour and of the seams at a ring of the body and an angle around it (0 on the back of it).</summary>
    public static (float Plate, float Seam) At(float ring, float around)
    {
        double upward = Scalar.Clamp((ring - (Ring - Height)) / (2 * Height), 0, 1);
        float shield = Off((ring + (Arch * around * around) - Ring) / Height, around / Scalar.Lerp(LowerBreadth, UpperBreadth, upward));
        float lip = Off((ring - LipRing) / LipHeight, around / LipBreadth);
        float plate = Math.Max(Within(shield), Within(lip));
        return (plate, Math.Max(Math.Max(Around(shield), Around(lip) * (1f - Within(shield))), Forehead(ring, around)));
    }

    /// <summary>How far a place is from the middle of a plate, 1 on its edge: a square whose corners are round.</summary>
    private static float Off(double along, double across)
    {
        double a = Math.Abs(along);
        double b = Math.Abs(across);
        return (float)PortableMath.Cbrt((a * a * a) + (b * b * b));
    }

    private static float Within(float off) => Scalar.Smooth((1f - off) / Blur);

    private static float Around(float off) => Scalar.Smooth(1f - (Math.Abs(1f - off) / Seam));

    /// <summary>The line from the shield up the forehead, which parts between the eyes.</summary>
    private static float Forehead(float ring, float around)
    {
        if (ring < Ring + Height || ring > Arms)
        {
            return 0f;
        }

        float beyond = Math.Max(0f, (ring - Fork) / (Arms - Fork));
        float line = Scalar.Lerp(Line, Running * Line, beyond);
        return Scalar.Smooth(2f * (1f - (Math.Abs(Math.Abs(around) - (Spread * beyond)) / line)));
    }
}
