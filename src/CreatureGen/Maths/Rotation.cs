using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>
/// Rotations as unit <see cref="Quaternion"/>s (x, y, z, w) = (axis · sin(angle/2), cos(angle/2)), in scalar operations of fixed order.
/// </summary>
/// <remarks>
/// <para>q and −q are the same rotation. A positive angle turns counter-clockwise seen from the tip of its axis (right-handed: a quarter turn about +Y takes +Z to +X).
/// Arguments called unit must have length 1 within a few rounding errors; <see cref="Normalize"/> restores it where rotations are multiplied many times.</para>
/// <para>The methods of <c>System.Numerics</c> with the same names may fuse or reorder operations with the processor; these never do.</para>
/// </remarks>
public static class Rotation
{
    // Half-angle cosine beyond which two rotations are so near (0.003 rad) that the chord and the arc are the same to 1e-9.
    private const double NearlySame = 1 - 1e-6;

    /// <summary><paramref name="v"/> turned by the unit quaternion <paramref name="q"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Rotate(Quaternion q, Vector3 v) => SimdKernels.Rotate(q, v);

    /// <summary>The rotation that applies <paramref name="b"/> first, then <paramref name="a"/> (Hamilton's product a·b). A joint's model rotation is Multiply(parent, local).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Multiply(Quaternion a, Quaternion b) => SimdKernels.Multiply(a, b);

    /// <summary>The rotation that undoes the unit quaternion <paramref name="q"/>: its conjugate.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Quaternion Inverse(Quaternion q) => SimdKernels.Conjugate(q);

    /// <summary>The rotation seen in the mirror x = 0: mirrored vectors turned by it are the mirrored results.</summary>
    public static Quaternion Mirror(Quaternion q) => new(q.X, -q.Y, -q.Z, q.W);

    /// <summary><paramref name="q"/> at length 1; the identity when it has no length.</summary>
    public static Quaternion Normalize(Quaternion q) => Unit(q.X, q.Y, q.Z, q.W);

    /// <summary>The rotation about the unit vector <paramref name="axis"/> by <paramref name="angle"/> radians.</summary>
    public static Quaternion FromAxisAngle(Vector3 axis, double angle)
    {
        PortableMath.SinCos(0.5 * angle, out double sine, out double cosine);
        return new Quaternion((float)(axis.X * sine), (float)(axis.Y * sine), (float)(axis.Z * sine), (float)cosine);
    }

    /// <summary>The smallest rotation that takes the direction of <paramref name="from"/> to that of <paramref name="to"/>.</summary>
    /// <returns>A half turn about <see cref="Vec.Perpendicular"/> of <paramref name="from"/> when they are opposite; the identity when either is zero.</returns>
    /// <remarks>With m the middle of both unit vectors, (from × m, from · m): no angle is taken, so nothing is lost near 0.</remarks>
    public static Quaternion FromTo(Vector3 from, Vector3 to)
    {
        double fromLength = Length(from.X, from.Y, from.Z);
        double toLength = Length(to.X, to.Y, to.Z);
        if (!(fromLength > 0) || !(toLength > 0))
        {
            return Quaternion.Identity;
        }

        double fx = from.X / fromLength, fy = from.Y / fromLength, fz = from.Z / fromLength;
        double mx = fx + (to.X / toLength), my = fy + (to.Y / toLength), mz = fz + (to.Z / toLength);
        if (Length(mx, my, mz) < Tolerance.OppositeDirections)
        {
            Vector3 axis = Vec.Perpendicular(new Vector3((float)fx, (float)fy, (float)fz));
            return new Quaternion(axis.X, axis.Y, axis.Z, 0f);
        }

        return Unit((fy * mz) - (fz * my), (fz * mx) - (fx * mz), (fx * my) - (fy * mx), (fx * mx) + (fy * my) + (fz * mz));
    }

    /// <summary>The rotation that takes +X, +Y, +Z to three perpendicular unit vectors with <paramref name="x"/> × <paramref name="y"/> = <paramref name="z"/>.</summary>
    /// <remarks>Based on: S. W. Shepperd, "Quaternion from rotation matrix" (1978): divided by a component of at least one half.</remarks>
    public static Quaternion FromBasis(Vector3 x, Vector3 y, Vector3 z)
    {
        double xx = x.X, yy = y.Y, zz = z.Z;
        if (xx + yy + zz >= 0)
        {
            return Unit((double)y.Z - z.Y, (double)z.X - x.Z, (double)x.Y - y.X, 1 + xx + yy + zz);
        }

        if (xx >= yy && xx >= zz)
        {
            return Unit(1 + xx - yy - zz, (double)x.Y + y.X, (double)x.Z + z.X, (double)y.Z - z.Y);
        }

        return yy >= zz
            ? Unit((double)x.Y + y.X, 1 - xx + yy - zz, (double)y.Z + z.Y, (double)z.X - x.Z)
            : Unit((double)x.Z + z.X, (double)y.Z + z.Y, 1 - xx - yy + zz, (double)x.Y - y.X);
    }

