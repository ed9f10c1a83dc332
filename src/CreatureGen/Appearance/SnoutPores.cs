using System;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The dots on the sides of a snout that whiskers grow from, or through which fish feel: without them a broad muzzle is blank from the front.</summary>
internal static class SnoutPores
{
    // From one row to the next, rings; from one dot of a row to the next, radians around the head; and the radius of a dot and the breadth of its edge, in these.
    private const float Rows = 0.8f;
    private const float Gap = 0.19f;
    private const float Radius = 0.3f;
    private const float Blur = 0.14f;

    // Middle and half breadth of the field, rings and radians around the head; it runs out over the last part of them.
    private const float Ring = 4f;
    private const float Length = 2.6f;
    private const float Around = 1.3f;
    private const float Breadth = 0.48f;
    private const float RunsOut = 0.35f;

    /// <summary>How much of a dot is seen at a ring of the body and an angle around it (0 dorsal, π ventral), 0..1.</summary>
    public static float At(float ring, float around)
    {
        float u = (ring - Ring) / Length;
        float v = (around - Around) / Breadth;
        float field = Scalar.Smooth((1f - (float)Math.Sqrt((u * u) + (v * v))) / RunsOut);
        if (field <= 0f)
        {
            return 0f;
        }

        float row = ring / Rows;
        float nearest = (float)Math.Floor(row + 0.5f);
        float dot = (around / Gap) + (0.5f * (nearest % 2f));
        float along = row - nearest;
        float across = dot - (float)Math.Floor(dot + 0.5f);
        return field * Scalar.Smooth((Radius - (float)Math.Sqrt((along * along) + (across * across))) / Blur);
    }
}
