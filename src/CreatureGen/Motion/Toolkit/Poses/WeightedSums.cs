using System;
using System.Numerics;
using System.Runtime.InteropServices;
#if NET
using System.Runtime.Intrinsics;
using CreatureGen.Maths;
#endif

namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>Weighted sums of lists of numbers, eight or four at a time.</summary>
/// <remarks>Each number is worked out by the same operations in the same order as alone, so the bits are the same. Weights are put into all four places beforehand: an operator that takes a number is a call in browsers.</remarks>
internal static class WeightedSums
{
    /// <summary>a·u + b·v; gives 0, or NaN if a sum is not finite.</summary>
    /// <param name="a">One list.</param>
    /// <param name="u">Its weight.</param>
    /// <param name="b">The other, as long.</param>
    /// <param name="v">Its weight.</param>
    /// <param name="sums">As long; may be either list.</param>
    public static float Mix(ReadOnlySpan<float> a, float u, ReadOnlySpan<float> b, float v, Span<float> sums)
    {
        a = a.Slice(0, sums.Length);
        b = b.Slice(0, sums.Length);
        Span<Vector4> fours = MemoryMarshal.Cast<float, Vector4>(sums);
        ReadOnlySpan<Vector4> foursOfA = MemoryMarshal.Cast<float, Vector4>(a).Slice(0, fours.Length);
        ReadOnlySpan<Vector4> foursOfB = MemoryMarshal.Cast<float, Vector4>(b).Slice(0, fours.Length);
        Vector4 noughts = Vector4.Zero;
        var us = new Vector4(u);
        var vs = new Vector4(v);
        for (int i = 0; i < fours.Length; i++)
        {
            Vector4 sum = (foursOfA[i] * us) + (foursOfB[i] * vs);
            noughts += sum * Vector4.Zero;
            fours[i] = sum;
        }

        float nought = noughts.X + noughts.Y + noughts.Z + noughts.W;
        for (int i = fours.Length * 4; i < sums.Length; i++)
        {
            float sum = (a[i] * u) + (b[i] * v);
            nought += sum * 0f;
            sums[i] = sum;
        }

        return nought;
    }

    /// <summary>Makes weighted numbers the sums, as if they were added to noughts.</summary>
    /// <param name="sums">Written.</param>
    /// <param name="added">As long.</param>
    /// <param name="weight">Their weight.</param>
    public static void Begin(Span<float> sums, ReadOnlySpan<float> added, float weight)
    {
        added = added.Slice(0, sums.Length);
#if NET
        int last = sums.Length - EightVectors.Count;
        if (EightVectors.Pay && last >= 0)
        {
            // The last eight may lie over others, which are then written twice alike.
            ref float s = ref MemoryMarshal.GetReference(sums);
            ref float a = ref MemoryMarshal.GetReference(added);
            Vector256<float> eightWeights = Vector256.Create(weight);
            for (int i = 0; i < last; i += EightVectors.Count)
            {
                (Vector256.Create(0f) + (Vector256.LoadUnsafe(ref a, (nuint)i) * eightWeights)).StoreUnsafe(ref s, (nuint)i);
            }

            (Vector256.Create(0f) + (Vector256.LoadUnsafe(ref a, (nuint)last) * eightWeights)).StoreUnsafe(ref s, (nuint)last);
            return;
        }
#endif
        Span<Vector4> fours = MemoryMarshal.Cast<float, Vector4>(sums);
        ReadOnlySpan<Vector4> foursAdded = MemoryMarshal.Cast<float, Vector4>(added).Slice(0, fours.Length);
        var weights = new Vector4(weight);
        for (int i = 0; i < fours.Length; i++)
        {
            fours[i] = Vector4.Zero + (foursAdded[i] * weights);
        }

        for (int i = fours.Length * 4; i < sums.Length; i++)
        {
            sums[i] = 0f + (added[i] * weight);
        }
    }

    /// <summary>Adds weighted numbers to sums.</summary>
    /// <param name="sums">The sums so far; changed.</param>
    /// <param name="added">As long.</param>
    /// <param name="weight">Their weight.</param>
    public static void Add(Span<float> sums, ReadOnlySpan<float> added, float weight)
    {
        added = added.Slice(0, sums.Length);
#if NET
        int last = sums.Length - EightVectors.Count;
        if (EightVectors.Pay && last >= 0)
        {
            // The last eight may lie over others: they are worked out before these.
            ref float s = ref MemoryMarshal.GetReference(sums);
            ref float a = ref MemoryMarshal.GetReference(added);
            Vector256<float> eightWeights = Vector256.Create(weight);
            Vector256<float> end = Vector256.LoadUnsafe(ref s, (nuint)last) + (Vector256.LoadUnsafe(ref a, (nuint)last) * eightWeights);
            for (int i = 0; i < last; i += EightVectors.Count)
            {
                (Vector256.LoadUnsafe(ref s, (nuint)i) + (Vector256.LoadUnsafe(ref a, (nuint)i) * eightWeights)).StoreUnsafe(ref s, (nuint)i);
            }

            end.StoreUnsafe(ref s, (nuint)last);
            return;
        }
#endif
        Span<Vector4> fours = MemoryMarshal.Cast<float, Vector4>(sums);
        ReadOnlySpan<Vector4> foursAdded = MemoryMarshal.Cast<float, Vector4>(added).Slice(0, fours.Length);
        var weights = new Vector4(weight);
        for (int i = 0; i < fours.Length; i++)
        {
            fours[i] = fours[i] + (foursAdded[i] * weights);
        }

        for (int i = fours.Length * 4; i < sums.Length; i++)
        {
            sums[i] += added[i] * weight;
        }
    }

    /// <summary>Adds one number to all sums.</summary>
    /// <param name="sums">The sums so far; changed.</param>
    /// <param name="number">Added.</param>
    public static void Add(Span<float> sums, float number)
    {
        Span<Vector4> fours = MemoryMarshal.Cast<float, Vector4>(sums);
        var four = new Vector4(number);
        for (int i = 0; i < fours.Length; i++)
        {
            fours[i] += four;
        }

        for (int i = fours.Length * 4; i < sums.Length; i++)
        {
            sums[i] += number;
        }
    }
}
