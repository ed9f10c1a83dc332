using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The skin of one jaw as a bill lies on it: the left half of the rings of the muzzle, from the middle line to the lip.</summary>
internal sealed class BillFace
{
    private readonly SurfacePoint[] skin;
    private readonly Vector3[] toMouth;
    private readonly float[] radius;

    /// <summary>Takes a jaw.</summary>
    /// <param name="skin">Ring after ring from the nose back, in each <paramref name="columns"/> points from the middle line (x = 0) to the lip.</param>
    /// <param name="columns">Points of a ring, at least 2.</param>
    /// <param name="toMouth">Unit direction from the middle line of each ring to the other jaw.</param>
    /// <param name="radius">Mean radius of each ring, metres.</param>
    /// <param name="forward">Unit direction in which the nose looks.</param>
    public BillFace(SurfacePoint[] skin, int columns, Vector3[] toMouth, float[] radius, Vector3 forward)
    {
        this.skin = skin;
        this.toMouth = toMouth;
        this.radius = radius;
        Columns = columns;
        Forward = forward;
    }

    /// <summary>Points of a ring from the middle line to the lip.</summary>
    public int Columns { get; }

    /// <summary>Unit direction in which the nose looks.</summary>
    public Vector3 Forward { get; }

    /// <summary>The skin at a ring and a column.</summary>
    public SurfacePoint At(float ring, float column)
    {
        int i = Math.Min(Math.Max((int)ring, 0), radius.Length - 2);
        int k = Math.Min(Math.Max((int)column, 0), Columns - 2);
        float u = ring - i;
        float v = column - k;
        SurfacePoint a = skin[(i * Columns) + k], b = skin[(i * Columns) + k + 1], c = skin[((i + 1) * Columns) + k], d = skin[((i + 1) * Columns) + k + 1];
        return new SurfacePoint(
            Vec.Lerp(Vec.Lerp(a.Position, b.Position, v), Vec.Lerp(c.Position, d.Position, v), u),
            Vec.Normalize(Vec.Lerp(Vec.Lerp(a.Normal, b.Normal, v), Vec.Lerp(c.Normal, d.Normal, v), u), a.Normal));
    }

    /// <summary>Unit direction from the middle line to the other jaw.</summary>
    public Vector3 ToMouth(float ring)
    {
        int i = Math.Min(Math.Max((int)ring, 0), radius.Length - 2);
        return Vec.Normalize(Vec.Lerp(toMouth[i], toMouth[i + 1], ring - i), toMouth[i]);
    }

    /// <summary>Mean radius, metres.</summary>
    public float Radius(float ring)
    {
        int i = Math.Min(Math.Max((int)ring, 0), radius.Length - 2);
        return Scalar.Lerp(radius[i], radius[i + 1], ring - i);
    }
}
