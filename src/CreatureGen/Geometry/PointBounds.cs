using System;
using System.Numerics;
using CreatureGen.Maths;

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
        var min = new Vector3(float.MaxValue);
        var max = new Vector3(float.MinValue);
        bool any = false;
        foreach (Vector3 p in points)
        {
            if (!TriangleList.IsFinite(p))
            {
                continue;
            }

            any = true;
            min = Vec.Min(p, min);
            max = Vec.Max(p, max);
        }

        return any ? new PointBounds(min, max) : default;
    }
}
