using System;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>A further tail: a tapered tube along its curve in the coat of the body.</summary>
internal static class TailShape
{
    private const int Sides = 10;
    private const int Rows = 12;

    /// <summary>Joints along it, its end among them.</summary>
    private const int Joints = 6;

    /// <summary>Radius of the end relative to that of the root.</summary>
    private const float EndTaper = 0.16f;

    /// <summary>Appends the tail of the left side and tells its joints.</summary>
    /// <param name="builder">Where the tail goes.</param>
    /// <param name="feature">Radius at the root and taper.</param>
    /// <param name="curve">Its axis.</param>
    /// <param name="coat">Linear RGB at a place with a normal.</param>
    public static Vector3[] Append(PieceBuilder builder, FeatureBlueprint feature, in FeatureCurve curve, Func<Vector3, Vector3, Vector3> coat)
    {
        float radius = (float)feature.Radius;
        float taper = Scalar.Clamp((float)feature.Taper, 0.2f, 3f);
        float start = -curve.RootDepth(radius) / curve.Length;
        Span<TubeRow> rows = stackalloc TubeRow[Rows];
        for (int i = 0; i < Rows; i++)
        {
            float x = (float)i / Rows;
            float r = radius * Scalar.Lerp(EndTaper, 1f, (float)PortableMath.Pow(1f - x, taper));
            rows[i] = new TubeRow(curve.Point(start + ((1f - start) * x)), r, r, Vector3.One);
        }

        int first = builder.VertexCount;
        SweptTube.Append(builder, rows, curve.Point(1f), Vector3.One, HornShape.MajorHint(curve), Sides);
        for (int v = first; v < builder.VertexCount; v++)
        {
            builder.SetColour(v, coat(builder.Position(v), builder.Normal(v)));
        }

        var joints = new Vector3[Joints];
        for (int k = 0; k < Joints; k++)
        {
            joints[k] = curve.Point(k / (Joints - 1f));
        }

        return joints;
    }
}
