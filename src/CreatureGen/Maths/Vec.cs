using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>
/// Vector arithmetic on <see cref="Vector3"/> in plain scalar operations of fixed order.
/// </summary>
/// <remarks>
/// The methods of <c>System.Numerics</c> with the same names may fuse multiplications with additions or change the order of a sum
/// with the width of the processor's registers; these never do. The componentwise operators of <see cref="Vector3"/> are exact and are used as they are.
/// </remarks>
internal static class Vec
{
    /// <summary>Scalar product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Dot(Vector3 a, Vector3 b)
    {
        Vector3 products = a * b;
        return products.X + products.Y + products.Z;
    }

    /// <summary>Right-handed vector product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Cross(Vector3 a, Vector3 b) => SimdKernels.Cross(a, b);

    /// <summary><paramref name="a"/> times a number: what its operator gives, and in browsers much sooner.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Scale(Vector3 a, float factor) => SimdKernels.Scale(a, factor);

    /// <summary><paramref name="a"/> over a number, in the same way.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Divide(Vector3 a, float divisor) => SimdKernels.Divide(a, divisor);

    /// <summary>Squared Euclidean length.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float LengthSquared(Vector3 a) => Dot(a, a);

    /// <summary>Euclidean length.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Length(Vector3 a) => MathF.Sqrt(Dot(a, a));

    /// <summary>Distance between two points.</summary>
    public static float Distance(Vector3 a, Vector3 b) => Length(a - b);

    /// <summary>The unit vector along <paramref name="a"/>, or <paramref name="fallback"/> when <paramref name="a"/> has no direction.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Normalize(Vector3 a, Vector3 fallback)
    {
        float length = Length(a);
        return length > Tolerance.DirectionLength ? Divide(a, length) : fallback;
    }

    /// <summary>The unit vector along <paramref name="a"/>; <paramref name="a"/> must not be zero.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Normalize(Vector3 a) => Divide(a, Length(a));

    /// <summary>The point at <paramref name="t"/> of the way from <paramref name="a"/> to <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Lerp(Vector3 a, Vector3 b, float t) => a + Scale(b - a, t);

    /// <summary>The point on the other side of the sagittal plane x = 0.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Mirror(Vector3 a) => new(-a.X, a.Y, a.Z);

    /// <summary>A unit vector perpendicular to <paramref name="a"/>, always the same one: its product with the axis it leans on least.</summary>
    /// <remarks>+X when <paramref name="a"/> has no direction.</remarks>
    public static Vector3 Perpendicular(Vector3 a)
    {
        float x = Math.Abs(a.X);
        float y = Math.Abs(a.Y);
        float z = Math.Abs(a.Z);
        Vector3 axis = x <= y && x <= z ? Vector3.UnitX : y <= z ? Vector3.UnitY : Vector3.UnitZ;
        return Normalize(Cross(a, axis), Vector3.UnitX);
    }

    /// <summary><paramref name="a"/> without its component along the unit vector <paramref name="axis"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Reject(Vector3 a, Vector3 axis) => a - Scale(axis, Dot(a, axis));

    /// <summary>Rotates <paramref name="a"/> about the unit vector <paramref name="axis"/> by <paramref name="angle"/> radians (Rodrigues).</summary>
    public static Vector3 Rotate(Vector3 a, Vector3 axis, double angle)
    {
        PortableMath.SinCos(angle, out double sine, out double cosine);
        float c = (float)cosine;
        float s = (float)sine;
        return (a * c) + (Cross(axis, a) * s) + (axis * (Dot(axis, a) * (1f - c)));
    }

    /// <summary>The smaller of each component.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Min(Vector3 a, Vector3 b) => SimdKernels.Min(a, b);

    /// <summary>The larger of each component.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Max(Vector3 a, Vector3 b) => SimdKernels.Max(a, b);
}
