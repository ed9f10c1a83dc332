using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The left half of a lip's edge, from the middle of the front to the corner of the mouth, measured along itself.</summary>
internal sealed class LipLine
{
    private readonly SurfacePoint[] points;
    private readonly float[] along;

    /// <summary>Takes an edge.</summary>
    /// <param name="points">Points from the middle to the corner with the outward directions of the skin; at least 2, apart from each other.</param>
    /// <param name="direction">Unit direction in which teeth grow from it.</param>
    public LipLine(SurfacePoint[] points, Vector3 direction)
    {
        this.points = points;
        Direction = direction;
        along = new float[points.Length];
        for (int i = 1; i < along.Length; i++)
        {
            along[i] = along[i - 1] + Vec.Distance(points[i - 1].Position, points[i].Position);
        }
    }

    /// <summary>Points that it was made of.</summary>
    public int Count => points.Length;

    /// <summary>Metres.</summary>
    public float Length => along[along.Length - 1];

    /// <summary>Unit direction in which teeth grow from it: down from the upper lip, up from the lower one.</summary>
    public Vector3 Direction { get; }

    /// <summary>The share of its length at which a point lies that it was made of.</summary>
    public float ShareOf(int point) => along[point] / Length;

    /// <summary>A place on it.</summary>
    /// <param name="share">0 in the middle, 1 at the corner.</param>
    /// <param name="inward">Unit direction into the mouth, across <see cref="Direction"/>.</param>
    public Vector3 At(float share, out Vector3 inward)
    {
        float at = share * Length;
        int i = 0;
        while (i < points.Length - 2 && along[i + 1] < at)
        {
            i++;
        }

        float part = Scalar.Clamp((at - along[i]) / (along[i + 1] - along[i]), 0f, 1f);
        Vector3 outward = Vec.Lerp(points[i].Normal, points[i + 1].Normal, part);
        inward = Vec.Normalize(Vec.Reject(Vector3.Zero - outward, Direction), Vector3.Zero - Vector3.UnitZ);
        return Vec.Lerp(points[i].Position, points[i + 1].Position, part);
    }
}
