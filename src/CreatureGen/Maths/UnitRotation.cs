using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>Rotations between unit vectors in single precision, for code that runs for every joint of every frame. <see cref="Rotation"/> has the same in double precision and for vectors of any length.</summary>
internal static class UnitRotation
{
    private const double MinSine = 1e-4;
    private const float NearlyOpposite = 0.01f;

    /// <summary>The smallest rotation that takes one unit vector to another: (from × to, 1 + from · to) brought to unit length.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion FromTo(Vector3 from, Vector3 to)
    {
        Quaternion turn = Between(from, to, out _);
        return SimdKernels.Scale(turn, 1f / MathF.Sqrt(SimdKernels.Dot(turn, turn)));
    }

    /// <summary>The same, not yet brought to unit length, and the square of its length, which is known before it is made.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Between(Vector3 from, Vector3 to, out float squared)
    {
        float w = 1f + Vec.Dot(from, to);
        if (w > NearlyOpposite)
        {
            // |from × to|² + (1 + from · to)² of unit vectors.
            squared = 2f * w;
            return new Quaternion(Vec.Cross(from, to), w);
        }

        squared = 1f;
        return Rotation.FromTo(from, to);
    }

    /// <summary>The rotation that takes one unit vector to another and a second vector as near as it can to another second, of any length.</summary>
    /// <remarks>The smallest rotation that does the first, then a roll about where that leads. A second vector along its first says nothing. Near opposite directions the axis of the smallest rotation is in the rounding, and bases are used instead.
    /// Inlined, which takes a fifth off the update of a walker: vectors of three that are handed over lie on the stack with what was there beside them, and where that is a denormal number the processor
    /// takes a hundred cycles for each product of four.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Frame(Vector3 from, Vector3 fromSide, Vector3 to, Vector3 toSide)
    {
        if (!(1f + Vec.Dot(from, to) > NearlyOpposite))
        {
            return BasisToBasis(from, fromSide, to, toSide);
        }

        Quaternion swing = Between(from, to, out float squared);
        Vector3 now = Vec.Reject(SimdKernels.RotateByAny(swing, squared, fromSide), to);
        Vector3 wanted = Vec.Reject(toSide, to);
        float nowSquared = Vec.LengthSquared(now);
        float wantedSquared = Vec.LengthSquared(wanted);
        if (!(wantedSquared > MinSine * MinSine * Vec.LengthSquared(toSide)) || !(nowSquared > MinSine * MinSine * Vec.LengthSquared(fromSide)))
        {
            return SimdKernels.Scale(swing, 1f / MathF.Sqrt(squared));
        }

        float length = MathF.Sqrt(nowSquared * wantedSquared);
        float cosine = Vec.Dot(now, wanted);
        float sine = Vec.Dot(Vec.Cross(now, wanted), to);
        Quaternion roll;
        if (length + cosine > NearlyOpposite * length)
        {
            roll = new Quaternion(Vec.Scale(to, sine), length + cosine);
        }
        else
        {
            double inverse = 1.0 / length;
            HalfAngle.Of(cosine * inverse, sine * inverse, out double c, out double s);
            roll = new Quaternion(Vec.Scale(to, (float)s), (float)c);
        }

        Quaternion turn = Rotation.Multiply(roll, swing);
        return SimdKernels.Scale(turn, 1f / MathF.Sqrt(SimdKernels.Dot(turn, turn)));
    }

    /// <summary>The rotation at <paramref name="t"/> of the straight line between two unit quaternions, the shorter way.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Nlerp(Quaternion a, Quaternion b, float t)
    {
        Quaternion mix = SimdKernels.Mix(a, 1f - t, b, SimdKernels.Dot(a, b) < 0f ? -t : t);
        return SimdKernels.Scale(mix, 1f / MathF.Sqrt(SimdKernels.Dot(mix, mix)));
    }

    /// <summary>What a rotation makes of +Y, the direction of a bone in its own space.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 BoneAxis(Quaternion q) => new(2f * ((q.X * q.Y) - (q.W * q.Z)), 1f - (2f * ((q.X * q.X) + (q.Z * q.Z))), 2f * ((q.Y * q.Z) + (q.W * q.X)));

    /// <summary>One step of Newton's towards unit length: what a few products lose. Quaternions far from it are brought there wholly.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Renormalize(Quaternion q)
    {
        float squared = SimdKernels.Dot(q, q);
        return Math.Abs(squared - 1f) < 1e-3f ? SimdKernels.Scale(q, 1.5f - (0.5f * squared)) : Rotation.Normalize(q);
    }

    private static Quaternion BasisToBasis(Vector3 from, Vector3 fromSide, Vector3 to, Vector3 toSide)
    {
        Vector3 x = Across(fromSide, from, Vec.Perpendicular(from));
        Vector3 y = Across(toSide, to, Across(fromSide, to, Vec.Perpendicular(to)));
        Quaternion a = Rotation.FromBasis(x, from, Vec.Cross(x, from));
        Quaternion b = Rotation.FromBasis(y, to, Vec.Cross(y, to));
        return Rotation.Normalize(Rotation.Multiply(b, Rotation.Inverse(a)));
    }

    private static Vector3 Across(Vector3 v, Vector3 axis, Vector3 fallback)
    {
        Vector3 across = Vec.Reject(v, axis);
        float squared = Vec.LengthSquared(across);
        return squared > (float)(MinSine * MinSine) * Vec.LengthSquared(v) ? across / (float)Math.Sqrt(squared) : fallback;
    }

    /// <summary>A rotation tilted the shortest way, so that its own up points along a direction.</summary>
    /// <param name="rotation">Unit.</param>
    /// <param name="up">Unit.</param>
    public static Quaternion Upright(Quaternion rotation, Vector3 up) =>
        Renormalize(Rotation.Multiply(FromTo(Rotation.Rotate(rotation, Vector3.UnitY), up), rotation));
}
