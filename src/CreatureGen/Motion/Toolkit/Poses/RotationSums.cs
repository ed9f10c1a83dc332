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
    /// <summary>Adds weighted rotations to sums, each on its side, and gives how many; what is left makes no four.</summary>
    public static int Add(ReadOnlySpan<Quaternion> rotations, float weight, Span<Quaternion> sums)
    {
        ref Vector4 q = ref Unsafe.As<Quaternion, Vector4>(ref MemoryMarshal.GetReference(rotations));
        ref Vector4 s = ref Unsafe.As<Quaternion, Vector4>(ref MemoryMarshal.GetReference(sums));
        int i = 0;
        for (; i <= sums.Length - FourVectors.Count; i += FourVectors.Count)
        {
            Vector128<float> q0 = FourVectors.Load(ref q, i), q1 = FourVectors.Load(ref q, i + 1), q2 = FourVectors.Load(ref q, i + 2), q3 = FourVectors.Load(ref q, i + 3);
            Vector128<float> s0 = FourVectors.Load(ref s, i), s1 = FourVectors.Load(ref s, i + 1), s2 = FourVectors.Load(ref s, i + 2), s3 = FourVectors.Load(ref s, i + 3);
            Vector128<float> signed = FourVectors.WithSignsOf(FourVectors.Sums(s0 * q0, s1 * q1, s2 * q2, s3 * q3), weight);
            FourVectors.Store(s0 + (q0 * FourVectors.First(signed)), ref s, i);
            FourVectors.Store(s1 + (q1 * FourVectors.Second(signed)), ref s, i + 1);
            FourVectors.Store(s2 + (q2 * FourVectors.Third(signed)), ref s, i + 2);
            FourVectors.Store(s3 + (q3 * FourVectors.Fourth(signed)), ref s, i + 3);
        }

        return i;
    }

    /// <summary>Divides sums of joints by their weights, and gives how many it did: it ends at less than four, or where one of four needs the fallback.</summary>
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
        Vector128<float> noughts = Vector128.Create(0f);
        for (; i <= totals.Length - FourVectors.Count; i += FourVectors.Count)
        {
            Vector128<float> weights = Vector128.LoadUnsafe(ref t, (nuint)i);
            if (weights.GetElement(0) < PoseMixer.MinTotal || weights.GetElement(1) < PoseMixer.MinTotal || weights.GetElement(2) < PoseMixer.MinTotal || weights.GetElement(3) < PoseMixer.MinTotal)
            {
                break;
            }

            Vector128<float> q0 = FourVectors.Load(ref q, i), q1 = FourVectors.Load(ref q, i + 1), q2 = FourVectors.Load(ref q, i + 2), q3 = FourVectors.Load(ref q, i + 3);
            Vector128<float> squares = FourVectors.Sums(q0 * q0, q1 * q1, q2 * q2, q3 * q3);
            Vector128<float> scales = FourVectors.Scales(squares);
            FourVectors.Store(q0 * FourVectors.First(scales), ref q, i);
            FourVectors.Store(q1 * FourVectors.Second(scales), ref q, i + 1);
            FourVectors.Store(q2 * FourVectors.Third(scales), ref q, i + 2);
            FourVectors.Store(q3 * FourVectors.Fourth(scales), ref q, i + 3);

            // x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3
            Vector128<float> fractions = Vector128.Create(1f) / weights;
            nuint place = (nuint)i * 3;
            Vector128<float> p0 = Vector128.LoadUnsafe(ref p, place) * Vector128.Shuffle(fractions, Vector128.Create(0, 0, 0, 1));
            Vector128<float> p1 = Vector128.LoadUnsafe(ref p, place + 4) * Vector128.Shuffle(fractions, Vector128.Create(1, 1, 2, 2));
            Vector128<float> p2 = Vector128.LoadUnsafe(ref p, place + 8) * Vector128.Shuffle(fractions, Vector128.Create(2, 3, 3, 3));
            p0.StoreUnsafe(ref p, place);
            p1.StoreUnsafe(ref p, place + 4);
            p2.StoreUnsafe(ref p, place + 8);

            // A length that is nought or infinite leaves no rotation.
            noughts += (squares + scales + p0 + p1 + p2) * 0f;
        }

        nought += FourVectors.Nought(noughts);
        return i - from;
    }
}
#endif
