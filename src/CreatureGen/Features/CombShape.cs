using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Lobes of flesh: on the midline a row of them that grow together into a comb, elsewhere a single one that hangs or stands by itself (a wattle).</summary>
internal static class CombShape
{
    private const int Sides = 8;
    private const int Rows = 6;

    /// <summary>Rings from lobe to lobe.</summary>
    private const double Spacing = 0.8;

    /// <summary>Widest place of a lobe, part of its height, and how much wider it is there than at its root.</summary>
    private const float WidestAt = 0.35f;
    private const float Swelling = 0.25f;

    /// <summary>How much farther back each lobe leans than the one before it.</summary>
    private const double Fan = 0.18;

    /// <summary>Heights of the lobes of a comb, front to rear, parts of its length.</summary>
    private static readonly double[] lobes = { 0.55, 0.85, 1, 0.9, 0.62 };

    /// <summary>Appends the part of the left side or of the midline.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="feature">Ring of its middle; height, half width along the body, thickness and direction of its lobes.</param>
    /// <param name="skin">What it sits on, at scale 1.</param>
    /// <param name="colour">Linear RGB of its flesh.</param>
    public static void Append(PieceBuilder builder, FeatureBlueprint feature, BodySkin skin, Vector3 colour)
    {
        if (feature.Segment is not 0 and not BodyGrid.Segments / 2)
        {
            Lobe(builder, feature, skin, colour);
            return;
        }

        double middle = 0.5 * (lobes.Length - 1);
        for (int i = 0; i < lobes.Length; i++)
        {
            double ring = Scalar.Clamp(feature.Ring + (Spacing * (i - middle)), 0, BodyGrid.Rings - 1);
            Lobe(builder, feature with { Ring = ring, Length = lobes[i] * feature.Length, Forward = feature.Forward - (Fan * (i - middle)) }, skin, colour);
        }
    }

    private static void Lobe(PieceBuilder builder, FeatureBlueprint feature, BodySkin skin, Vector3 colour)
    {
        var curve = new FeatureCurve(feature, skin.At(feature.Ring, feature.Segment), skin.Shape.Forward((int)feature.Ring), Vector3.UnitY, 1f);
        float radius = (float)feature.Radius;
        float thickness = Scalar.Clamp((float)feature.Flatness, 0.1f, 4f);
        float start = -curve.RootDepth(radius) / curve.Length;
        Span<TubeRow> rows = stackalloc TubeRow[Rows];
        for (int i = 0; i < Rows; i++)
        {
            float x = (float)i / Rows;
            float t = start + ((1f - start) * (1f - ((1f - x) * (1f - x))));
            float up = Math.Max(t, 0f);

            // Round at its end, and widest below its middle.
            float round = (float)Math.Sqrt(Math.Max(1f - (up * up), 0f));
            float r = radius * round * (1f + (Swelling * Scalar.Smooth(up / WidestAt)));
            rows[i] = new TubeRow(curve.Point(t), r, r * thickness, colour * Scalar.Lerp(0.72f, 1.1f, up));
        }

        SweptTube.Append(builder, rows, curve.Point(1f), colour * 1.1f, HornShape.MajorHint(curve), Sides);
    }
}
