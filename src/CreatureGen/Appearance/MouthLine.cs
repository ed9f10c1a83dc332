using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Appearance;

/// <summary>The edges of both lips, left half, as lines that colours are laid along.</summary>
internal sealed class MouthLine
{
    private readonly Vector3[] upper;
    private readonly Vector3[] lower;
    private readonly float lastRing;

    /// <summary>Takes a mouth.</summary>
    /// <param name="upper">Points of the upper lip from the corner to the middle of the front, x ≥ 0; at least 2.</param>
    /// <param name="lower">Those of the lower lip, as many.</param>
    /// <param name="cornerRing">Ring of the body at the corner.</param>
    /// <param name="muzzle">Half width of the muzzle, metres: what breadths along the line are measured by.</param>
    public MouthLine(Vector3[] upper, Vector3[] lower, int cornerRing, float muzzle)
    {
        this.upper = upper;
        this.lower = lower;
        lastRing = cornerRing + 1.5f;
        Muzzle = muzzle;
    }

    /// <summary>Half width of the muzzle, metres.</summary>
    public float Muzzle { get; }

    /// <summary>Distance of a place of the head from the nearer lip, in half widths of the muzzle; infinite behind the corner.</summary>
    public float DistanceOf(in SkinPlace place)
    {
        if (place.Ring > lastRing)
        {
            return float.PositiveInfinity;
        }

        float nearest = float.PositiveInfinity;
        for (int i = 0; i + 1 < upper.Length; i++)
        {
            nearest = Math.Min(nearest, Math.Min(Squared(place.Position, upper[i], upper[i + 1]), Squared(place.Position, lower[i], lower[i + 1])));
        }

        return (float)Math.Sqrt(nearest) / Muzzle;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static float Squared(Vector3 p, Vector3 from, Vector3 to)
    {
        Vector3 along = to - from;
        float share = Scalar.Clamp(Vec.Dot(p - from, along) / Math.Max(Vec.Dot(along, along), 1e-12f), 0f, 1f);
        Vector3 off = p - (from + Vec.Scale(along, share));
        return Vec.Dot(off, off);
    }
}
