using System;
using System.Numerics;
using System.Runtime.InteropServices;

namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>Weighted sums of lists of positions, number by number, four at a time.</summary>
/// <remarks>Each number is worked out by the same operations in the same order as alone, so the bits are the same.</remarks>
internal static class PlaceSums
{
    /// <summary>a·u + b·v; gives 0, or NaN if a sum is not finite.</summary>
    /// <param name="a">One list.</param>
    /// <param name="u">Its weight.</param>
    /// <param name="b">The other, as long.</param>
    /// <param name="v">Its weight.</param>
    /// <param name="sums">As long; may be either list.</param>
    public static float Mix(ReadOnlySpan<Vector3> a, float u, ReadOnlySpan<Vector3> b, float v, Span<Vector3> sums)
    {
        ReadOnlySpan<float> first = MemoryMarshal.Cast<Vector3, float>(a);
        ReadOnlySpan<float> second = MemoryMarshal.Cast<Vector3, float>(b);
        Span<float> result = MemoryMarshal.Cast<Vector3, float>(sums);
        ReadOnlySpan<Vector4> manyFirst = MemoryMarshal.Cast<float, Vector4>(first);
        ReadOnlySpan<Vector4> manySecond = MemoryMarshal.Cast<float, Vector4>(second);
        Span<Vector4> many = MemoryMarshal.Cast<float, Vector4>(result);
        Vector4 noughts = Vector4.Zero;
        for (int i = 0; i < many.Length; i++)
        {
            Vector4 sum = (manyFirst[i] * u) + (manySecond[i] * v);
            noughts += sum * 0f;
            many[i] = sum;
        }

        float nought = noughts.X + noughts.Y + noughts.Z + noughts.W;
        for (int i = many.Length * 4; i < result.Length; i++)
        {
            float sum = (first[i] * u) + (second[i] * v);
            nought += sum * 0f;
            result[i] = sum;
        }

        return nought;
    }

    /// <summary>Adds weighted positions to sums.</summary>
    /// <param name="sums">The sums so far; changed.</param>
    /// <param name="positions">As long.</param>
    /// <param name="weight">Their weight.</param>
    public static void Add(Span<Vector3> sums, ReadOnlySpan<Vector3> positions, float weight)
    {
        Span<float> result = MemoryMarshal.Cast<Vector3, float>(sums);
        ReadOnlySpan<float> added = MemoryMarshal.Cast<Vector3, float>(positions);
        ReadOnlySpan<Vector4> manyAdded = MemoryMarshal.Cast<float, Vector4>(added);
        Span<Vector4> many = MemoryMarshal.Cast<float, Vector4>(result);
        for (int i = 0; i < many.Length; i++)
        {
            many[i] += manyAdded[i] * weight;
        }

        for (int i = many.Length * 4; i < result.Length; i++)
        {
            result[i] += added[i] * weight;
        }
    }
}
