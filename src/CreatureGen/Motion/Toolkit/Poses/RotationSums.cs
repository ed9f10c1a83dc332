#if NET
using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Poses;

/// <summary>What <see cref="PoseMixer"/> does with many joints at once.</summary>
/// <remarks>Loops of their own over references, no calls inside: so the compiler keeps all in registers without a profile of earlier runs too.</remarks>
internal static class RotationSums
{
    /// <summary>Adds weighted rotations to sums, each on its side, and gives how many: all, or none where there are fewer than eight.</summary>
    public static int Add(ReadOnlySpan<Quaternion> rotations, float weight, Span<Quaternion> sums)
    {
        int last = sums.Length - EightVectors.Count;
        if (last < 0)
        {
            return 0;
        }

        ref Vector4 q = ref Unsafe.As<Quaternion, Vector4>(ref MemoryMarshal.GetReference(rotations));
        ref Vector4 s = ref Unsafe.As<Quaternion, Vector4>(ref MemoryMarshal.GetReference(sums));
        var end = new EightRotations(ref s, last);
        for (int i = 0; i < last; i += EightVectors.Count)
        {
            AddEight(ref q, ref s, i, weight);
        }

        end.PutBack(ref s, last);
        AddEight(ref q, ref s, last, weight);
        return sums.Length;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void AddEight(ref Vector4 q, ref Vector4 s, int i, float weight)
    {
        Vector256<float> q0 = EightVectors.Load(ref q, i), q1 = EightVectors.Load(ref q, i + 2), q2 = EightVectors.Load(ref q, i + 4), q3 = EightVectors.Load(ref q, i + 6);
        Vector256<float> s0 = EightVectors.Load(ref s, i), s1 = EightVectors.Load(ref s, i + 2), s2 = EightVectors.Load(ref s, i + 4), s3 = EightVectors.Load(ref s, i + 6);
        Vector256<float> signed = EightVectors.WithSignsOf(EightVectors.Sums(s0 * q0, s1 * q1, s2 * q2, s3 * q3), weight);
        EightVectors.Store(s0 + (q0 * EightVectors.First(signed)), ref s, i);
        EightVectors.Store(s1 + (q1 * EightVectors.Second(signed)), ref s, i + 2);
        EightVectors.Store(s2 + (q2 * EightVectors.Third(signed)), ref s, i + 4);
        EightVectors.Store(s3 + (q3 * EightVectors.Fourth(signed)), ref s, i + 6);
    }

    /// <summary>Divides sums of joints by the weight that all have, and gives how many it did: all, or none where there are fewer than eight.</summary>
    /// <param name="total">The sum of weights, not less than <see cref="PoseMixer.MinTotal"/>.</param>
    /// <param name="result">The sums; changed to rotations and positions.</param>
    /// <param name="nought">Becomes NaN if one is not finite.</param>
    public static int FinishEvenly(float total, in Pose result, ref float nought)
    {
        int count = result.Rotations.Length;
        int last = count - EightVectors.Count;
        if (last < 0)
        {
            return 0;
        }

        ref Vector4 q = ref Unsafe.As<Quaternion, Vector4>(ref MemoryMarshal.GetReference(result.Rotations));
        ref float p = ref Unsafe.As<Vector3, float>(ref MemoryMarshal.GetReference(result.Positions));
        Vector256<float> noughts = Vector256.Create(0f);
        Vector256<float> fraction = Vector256.Create(1f / total);
        var rotations = new EightRotations(ref q, last);
        var positions = new EightPositions(ref p, last);
        for (int i = 0; i < last; i += EightVectors.Count)
        {
            noughts += DivideEight(ref q, ref p, i, fraction, fraction, fraction) * 0f;
        }

        rotations.PutBack(ref q, last);
        positions.PutBack(ref p, last);
        noughts += DivideEight(ref q, ref p, last, fraction, fraction, fraction) * 0f;
        nought += EightVectors.Nought(noughts);
        return count;
    }

    /// <summary>Divides sums of joints by their weights, and gives how many it did: it ends at less than eight, or where one of eight needs the fallback.</summary>
    /// <param name="from">The first joint.</param>
    /// <param name="totals">The sums of weights.</param>
    /// <param name="result">The sums; changed to rotations and positions.</param>
    /// <param name="nought">Becomes NaN if one is not finite.</param>
    public static int Finish(int from, ReadOnlySpan<float> totals, in Pose result, ref float nought)
    {
        ref Vector4 q = ref Unsafe.As<Quaternion, Vector4>(ref MemoryMarshal.GetReference(result.Rotations));
        ref float p = ref Unsafe.As<Vector3, float>(ref MemoryMarshal.GetReference(result.Positions));
        ref float t = ref MemoryMarshal.GetReference(totals);
        int i = from;
        Vector256<float> noughts = Vector256.Create(0f);
        for (; i <= totals.Length - EightVectors.Count; i += EightVectors.Count)
        {
            Vector256<float> weights = Vector256.LoadUnsafe(ref t, (nuint)i);
            if (Vector256.LessThanAny(weights, Vector256.Create(PoseMixer.MinTotal)))
            {
                break;
            }

            // x0 y0 z0 x1 y1 z1 x2 y2, z2 x3 y3 z3 x4 y4 z4 x5, y5 z5 x6 y6 z6 x7 y7 z7
            Vector256<float> fractions = Vector256.Create(1f) / weights;
            Vector256<float> first = Vector256.Shuffle(fractions, Vector256.Create(0, 0, 0, 1, 1, 1, 2, 2));
            Vector256<float> second = Vector256.Shuffle(fractions, Vector256.Create(2, 3, 3, 3, 4, 4, 4, 5));
            Vector256<float> third = Vector256.Shuffle(fractions, Vector256.Create(5, 5, 6, 6, 6, 7, 7, 7));
            noughts += DivideEight(ref q, ref p, i, first, second, third) * 0f;
        }

        nought += EightVectors.Nought(noughts);
        return i - from;
    }

    /// <summary>Makes the sums of eight joints rotations and positions. Not finite where one of them is not: a length that is nought or infinite leaves no rotation.</summary>
    /// <param name="q">The rotations of all joints.</param>
    /// <param name="p">The numbers of their positions.</param>
    /// <param name="joint">The first of the eight.</param>
    /// <param name="first">What the first eight numbers of the positions are multiplied by.</param>
    /// <param name="second">The same of the next.</param>
    /// <param name="third">The same of the last.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> DivideEight(ref Vector4 q, ref float p, int joint, Vector256<float> first, Vector256<float> second, Vector256<float> third)
    {
        Vector256<float> q0 = EightVectors.Load(ref q, joint), q1 = EightVectors.Load(ref q, joint + 2), q2 = EightVectors.Load(ref q, joint + 4), q3 = EightVectors.Load(ref q, joint + 6);
        Vector256<float> squares = EightVectors.Sums(q0 * q0, q1 * q1, q2 * q2, q3 * q3);
        Vector256<float> scales = EightVectors.Scales(squares);
        EightVectors.Store(q0 * EightVectors.First(scales), ref q, joint);
        EightVectors.Store(q1 * EightVectors.Second(scales), ref q, joint + 2);
        EightVectors.Store(q2 * EightVectors.Third(scales), ref q, joint + 4);
        EightVectors.Store(q3 * EightVectors.Fourth(scales), ref q, joint + 6);
        nuint place = (nuint)joint * 3;
        Vector256<float> p0 = Vector256.LoadUnsafe(ref p, place) * first;
        Vector256<float> p1 = Vector256.LoadUnsafe(ref p, place + 8) * second;
        Vector256<float> p2 = Vector256.LoadUnsafe(ref p, place + 16) * third;
        p0.StoreUnsafe(ref p, place);
        p1.StoreUnsafe(ref p, place + 8);
        p2.StoreUnsafe(ref p, place + 16);
        return squares + scales + p0 + p1 + p2;
    }

    /// <summary>The last eight sums as they were: lists are not always of whole eights, so the last eight lie over others, and are done from what they were before these. One by one, the three or four that are left took a fifth of a mean.</summary>
    private readonly struct EightRotations
    {
        private readonly Vector256<float> first;
        private readonly Vector256<float> second;
        private readonly Vector256<float> third;
        private readonly Vector256<float> fourth;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public EightRotations(ref Vector4 q, int joint)
        {
            first = EightVectors.Load(ref q, joint);
            second = EightVectors.Load(ref q, joint + 2);
            third = EightVectors.Load(ref q, joint + 4);
            fourth = EightVectors.Load(ref q, joint + 6);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void PutBack(ref Vector4 q, int joint)
        {
            EightVectors.Store(first, ref q, joint);
            EightVectors.Store(second, ref q, joint + 2);
            EightVectors.Store(third, ref q, joint + 4);
            EightVectors.Store(fourth, ref q, joint + 6);
        }
    }

    /// <summary>The same of eight positions, 24 numbers.</summary>
    private readonly struct EightPositions
    {
        private readonly Vector256<float> first;
        private readonly Vector256<float> second;
        private readonly Vector256<float> third;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public EightPositions(ref float p, int joint)
        {
            nuint place = (nuint)joint * 3;
            first = Vector256.LoadUnsafe(ref p, place);
            second = Vector256.LoadUnsafe(ref p, place + 8);
            third = Vector256.LoadUnsafe(ref p, place + 16);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void PutBack(ref float p, int joint)
        {
            nuint place = (nuint)joint * 3;
            first.StoreUnsafe(ref p, place);
            second.StoreUnsafe(ref p, place + 8);
            third.StoreUnsafe(ref p, place + 16);
        }
    }
}
#endif
