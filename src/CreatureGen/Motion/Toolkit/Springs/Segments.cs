using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Springs;

/// <summary>Straight lines between two points.</summary>
/// <remarks>Based on: C. Ericson, "Real-Time Collision Detection" (2005), 5.1.9.</remarks>
internal static class Segments
{
    /// <summary>Where two segments are nearest to each other.</summary>
    /// <param name="start">Of the first.</param>
    /// <param name="way">From its start to its end.</param>
    /// <param name="otherStart">Of the second.</param>
    /// <param name="otherWay">From its start to its end; none for a point.</param>
    /// <param name="other">Part of the way along the second, 0 to 1.</param>
    /// <returns>Part of the way along the first, 0 to 1.</returns>
    public static float Nearest(Vector3 start, Vector3 way, Vector3 otherStart, Vector3 otherWay, out float other)
    {
        Vector3 between = start - otherStart;
        float a = Vec.LengthSquared(way);
        float e = Vec.LengthSquared(otherWay);
        float c = Vec.Dot(way, between);
        if (a <= 0f)
        {
            other = e > 0f ? Scalar.Clamp(Vec.Dot(otherWay, between) / e, 0f, 1f) : 0f;
            return 0f;
        }

        if (e <= 0f)
        {
            other = 0f;
            return Scalar.Clamp(-c / a, 0f, 1f);
        }

        float f = Vec.Dot(otherWay, between);
        float b = Vec.Dot(way, otherWay);
        float slant = (a * e) - (b * b);
        float part = slant > 1e-7f * a * e ? Scalar.Clamp(((b * f) - (c * e)) / slant, 0f, 1f) : 0.5f;
        other = ((b * part) + f) / e;
        if (other < 0f)
        {
            other = 0f;
            return Scalar.Clamp(-c / a, 0f, 1f);
        }

        if (other > 1f)
        {
            other = 1f;
            return Scalar.Clamp((b - c) / a, 0f, 1f);
        }

        return part;
    }
}
