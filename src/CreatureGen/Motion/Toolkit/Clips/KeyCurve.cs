using System;
using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Clips;

/// <summary>Cubic curves through keys.</summary>
/// <remarks>Based on: E. Catmull and R. Rom, "A class of local interpolating splines" (1974), at uneven times; glTF 2.0 (Khronos Group, 2021), appendix C.</remarks>
internal static class KeyCurve
{
    /// <summary>The curve between two keys (Hermite).</summary>
    /// <param name="a">The key before.</param>
    /// <param name="leaving">Its tangent, per unit of time.</param>
    /// <param name="arriving">The tangent of the key after.</param>
    /// <param name="b">The key after.</param>
    /// <param name="t">The part of the way, 0..1.</param>
    /// <param name="span">Time between the keys.</param>
    public static Vector4 At(Vector4 a, Vector4 leaving, Vector4 arriving, Vector4 b, float t, float span)
    {
        float tt = t * t;
        float ttt = tt * t;
        float h1 = (2f * ttt) - (3f * tt) + 1f;
        float h2 = span * (ttt - (2f * tt) + t);
        float h3 = (3f * tt) - (2f * ttt);
        float h4 = span * (ttt - tt);
        return (a * h1) + (leaving * h2) + (b * h3) + (arriving * h4);
    }

    /// <summary>The tangent at a key: the slope from the key before to the key after. At the ends of a loop it goes on around.</summary>
    /// <param name="key">Which.</param>
    /// <param name="count">Number of keys, 2 at least.</param>
    /// <param name="loops">Whether the last key is the first again.</param>
    /// <param name="value">Of a key.</param>
    /// <param name="time">Of a key.</param>
    public static Vector4 Tangent(int key, int count, bool loops, Func<int, Vector4> value, Func<int, float> time)
    {
        bool end = key == 0 || key == count - 1;
        if (end && loops)
        {
            return Slope(value(count - 2), value(1), time(count - 1) - time(count - 2) + time(1) - time(0));
        }

        int before = Math.Max(key - 1, 0);
        int after = Math.Min(key + 1, count - 1);
        return Slope(value(before), value(after), time(after) - time(before));
    }

    /// <summary>A rotation at unit length.</summary>
    public static Vector4 Unit(Vector4 q)
    {
        float squared = (q.X * q.X) + (q.Y * q.Y) + (q.Z * q.Z) + (q.W * q.W);
        return q * (1f / (float)Math.Sqrt(squared));
    }

    public static float SquaredDistance(Vector4 a, Vector4 b)
    {
        Vector4 d = a - b;
        return (d.X * d.X) + (d.Y * d.Y) + (d.Z * d.Z) + (d.W * d.W);
    }

    private static Vector4 Slope(Vector4 a, Vector4 b, float time) => (b - a) * (1f / time);
}
