using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Preview.Scenes;

/// <summary>A box with sides along the axes, metres.</summary>
/// <param name="Min">Smallest x, y and z.</param>
/// <param name="Max">Largest x, y and z.</param>
public readonly record struct BoundingBox(Vector3 Min, Vector3 Max)
{
    /// <summary>Its middle.</summary>
    public Vector3 Centre => (Min + Max) * 0.5f;

    /// <summary>Its sides.</summary>
    public Vector3 Size => Max - Min;

    /// <summary>The distance between opposite corners.</summary>
    public float Diagonal => Vec.Length(Size);

    /// <summary>The smallest box around points.</summary>
    /// <exception cref="ArgumentException">There is no point.</exception>
    public static BoundingBox Of(ReadOnlySpan<Vector3> points)
    {
        if (points.Length == 0)
        {
            throw new ArgumentException("no points; expected at least one", nameof(points));
        }

        Vector3 min = points[0];
        Vector3 max = points[0];
        foreach (Vector3 p in points)
        {
            min = new Vector3(Math.Min(min.X, p.X), Math.Min(min.Y, p.Y), Math.Min(min.Z, p.Z));
            max = new Vector3(Math.Max(max.X, p.X), Math.Max(max.Y, p.Y), Math.Max(max.Z, p.Z));
        }

        return new BoundingBox(min, max);
    }

    /// <summary>The smallest box around both.</summary>
    public BoundingBox Around(BoundingBox other) => new(
        new Vector3(Math.Min(Min.X, other.Min.X), Math.Min(Min.Y, other.Min.Y), Math.Min(Min.Z, other.Min.Z)),
        new Vector3(Math.Max(Max.X, other.Max.X), Math.Max(Max.Y, other.Max.Y), Math.Max(Max.Z, other.Max.Z)));

    /// <summary>Corner 0..7: bits 0, 1 and 2 choose the larger x, y and z.</summary>
    public Vector3 Corner(int index) => new(
        (index & 1) != 0 ? Max.X : Min.X,
        (index & 2) != 0 ? Max.Y : Min.Y,
        (index & 4) != 0 ? Max.Z : Min.Z);
}
