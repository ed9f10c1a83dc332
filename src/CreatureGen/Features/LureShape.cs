using System;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>An angler's lure: a thin rod that tapers, and a small leaf at its end that is palest at the tip.</summary>
internal static class LureShape
{
    private const int Sides = 8;
    private const int RodRows = 8;
    private const int LeafRows = 6;

    // Radius of the rod at its root, relative to that of the feature, and at its end relative to its root.
    private const float Root = 0.75f;
    private const float AtEnd = 0.3f;

    // The leaf: half its breadth across the body in radii of the feature when this asks for neither a smaller nor a larger one, thickness in breadths, length in halves of the breadth, and the longest part of the lure that is leaf.
    private const float Breadth = 1.05f;
    private const float Thickness = 0.5f;
    private const float Slenderness = 6.5f;
    private const float MostLeaf = 0.34f;

    /// <summary>Where along the leaf it is broadest.</summary>
    private const float Broadest = 0.4f;

    /// <summary>Appends the lure of the midline.</summary>
    /// <param name="builder">Where the lure goes.</param>
    /// <param name="feature">Radius at the root, taper, and size of the leaf (flatness).</param>
    /// <param name="curve">Its axis.</param>
    /// <param name="rod">Linear RGB of the rod.</param>
    /// <param name="leaf">Linear RGB of the leaf where it is broadest.</param>
    /// <param name="tip">Linear RGB of its tip.</param>
    public static void Append(PieceBuilder builder, FeatureBlueprint feature, in FeatureCurve curve, Vector3 rod, Vector3 leaf, Vector3 tip)
    {
        float radius = (float)feature.Radius;
        float taper = Scalar.Clamp((float)feature.Taper, 0.2f, 3f);
        float half = Breadth * Scalar.Clamp((float)feature.Flatness, 0.2f, 4f) * radius;
        float stem = 1f - Math.Min(Slenderness * half / curve.Length, MostLeaf);
        float start = -curve.RootDepth(radius) / curve.Length;
        Span<TubeRow> rows = stackalloc TubeRow[RodRows + LeafRows];
        float end = Root * AtEnd * radius;
        for (int i = 0; i < RodRows; i++)
        {
            float x = i / (RodRows - 1f);
            float r = Root * radius * (AtEnd + ((1f - AtEnd) * (float)PortableMath.Pow(1f - x, taper)));
            rows[i] = new TubeRow(curve.Point(start + ((stem - start) * x)), r, r, Vec.Lerp(rod, leaf, 0.5f * x * x));
        }

        for (int i = 0; i < LeafRows; i++)
        {
            // Opens as a quarter of a wave and runs out as half of one.
            float x = (i + 0.5f) / LeafRows;
            float open = x < Broadest ? (float)PortableMath.Sin(0.5 * PortableMath.Pi * x / Broadest) : 0.5f * (1f + (float)PortableMath.Cos(PortableMath.Pi * (x - Broadest) / (1 - Broadest)));
            float r = Math.Max(0.5f * end, half * open);
            rows[RodRows + i] = new TubeRow(curve.Point(stem + ((1f - stem) * x)), Math.Max(0.5f * end, Thickness * r), r, Vec.Lerp(leaf, tip, Scalar.Smooth((x - 0.25f) / 0.75f)));
        }

        SweptTube.Append(builder, rows, curve.Point(1f), tip, HornShape.MajorHint(curve), Sides);
    }
}
