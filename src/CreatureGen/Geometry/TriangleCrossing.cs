using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Geometry;

/// <summary>Whether two triangles cut through one another.</summary>
/// <remarks>Based on: T. Möller 1997, "A fast triangle-triangle intersection test": overlap of two intervals on the line that both planes have in common.</remarks>
internal static class TriangleCrossing
{
    /// <summary>
    /// True when the triangles have a segment longer than <paramref name="tolerance"/> in common and each has corners behind the other's plane and
    /// corners not behind it. A corner within <paramref name="tolerance"/> of the plane counts as in front: contact from outside is no crossing.
    /// </summary>
    public static bool Cross(Vector3 a0, Vector3 a1, Vector3 a2, Vector3 b0, Vector3 b1, Vector3 b2, double tolerance)
    {
        if (!TryPlane(b0, b1, b2, out double bx, out double by, out double bz)
            || !Straddles(a0, a1, a2, b0, bx, by, bz, tolerance, out double da0, out double da1, out double da2)
            || !TryPlane(a0, a1, a2, out double ax, out double ay, out double az)
            || !Straddles(b0, b1, b2, a0, ax, ay, az, tolerance, out double db0, out double db1, out double db2))
        {
            return false;
        }

        double dx = Math.Abs((ay * bz) - (az * by));
        double dy = Math.Abs((az * bx) - (ax * bz));
        double dz = Math.Abs((ax * by) - (ay * bx));
        double lowA, highA, lowB, highB;
        if (dx >= dy && dx >= dz)
        {
            Interval(a0.X, a1.X, a2.X, da0, da1, da2, out lowA, out highA);
            Interval(b0.X, b1.X, b2.X, db0, db1, db2, out lowB, out highB);
        }
        else if (dy >= dz)
        {
            Interval(a0.Y, a1.Y, a2.Y, da0, da1, da2, out lowA, out highA);
            Interval(b0.Y, b1.Y, b2.Y, db0, db1, db2, out lowB, out highB);
        }
        else
        {
            Interval(a0.Z, a1.Z, a2.Z, da0, da1, da2, out lowA, out highA);
            Interval(b0.Z, b1.Z, b2.Z, db0, db1, db2, out lowB, out highB);
        }

        // Where the planes are nearly the same, their line and the intervals on it are noise: triangles that lie beside one another do not cross.
        return Math.Min(highA, highB) - Math.Max(lowA, lowB) > tolerance
            && !LiesBeside(a0, a1, a2, b0, b1, b2, ax, ay, az)
            && !LiesBeside(b0, b1, b2, a0, a1, a2, bx, by, bz);
    }

    /// <summary>Whether an edge of the first triangle, in its plane with the given normal, has that triangle on one side and the second on the other.</summary>
    private static bool LiesBeside(Vector3 a0, Vector3 a1, Vector3 a2, Vector3 b0, Vector3 b1, Vector3 b2, double nx, double ny, double nz) =>
        Parts(a0, a1, b0, b1, b2, nx, ny, nz) || Parts(a1, a2, b0, b1, b2, nx, ny, nz) || Parts(a2, a0, b0, b1, b2, nx, ny, nz);

    /// <summary>Whether all corners lie outside of an edge: on the other side than the triangle that it belongs to, counter-clockwise about its normal.</summary>
    private static bool Parts(Vector3 from, Vector3 to, Vector3 b0, Vector3 b1, Vector3 b2, double nx, double ny, double nz)
    {
        double ex = (double)to.X - from.X, ey = (double)to.Y - from.Y, ez = (double)to.Z - from.Z;
        double ox = (ey * nz) - (ez * ny);
        double oy = (ez * nx) - (ex * nz);
        double oz = (ex * ny) - (ey * nx);
        return Distance(b0, from, ox, oy, oz) > 0 && Distance(b1, from, ox, oy, oz) > 0 && Distance(b2, from, ox, oy, oz) > 0;
    }

    private static bool TryPlane(Vector3 a, Vector3 b, Vector3 c, out double x, out double y, out double z)
    {
        double ux = (double)b.X - a.X, uy = (double)b.Y - a.Y, uz = (double)b.Z - a.Z;
        double vx = (double)c.X - a.X, vy = (double)c.Y - a.Y, vz = (double)c.Z - a.Z;
        x = (uy * vz) - (uz * vy);
        y = (uz * vx) - (ux * vz);
        z = (ux * vy) - (uy * vx);
        double length = Math.Sqrt((x * x) + (y * y) + (z * z));
        if (!(length > 0))
        {
            return false;
        }

        x /= length;
        y /= length;
        z /= length;
        return true;
    }

    /// <summary>Distances of three corners from the plane through <paramref name="o"/>; true when some are behind it and some are not.</summary>
    private static bool Straddles(Vector3 a, Vector3 b, Vector3 c, Vector3 o, double nx, double ny, double nz, double tolerance, out double da, out double db, out double dc)
    {
        da = Distance(a, o, nx, ny, nz);
        db = Distance(b, o, nx, ny, nz);
        dc = Distance(c, o, nx, ny, nz);
        int behind = (da < -tolerance ? 1 : 0) + (db < -tolerance ? 1 : 0) + (dc < -tolerance ? 1 : 0);
        da = da < 0 && da >= -tolerance ? 0 : da;
        db = db < 0 && db >= -tolerance ? 0 : db;
        dc = dc < 0 && dc >= -tolerance ? 0 : dc;
        return behind > 0 && behind < 3;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Distance(Vector3 p, Vector3 o, double nx, double ny, double nz) =>
        (((double)p.X - o.X) * nx) + (((double)p.Y - o.Y) * ny) + (((double)p.Z - o.Z) * nz);

    /// <summary>Where a triangle, cut by the other's plane, lies along an axis: from its corners' coordinates there and their distances from the plane.</summary>
    private static void Interval(double p0, double p1, double p2, double d0, double d1, double d2, out double low, out double high)
    {
        double s, t;
        if (d0 < 0 == d1 < 0)
        {
            s = Cut(p2, d2, p0, d0);
            t = Cut(p2, d2, p1, d1);
        }
        else if (d0 < 0 == d2 < 0)
        {
            s = Cut(p1, d1, p2, d2);
            t = Cut(p1, d1, p0, d0);
        }
        else
        {
            s = Cut(p0, d0, p1, d1);
            t = Cut(p0, d0, p2, d2);
        }

        low = Math.Min(s, t);
        high = Math.Max(s, t);
    }

    private static double Cut(double apex, double apexDistance, double end, double endDistance) =>
        apex + ((end - apex) * apexDistance / (apexDistance - endDistance));
}