    /// <summary>What the unit quaternion <paramref name="q"/> makes of +X, +Y and +Z.</summary>
    public static void ToBasis(Quaternion q, out Vector3 x, out Vector3 y, out Vector3 z)
    {
        float xx = q.X * q.X, yy = q.Y * q.Y, zz = q.Z * q.Z;
        float xy = q.X * q.Y, xz = q.X * q.Z, yz = q.Y * q.Z;
        float wx = q.W * q.X, wy = q.W * q.Y, wz = q.W * q.Z;
        x = new Vector3(1f - (2f * (yy + zz)), 2f * (xy + wz), 2f * (xz - wy));
        y = new Vector3(2f * (xy - wz), 1f - (2f * (xx + zz)), 2f * (yz + wx));
        z = new Vector3(2f * (xz + wy), 2f * (yz - wx), 1f - (2f * (xx + yy)));
    }

    /// <summary>The rotation at <paramref name="t"/> of the shorter way from <paramref name="a"/> to <paramref name="b"/> at even speed; t outside 0..1 goes on beyond them.</summary>
    /// <remarks>Based on: K. Shoemake, "Animating rotation with quaternion curves" (1985). Rotations less than 0.003 rad apart go by <see cref="Nlerp"/>, which is the same there.</remarks>
    public static Quaternion Slerp(Quaternion a, Quaternion b, double t)
    {
        double dot = Dot(a, b);
        double sign = dot < 0 ? -1 : 1;
        double cosine = dot * sign;
        if (cosine > NearlySame)
        {
            return Nlerp(a, b, t);
        }

        double half = PortableMath.Atan2(Math.Sqrt(Math.Max(0, (1 - cosine) * (1 + cosine))), cosine);
        return Blend(a, PortableMath.Sin((1 - t) * half), b, sign * PortableMath.Sin(t * half));
    }

    /// <summary>The rotation at <paramref name="t"/> of the straight line from <paramref name="a"/> to <paramref name="b"/> or −b, whichever is nearer: the shorter way, faster in its middle.</summary>
    public static Quaternion Nlerp(Quaternion a, Quaternion b, double t) => Blend(a, 1 - t, b, Dot(a, b) < 0 ? -t : t);

    /// <summary>Takes <paramref name="q"/> apart into a turn about the unit vector <paramref name="axis"/> and then a swing about an axis perpendicular to it.</summary>
    /// <param name="q">A unit quaternion.</param>
    /// <param name="axis">A unit vector, in the space q turns from.</param>
    /// <param name="swing">Takes <paramref name="axis"/> to where q takes it, by the shortest way; w is not negative.</param>
    /// <param name="twist">Turns about <paramref name="axis"/> by −π..π; w is not negative. The identity when q turns the axis round to its opposite, where any twist would do.</param>
    /// <remarks>Multiply(swing, twist) is q or −q. Based on: P. Dobrowolski, "Swing-twist decomposition in Clifford algebra" (2015).</remarks>
    public static void SwingTwist(Quaternion q, Vector3 axis, out Quaternion swing, out Quaternion twist)
    {
        double along = ((double)q.X * axis.X) + ((double)q.Y * axis.Y) + ((double)q.Z * axis.Z);
        double sign = q.W < 0 ? -1 : 1;
        double length = Math.Sqrt((along * along) + ((double)q.W * q.W));
        if (length < Tolerance.OppositeDirections)
        {
            twist = Quaternion.Identity;
            swing = new Quaternion(q.X, q.Y, q.Z, 0f);
            return;
        }

        double s = sign * along / length;
        double w = sign * q.W / length;
        double tx = s * axis.X, ty = s * axis.Y, tz = s * axis.Z;
        twist = new Quaternion((float)tx, (float)ty, (float)tz, (float)w);

        // q · conjugate(twist); its w is (along² + w²) / length.
        swing = Unit(
            sign * ((q.X * w) - (q.W * tx) - (q.Y * tz) + (q.Z * ty)),
            sign * ((q.Y * w) - (q.W * ty) - (q.Z * tx) + (q.X * tz)),
            sign * ((q.Z * w) - (q.W * tz) - (q.X * ty) + (q.Y * tx)),
            length);
    }

    /// <summary>How far <paramref name="q"/> turns, radians, 0..π.</summary>
    public static double Angle(Quaternion q) => 2 * PortableMath.Atan2(Length(q.X, q.Y, q.Z), Math.Abs((double)q.W));

    /// <summary>How far one rotation is turned from another, radians, 0..π.</summary>
    internal static double AngleBetween(Quaternion a, Quaternion b) => Angle(Multiply(Inverse(a), b));

    private static Quaternion Blend(Quaternion a, double u, Quaternion b, double v) => Unit((a.X * u) + (b.X * v), (a.Y * u) + (b.Y * v), (a.Z * u) + (b.Z * v), (a.W * u) + (b.W * v));

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Quaternion Unit(double x, double y, double z, double w)
    {
        double length = Math.Sqrt((x * x) + (y * y) + (z * z) + (w * w));
        return length > 0 ? new Quaternion((float)(x / length), (float)(y / length), (float)(z / length), (float)(w / length)) : Quaternion.Identity;
    }

    private static double Dot(Quaternion a, Quaternion b) => ((double)a.X * b.X) + ((double)a.Y * b.Y) + ((double)a.Z * b.Z) + ((double)a.W * b.W);

    private static double Length(double x, double y, double z) => Math.Sqrt((x * x) + (y * y) + (z * z));
}
