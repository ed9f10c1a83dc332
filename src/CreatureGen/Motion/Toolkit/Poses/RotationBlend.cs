#if NET
using System;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>What <see cref="PoseBlend"/> does with many joints at once.</summary>
/// <remarks>Loops of their own over references, no calls inside: so the compiler keeps all in registers without a profile of earlier runs too.</remarks>
internal static class RotationBlend
{
    /// <summary>The unit quaternions between two lists, the shorter way round; gives how many it made: what is left makes no four.</summary>
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
        Vector128<float> noughts = Vector128.Create(0f);
        Vector128<float> back = Vector128.Create(1f - weight);
        for (; i <= result.Length - FourRotations.Count; i += FourRotations.Count)
        {
            Vector128<float> b0 = FourRotations.Load(ref b, i), b1 = FourRotations.Load(ref b, i + 1), b2 = FourRotations.Load(ref b, i + 2), b3 = FourRotations.Load(ref b, i + 3);
            Vector128<float> a0 = FourRotations.Load(ref a, i), a1 = FourRotations.Load(ref a, i + 1), a2 = FourRotations.Load(ref a, i + 2), a3 = FourRotations.Load(ref a, i + 3);
            Vector128<float> v = FourRotations.WithSignsOf(FourRotations.Sums(a0 * b0, a1 * b1, a2 * b2, a3 * b3), weight);
            a0 = (a0 * back) + (b0 * FourRotations.First(v));
            a1 = (a1 * back) + (b1 * FourRotations.Second(v));
            a2 = (a2 * back) + (b2 * FourRotations.Third(v));
            a3 = (a3 * back) + (b3 * FourRotations.Fourth(v));
            Vector128<float> squares = FourRotations.Sums(a0 * a0, a1 * a1, a2 * a2, a3 * a3);
            Vector128<float> scales = FourRotations.Scales(squares);
            noughts += (squares + scales) * 0f;
            FourRotations.Store(a0 * FourRotations.First(scales), ref r, i);
            FourRotations.Store(a1 * FourRotations.Second(scales), ref r, i + 1);
            FourRotations.Store(a2 * FourRotations.Third(scales), ref r, i + 2);
            FourRotations.Store(a3 * FourRotations.Fourth(scales), ref r, i + 3);
        }

        nought += FourRotations.Nought(noughts);
        return i;
    }

    /// <summary>The unit means of three lists of quaternions that are on one side, each put where a number says; gives how many it made: what is left makes no four.</summary>
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
        Vector128<float> weightA = Vector128.Create(ofA);
        Vector128<float> weightB = Vector128.Create(ofB);
        Vector128<float> weightC = Vector128.Create(ofC);
        int i = 0;
        for (; i <= places.Length - FourRotations.Count; i += FourRotations.Count)
        {
            Vector128<float> q0 = (FourRotations.Load(ref first, i) * weightA) + (FourRotations.Load(ref second, i) * weightB) + (FourRotations.Load(ref third, i) * weightC);
            Vector128<float> q1 = (FourRotations.Load(ref first, i + 1) * weightA) + (FourRotations.Load(ref second, i + 1) * weightB) + (FourRotations.Load(ref third, i + 1) * weightC);
            Vector128<float> q2 = (FourRotations.Load(ref first, i + 2) * weightA) + (FourRotations.Load(ref second, i + 2) * weightB) + (FourRotations.Load(ref third, i + 2) * weightC);
            Vector128<float> q3 = (FourRotations.Load(ref first, i + 3) * weightA) + (FourRotations.Load(ref second, i + 3) * weightB) + (FourRotations.Load(ref third, i + 3) * weightC);
            Vector128<float> scales = FourRotations.Scales(FourRotations.Sums(q0 * q0, q1 * q1, q2 * q2, q3 * q3));
            FourRotations.Store(q0 * FourRotations.First(scales), ref result[places[i]], 0);
            FourRotations.Store(q1 * FourRotations.Second(scales), ref result[places[i + 1]], 0);
            FourRotations.Store(q2 * FourRotations.Third(scales), ref result[places[i + 2]], 0);
            FourRotations.Store(q3 * FourRotations.Fourth(scales), ref result[places[i + 3]], 0);
        }

        return i;
    }
}
#endif
