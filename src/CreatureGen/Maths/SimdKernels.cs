using System.Numerics;
using System.Runtime.CompilerServices;
#if NET
using System.Runtime.Intrinsics;
#endif

namespace CreatureGen.Maths;

/// <summary>
/// The products that <see cref="Rotation"/> and <see cref="Vec"/> are made of. Where the framework allows, with all components side by side in a register: taking vectors of System.Numerics apart into numbers
/// and putting them together again costs more than the arithmetic.
/// </summary>
/// <remarks>
/// Rearranging, changing signs, multiplying and adding lane by lane are exact or rounded once, in hardware and in the runtime's substitute for it. Each lane does what the written-out form of its component does, in its
/// order; a − b is a + (−b). So the bits are the same. A number is put into all lanes before it is multiplied with: the operators that take a number are calls in browsers, a dozen times as dear.
/// </remarks>
internal static class SimdKernels
{
    /// <summary>A vector turned by a unit quaternion.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Rotate(Quaternion q, Vector3 v) => Turn(q, v, 2f);

    /// <summary>A vector turned by a quaternion of any length but none, the square of which is given.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 RotateByAny(Quaternion q, float squared, Vector3 v) => Turn(q, v, 2f / squared);

#if NET
    /// <summary>Hamilton's product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Multiply(Quaternion first, Quaternion second)
    {
        Vector128<float> a = first.AsVector128();
        Vector128<float> b = second.AsVector128();
        Vector128<float> w = Vector128.Shuffle(a, Vector128.Create(3, 3, 3, 3)) * b;
        Vector128<float> x = Vector128.Shuffle(a, Vector128.Create(0, 0, 0, 0)) * (Vector128.Shuffle(b, Vector128.Create(3, 2, 1, 0)) ^ Vector128.Create(0f, -0f, 0f, -0f));
        Vector128<float> y = Vector128.Shuffle(a, Vector128.Create(1, 1, 1, 1)) * (Vector128.Shuffle(b, Vector128.Create(2, 3, 0, 1)) ^ Vector128.Create(0f, 0f, -0f, -0f));
        Vector128<float> z = Vector128.Shuffle(a, Vector128.Create(2, 2, 2, 2)) * (Vector128.Shuffle(b, Vector128.Create(1, 0, 3, 2)) ^ Vector128.Create(-0f, 0f, 0f, -0f));
        return (w + x + y + z).AsQuaternion();
    }

    /// <summary>The quaternion of opposite vector part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Conjugate(Quaternion q) => (q.AsVector128() ^ Vector128.Create(-0f, -0f, -0f, 0f)).AsQuaternion();

    /// <summary>Right-handed vector product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Cross(Vector3 first, Vector3 second)
    {
        Vector128<float> a = first.AsVector128Unsafe();
        Vector128<float> b = second.AsVector128Unsafe();
        return ((Next(a) * Last(b)) - (Last(a) * Next(b))).AsVector3();
    }

    /// <summary>The smaller of each component; the second where neither is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Min(Vector3 first, Vector3 second)
    {
        Vector128<float> a = first.AsVector128Unsafe();
        Vector128<float> b = second.AsVector128Unsafe();
        return Vector128.ConditionalSelect(Vector128.LessThan(a, b), a, b).AsVector3();
    }

    /// <summary>The larger of each component; the second where neither is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Max(Vector3 first, Vector3 second)
    {
        Vector128<float> a = first.AsVector128Unsafe();
        Vector128<float> b = second.AsVector128Unsafe();
        return Vector128.ConditionalSelect(Vector128.LessThan(b, a), a, b).AsVector3();
    }

    /// <summary>All components of a vector times a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Scale(Vector3 v, float factor) => (v.AsVector128Unsafe() * Vector128.Create(factor)).AsVector3();

    /// <summary>All components of a vector over a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Divide(Vector3 v, float divisor) => (v.AsVector128Unsafe() / Vector128.Create(divisor)).AsVector3();

    /// <summary>All components of a quaternion times a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Scale(Quaternion q, float factor) => (q.AsVector128() * Vector128.Create(factor)).AsQuaternion();

    /// <summary>The sum of the products of all components, x first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Dot(Quaternion a, Quaternion b)
    {
        Vector128<float> p = a.AsVector128() * b.AsVector128();
        return p.ToScalar() + p.GetElement(1) + p.GetElement(2) + p.GetElement(3);
    }

    /// <summary>a·u + b·v, component by component.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Mix(Quaternion a, float u, Quaternion b, float v) => ((a.AsVector128() * Vector128.Create(u)) + (b.AsVector128() * Vector128.Create(v))).AsQuaternion();

