using System;
using System.Numerics;

namespace CreatureGen.Features;

/// <summary>The stalk that an eye sits on: a tube that is wider at both ends.</summary>
internal static class StalkShape
{
    private const int Sides = 8;
    private const int Rows = 6;

    /// <summary>Appends the stalk of the left side or of the midline, up to the middle of the eye.</summary>
    /// <param name="builder">Where the stalk goes.</param>
    /// <param name="curve">Its axis.</param>
    /// <param name="radius">Its radius half way, metres.</param>
    /// <param name="root">Linear RGB at the skin.</param>
    /// <param name="tip">Linear RGB below the eye.</param>
    public static void Append(PieceBuilder builder, in FeatureCurve curve, float radius, Vector3 root, Vector3 tip)
    {
        float start = -curve.RootDepth(1.5f * radius) / curve.Length;
        Span<TubeRow> rows = stackalloc TubeRow[Rows];
        for (int i = 0; i < Rows; i++)
        {
            float x = i / (Rows - 1f);
            float across = (2f * x) - 1f;
            float r = radius * (1f + (0.5f * across * across));
            rows[i] = new TubeRow(curve.Point(start + ((0.96f - start) * x)), r, r, root + ((tip - root) * x));
        }

        SweptTube.Append(builder, rows, curve.Point(1f), tip, HornShape.MajorHint(curve), Sides);
    }
}
