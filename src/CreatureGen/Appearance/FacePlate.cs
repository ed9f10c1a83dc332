using System;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The plate on the face of an insect, above its jaws, and the seam around it: without them its head is a ball.</summary>
internal static class FacePlate
{
    // Its middle and its half length, rings, its half breadth, radians around the head, and how much less that is at the brow.
    private const float Ring = 3.7f;
    private const float Length = 2.6f;
    private const float Breadth = 0.88f;
    private const double Narrowing = 0.3;

    // Breadth of its edge and of the seam, in its half lengths.
    private const float Blur = 0.12f;
    private const float Seam = 0.11f;

    /// <summary>Shares of the plate's colour and of the seam at a ring of the body and an angle around it (0 where the plate is).</summary>
    public static (float Plate, float Seam) At(float ring, float around)
    {
        double along = Math.Abs(ring - Ring) / Length;
        double across = around / (Breadth * (1 - (Narrowing * Scalar.Clamp((ring - Ring) / Length, -1, 1))));
        float off = (float)Math.Sqrt((along * along) + (across * across));
        return (Scalar.Smooth((1f - off) / Blur), Scalar.Smooth(1f - (Math.Abs(1f - off) / Seam)));
    }
}
