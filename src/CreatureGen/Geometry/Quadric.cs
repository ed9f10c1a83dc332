using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>A sum of weighted squared distances to planes, as a function of a point.</summary>
/// <remarks>Based on: M. Garland and P. S. Heckbert 1997, "Surface simplification using quadric error metrics".</remarks>
internal readonly struct Quadric
{
    private readonly double xx;
    private readonly double xy;
    private readonly double xz;
    private readonly double yy;
    private readonly double yz;
    private readonly double zz;
    private readonly double x;
    private readonly double y;
    private readonly double z;
    private readonly double one;

    private Quadric(double xx, double xy, double xz, double yy, double yz, double zz, double x, double y, double z, double one)
    {
        this.xx = xx;
        this.xy = xy;
        this.xz = xz;
        this.yy = yy;
        this.yz = yz;
        this.zz = zz;
        this.x = x;
        this.y = y;
        this.z = z;
        this.one = one;
    }

    /// <summary>The squared distance to one plane, times a weight.</summary>
    /// <param name="normal">Unit normal of the plane.</param>
    /// <param name="point">A point of it.</param>
    /// <param name="weight">The weight.</param>
    public static Quadric OfPlane(Vector3 normal, Vector3 point, double weight)
    {
        double a = normal.X, b = normal.Y, c = normal.Z;
        double d = -((a * point.X) + (b * point.Y) + (c * point.Z));
        return new Quadric(weight * a * a, weight * a * b, weight * a * c, weight * b * b, weight * b * c, weight * c * c, weight * a * d, weight * b * d, weight * c * d, weight * d * d);
    }

    /// <summary>The sum of two such functions.</summary>
    public static Quadric operator +(in Quadric l, in Quadric r) =>
        new(l.xx + r.xx, l.xy + r.xy, l.xz + r.xz, l.yy + r.yy, l.yz + r.yz, l.zz + r.zz, l.x + r.x, l.y + r.y, l.z + r.z, l.one + r.one);

    /// <summary>Its value at a point; not below zero, whatever the rounding.</summary>
    public double At(Vector3 p)
    {
        double px = p.X, py = p.Y, pz = p.Z;
        double value = (px * ((xx * px) + (2 * ((xy * py) + (xz * pz) + x)))) + (py * ((yy * py) + (2 * ((yz * pz) + y)))) + (pz * ((zz * pz) + (2 * z))) + one;
        return value > 0 ? value : 0;
    }
}
