using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>A sum of weighted squared distances to planes, as a function of the way from a point of one's own choice.</summary>
/// <remarks>
/// Based on: M. Garland and P. S. Heckbert 1997, "Surface simplification using quadric error metrics". About a point near the planes all terms are as small as the distances, so that single precision is enough.
/// </remarks>
internal readonly struct Quadric
{
    private readonly float xx;
    private readonly float xy;
    private readonly float xz;
    private readonly float yy;
    private readonly float yz;
    private readonly float zz;
    private readonly float x;
    private readonly float y;
    private readonly float z;
    private readonly float one;

    private Quadric(float xx, float xy, float xz, float yy, float yz, float zz, float x, float y, float z, float one)
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

    /// <summary>The sum of all weights.</summary>
    public float Weight => xx + yy + zz;

    /// <summary>The squared distance to one plane, times a weight.</summary>
    /// <param name="normal">Unit normal of the plane.</param>
    /// <param name="distance">How far the point is in front of the plane.</param>
    /// <param name="weight">The weight.</param>
    public static Quadric OfPlane(Vector3 normal, float distance, float weight)
    {
        Vector3 n = normal * weight;
        float d = distance * weight;
        return new Quadric(n.X * normal.X, n.X * normal.Y, n.X * normal.Z, n.Y * normal.Y, n.Y * normal.Z, n.Z * normal.Z, d * normal.X, d * normal.Y, d * normal.Z, d * distance);
    }

    /// <summary>The sum of two such functions about the same point.</summary>
    public static Quadric operator +(in Quadric l, in Quadric r) =>
        new(l.xx + r.xx, l.xy + r.xy, l.xz + r.xz, l.yy + r.yy, l.yz + r.yz, l.zz + r.zz, l.x + r.x, l.y + r.y, l.z + r.z, l.one + r.one);

    /// <summary>Its value; not below zero, whatever the rounding.</summary>
    /// <param name="way">The way from the point.</param>
    public float At(Vector3 way)
    {
        float px = way.X, py = way.Y, pz = way.Z;
        float value = (px * ((xx * px) + (2f * ((xy * py) + (xz * pz) + x)))) + (py * ((yy * py) + (2f * ((yz * pz) + y)))) + (pz * ((zz * pz) + (2f * z))) + one;
        return value > 0f ? value : 0f;
    }

    /// <summary>The same about another point.</summary>
    /// <param name="way">The way to it.</param>
    public Quadric About(Vector3 way)
    {
        float px = way.X, py = way.Y, pz = way.Z;
        return new Quadric(xx, xy, xz, yy, yz, zz, x + (xx * px) + (xy * py) + (xz * pz), y + (xy * px) + (yy * py) + (yz * pz), z + (xz * px) + (yz * py) + (zz * pz), At(way));
    }
}
