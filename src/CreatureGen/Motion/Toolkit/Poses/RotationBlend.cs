#if NET
using System;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>What <see cref="PoseBlend"/> does with many joints at once.</summary>
/// <remarks>Loops of their own over references, no calls inside: so the compiler keeps all in registers without a profile of earlier runs too.</remarks>
internal static class RotationBlend
{
    /// <summary>The unit quaternions between two lists, the shorter way round; gives how many it made: what is left makes no eight.</summary>
    /// <param name="from">Weight 0.</param>
    /// <param name="to">Weight 1, as long.</param>
    /// <param name="weight">0..1.</param>
    /// <param name="result">As long; may be either list.</param>
    /// <param name="nought">Becomes NaN if one is no rotation.</param>
    public static int Between(ReadOnlySpan<Vector4> from, ReadOnlySpan<Vector4> to, float weight, Span<Vector4> result, ref float nought)
    {
        ref Vector4 a = ref MemoryMarshal.GetReference(from);
        ref Vector4 b = ref MemoryMarshal.GetReference(to);
        ref Vector4 r = ref MemoryMarshal.GetReference(result);
        int i = 0;
        Vector256<float> noughts = Vector256.Create(0f);
        Vector256<float> back = Vector256.Create(1f - weight);
        for (; i <= result.Length - EightVectors.Count; i += EightVectors.Count)
        {
            Vector256<float> b0 = EightVectors.Load(ref b, i), b1 = EightVectors.Load(ref b, i + 2), b2 = EightVectors.Load(ref b, i + 4), b3 = EightVectors.Load(ref b, i + 6);
            Vector256<float> a0 = EightVectors.Load(ref a, i), a1 = EightVectors.Load(ref a, i + 2), a2 = EightVectors.Load(ref a, i + 4), a3 = EightVectors.Load(ref a, i + 6);
            Vector256<float> v = EightVectors.WithSignsOf(EightVectors.Sums(a0 * b0, a1 * b1, a2 * b2, a3 * b3), weight);
            a0 = (a0 * back) + (b0 * EightVectors.First(v));
            a1 = (a1 * back) + (b1 * EightVectors.Second(v));
            a2 = (a2 * back) + (b2 * EightVectors.Third(v));
            a3 = (a3 * back) + (b3 * EightVectors.Fourth(v));
            Vector256<float> squares = EightVectors.Sums(a0 * a0, a1 * a1, a2 * a2, a3 * a3);
            Vector256<float> scales = EightVectors.Scales(squares);
            noughts += (squares + scales) * 0f;
            EightVectors.Store(a0 * EightVectors.First(scales), ref r, i);
            EightVectors.Store(a1 * EightVectors.Second(scales), ref r, i + 2);
            EightVectors.Store(a2 * EightVectors.Third(scales), ref r, i + 4);
            EightVectors.Store(a3 * EightVectors.Fourth(scales), ref r, i + 6);
        }

        nought += EightVectors.Nought(noughts);
        return i;
    }

    /// <summary>The unit means of three lists of quaternions that are on one side, each put where a number says; gives how many it made: what is left makes no eight.</summary>
    /// <param name="places">Where each mean goes in the result.</param>
    /// <param name="a">As many.</param>
    /// <param name="ofA">Weight of the first list.</param>
    /// <param name="b">As many.</param>
    /// <param name="ofB">Weight of the second list.</param>
    /// <param name="c">As many.</param>
    /// <param name="ofC">Weight of the third list.</param>
    /// <param name="result">Long enough for all places.</param>
    public static int Between(ReadOnlySpan<int> places, ReadOnlySpan<Vector4> a, float ofA, ReadOnlySpan<Vector4> b, float ofB, ReadOnlySpan<Vector4> c, float ofC, Span<Vector4> result)
    {
        ref Vector4 first = ref MemoryMarshal.GetReference(a.Slice(0, places.Length));
        ref Vector4 second = ref MemoryMarshal.GetReference(b.Slice(0, places.Length));
        ref Vector4 third = ref MemoryMarshal.GetReference(c.Slice(0, places.Length));
        Vector256<float> weightA = Vector256.Create(ofA);
        Vector256<float> weightB = Vector256.Create(ofB);
        Vector256<float> weightC = Vector256.Create(ofC);
        int i = 0;
        for (; i <= places.Length - EightVectors.Count; i += EightVectors.Count)
        {
            Vector256<float> q0 = (EightVectors.Load(ref first, i) * weightA) + (EightVectors.Load(ref second, i) * weightB) + (EightVectors.Load(ref third, i) * weightC);
            Vector256<float> q1 = (EightVectors.Load(ref first, i + 2) * weightA) + (EightVectors.Load(ref second, i + 2) * weightB) + (EightVectors.Load(ref third, i + 2) * weightC);
            Vector256<float> q2 = (EightVectors.Load(ref first, i + 4) * weightA) + (EightVectors.Load(ref second, i + 4) * weightB) + (EightVectors.Load(ref third, i + 4) * weightC);
            Vector256<float> q3 = (EightVectors.Load(ref first, i + 6) * weightA) + (EightVectors.Load(ref second, i + 6) * weightB) + (EightVectors.Load(ref third, i + 6) * weightC);
            Vector256<float> scales = EightVectors.Scales(EightVectors.Sums(q0 * q0, q1 * q1, q2 * q2, q3 * q3));
            EightVectors.Store(q0 * EightVectors.First(scales), ref result[places[i]], ref result[places[i + 1]]);
            EightVectors.Store(q1 * EightVectors.Second(scales), ref result[places[i + 2]], ref result[places[i + 3]]);
            EightVectors.Store(q2 * EightVectors.Third(scales), ref result[places[i + 4]], ref result[places[i + 5]]);
            EightVectors.Store(q3 * EightVectors.Fourth(scales), ref result[places[i + 6]], ref result[places[i + 7]]);
        }

        return i;
    }
}
#endif
