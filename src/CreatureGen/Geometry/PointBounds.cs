using System;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>The axis-aligned box of a set of points. Points that are not finite are left out; without any point the box is the origin.</summary>
internal readonly struct PointBounds
{
    private PointBounds(Vector3 min, Vector3 max)
    {
        Min = min;
        Max = max;
    }

    public Vector3 Min { get; }

    public Vector3 Max { get; }

    public double SizeX => (double)Max.X - Min.X;

    public double SizeY => (double)Max.Y - Min.Y;

    public double SizeZ => (double)Max.Z - Min.Z;

    public double DiagonalSquared => (SizeX * SizeX) + (SizeY * SizeY) + (SizeZ * SizeZ);

    public double Diagonal => Math.Sqrt(DiagonalSquared);

    /// <summary>The box of the given points.</summary>
    public static PointBounds Of(ReadOnlySpan<Vector3> points)
    {
        float minX = float.MaxValue, minY = float.MaxValue, minZ = float.MaxValue;
        float maxX = float.MinValue, maxY = float.MinValue, maxZ = float.MinValue;
        bool any = false;
        foreach (Vector3 p in points)
        {
            if (!TriangleList.IsFinite(p))
            {
                continue;
            }

            any = true;
            minX = p.X < minX ? p.X : minX;
            minY = p.Y < minY ? p.Y : minY;
            minZ = p.Z < minZ ? p.Z : minZ;
            maxX = p.X > maxX ? p.X : maxX;
            maxY = p.Y > maxY ? p.Y : maxY;
            maxZ = p.Z > maxZ ? p.Z : maxZ;
        }

        return any ? new PointBounds(new Vector3(minX, minY, minZ), new Vector3(maxX, maxY, maxZ)) : default;
    }
}