    /// <summary>A vector turned by a quaternion; twice is 2 over its squared length.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3 Turn(Quaternion rotation, Vector3 vector, float twice)
    {
        Vector128<float> q = rotation.AsVector128();
        Vector128<float> v = vector.AsVector128Unsafe();
        Vector128<float> next = Next(q);
        Vector128<float> last = Last(q);
        Vector128<float> t = ((next * Last(v)) - (last * Next(v))) * Vector128.Create(twice);
        return (v + (Vector128.Shuffle(q, Vector128.Create(3, 3, 3, 3)) * t) + ((next * Last(t)) - (last * Next(t)))).AsVector3();
    }

    /// <summary>(y, z, x).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Next(Vector128<float> v) => Vector128.Shuffle(v, Vector128.Create(1, 2, 0, 3));

    /// <summary>(z, x, y).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector128<float> Last(Vector128<float> v) => Vector128.Shuffle(v, Vector128.Create(2, 0, 1, 3));
#else
    /// <summary>A vector turned by a quaternion; twice is 2 over its squared length.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector3 Turn(Quaternion q, Vector3 v, float twice)
    {
        float tx = twice * ((q.Y * v.Z) - (q.Z * v.Y));
        float ty = twice * ((q.Z * v.X) - (q.X * v.Z));
        float tz = twice * ((q.X * v.Y) - (q.Y * v.X));
        return new Vector3(
            v.X + (q.W * tx) + ((q.Y * tz) - (q.Z * ty)),
            v.Y + (q.W * ty) + ((q.Z * tx) - (q.X * tz)),
            v.Z + (q.W * tz) + ((q.X * ty) - (q.Y * tx)));
    }

    /// <summary>Hamilton's product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Multiply(Quaternion a, Quaternion b) => Of(
        (a.W * b.X) + (a.X * b.W) + (a.Y * b.Z) - (a.Z * b.Y),
        (a.W * b.Y) - (a.X * b.Z) + (a.Y * b.W) + (a.Z * b.X),
        (a.W * b.Z) + (a.X * b.Y) - (a.Y * b.X) + (a.Z * b.W),
        (a.W * b.W) - (a.X * b.X) - (a.Y * b.Y) - (a.Z * b.Z));

    /// <summary>The quaternion of opposite vector part.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Conjugate(Quaternion q) => Of(-q.X, -q.Y, -q.Z, q.W);

    /// <summary>Right-handed vector product.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Cross(Vector3 a, Vector3 b) => new((a.Y * b.Z) - (a.Z * b.Y), (a.Z * b.X) - (a.X * b.Z), (a.X * b.Y) - (a.Y * b.X));

    /// <summary>The smaller of each component; the second where neither is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Min(Vector3 a, Vector3 b) => new(a.X < b.X ? a.X : b.X, a.Y < b.Y ? a.Y : b.Y, a.Z < b.Z ? a.Z : b.Z);

    /// <summary>The larger of each component; the second where neither is.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Max(Vector3 a, Vector3 b) => new(a.X > b.X ? a.X : b.X, a.Y > b.Y ? a.Y : b.Y, a.Z > b.Z ? a.Z : b.Z);

    /// <summary>All components of a vector times a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Scale(Vector3 v, float factor) => v * factor;

    /// <summary>All components of a vector over a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Divide(Vector3 v, float divisor) => v / divisor;

    /// <summary>All components of a quaternion times a number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Scale(Quaternion q, float factor) => Of(q.X * factor, q.Y * factor, q.Z * factor, q.W * factor);

    /// <summary>The sum of the products of all components, x first.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Dot(Quaternion a, Quaternion b) => (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z) + (a.W * b.W);

    /// <summary>a·u + b·v, component by component.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Mix(Quaternion a, float u, Quaternion b, float v) => Of((a.X * u) + (b.X * v), (a.Y * u) + (b.Y * v), (a.Z * u) + (b.Z * v), (a.W * u) + (b.W * v));

    /// <summary>A quaternion of its components, set one by one.</summary>
    /// <remarks>
    /// The runtime of browsers makes one instruction of the constructor, and its compiler of traces copies the four numbers one after the other to where the result belongs. Where that is the argument of a call and lies over
    /// the numbers themselves (after 16 bytes of other arguments), the third and the fourth are overwritten before they are read: rotations without unit length, in .NET 10.0.12.
    /// </remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quaternion Of(float x, float y, float z, float w)
    {
        Quaternion q;
        q.X = x;
        q.Y = y;
        q.Z = z;
        q.W = w;
        return q;
    }
#endif
}
