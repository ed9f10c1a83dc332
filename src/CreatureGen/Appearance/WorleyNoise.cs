using System;
using System.Numerics;

namespace CreatureGen.Appearance;

/// <summary>The scattered point nearest to a place.</summary>
internal readonly struct NearestPoint
{
    public NearestPoint(float distance, float value)
    {
        Distance = distance;
        Value = value;
    }

    /// <summary>Distance to the point, in cells.</summary>
    public float Distance { get; }

    /// <summary>A random number 0..1 of the point, the same for all places that it is nearest to.</summary>
    public float Value { get; }
}

/// <summary>Scattered points, one in each cell of an integer lattice, and which of them is nearest.</summary>
/// <remarks>
/// Based on: S. Worley, "A cellular texture basis function" (1996). Only the 8 cells around a place are searched. Points stay within
/// <see cref="Jitter"/> of the centre of their cell, so the answer is exact wherever the nearest point is closer than 1 − <see cref="Jitter"/>.
/// </remarks>
internal static class WorleyNoise
{
    /// <summary>How far a point may lie from the centre of its cell along each axis, in cells.</summary>
    public const float Jitter = 0.36f;

    /// <summary>The nearest point.</summary>
    public static NearestPoint Nearest(Vector3 point, int salt)
    {
        int x0 = (int)Math.Floor(point.X - 0.5);
        int y0 = (int)Math.Floor(point.Y - 0.5);
        int z0 = (int)Math.Floor(point.Z - 0.5);
        float best = float.MaxValue;
        uint winner = 0;
        for (int i = 0; i < 8; i++)
        {
            int x = x0 + (i & 1);
            int y = y0 + ((i >> 1) & 1);
            int z = z0 + (i >> 2);
            uint bits = LatticeHash.Bits(x, y, z, salt);
            float dx = x + Offset(bits) - point.X;
            float dy = y + Offset(bits << 10) - point.Y;
            float dz = z + Offset(bits << 20) - point.Z;
            float squared = (dx * dx) + (dy * dy) + (dz * dz);
            if (squared < best)
            {
                best = squared;
                winner = bits;
            }
        }

        return new NearestPoint((float)Math.Sqrt(best), LatticeHash.Unit(LatticeHash.Mix(winner)));
    }

    // Place of the point along one axis of its cell, from the highest 10 bits.
    private static float Offset(uint bits) => 0.5f + (Jitter * (((bits >> 22) * (2f / 1023f)) - 1f));
}
