using System;
using System.Numerics;

namespace CreatureGen.Maths;

/// <summary>The distance between two segments of straight lines.</summary>
/// <remarks>Based on: C. Ericson, "Real-Time Collision Detection" (2005), section 5.1.9.</remarks>
internal static class SegmentDistance
{
    private const float Shortest = 1e-12f;

    /// <summary>Square of the least distance between any point of one segment and any of the other.</summary>
    /// <param name="a">One end of the first; segments may be points.</param>
    /// <param name="b">Its other end.</param>
    /// <param name="c">One end of the second.</param>
    /// <param name="d">Its other end.</param>
    public static float Squared(Vector3 a, Vector3 b, Vector3 c, Vector3 d) => Squared(a, b, c, d, out _, out _);

    /// <summary>The same, and where these points are.</summary>
    /// <param name="a">One end of the first; segments may be points.</param>
    /// <param name="b">Its other end.</param>
    /// <param name="c">One end of the second.</param>
    /// <param name="d">Its other end.</param>
    /// <param name="s">Place on the first, 0..1 from <paramref name="a"/>.</param>
    /// <param name="t">Place on the second, 0..1 from <paramref name="c"/>.</param>
    public static float Squared(Vector3 a, Vector3 b, Vector3 c, Vector3 d, out float s, out float t)
    {
        Vector3 first = b - a;
        Vector3 second = d - c;
        Vector3 between = a - c;
        float firstSquared = Vec.LengthSquared(first);
        float secondSquared = Vec.LengthSquared(second);
        float alongSecond = Vec.Dot(second, between);
        if (firstSquared <= Shortest)
        {
            s = 0f;
            t = secondSquared <= Shortest ? 0f : Scalar.Clamp(alongSecond / secondSquared, 0f, 1f);
        }
        else
        {
            float alongFirst = Vec.Dot(first, between);
            if (secondSquared <= Shortest)
            {
                t = 0f;
                s = Scalar.Clamp(-alongFirst / firstSquared, 0f, 1f);
            }
            else
            {
                float across = Vec.Dot(first, second);
                float area = (firstSquared * secondSquared) - (across * across);
                s = area > 1e-6f * firstSquared * secondSquared ? Scalar.Clamp(((across * alongSecond) - (alongFirst * secondSquared)) / area, 0f, 1f) : 0f;
                t = ((across * s) + alongSecond) / secondSquared;
                if (t < 0f)
                {
                    t = 0f;
                    s = Scalar.Clamp(-alongFirst / firstSquared, 0f, 1f);
                }
                else if (t > 1f)
                {
                    t = 1f;
                    s = Scalar.Clamp((across - alongFirst) / firstSquared, 0f, 1f);
                }
            }
        }

        return Vec.LengthSquared(between + (first * s) - (second * t));
    }
}
