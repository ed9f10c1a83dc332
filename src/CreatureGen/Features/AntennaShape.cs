using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>A feeler: a thin tube along its curve with a small knob at the end.</summary>
internal static class AntennaShape
{
    private const int Sides = 6;
    private const int Rows = 8;

    /// <summary>Sections of a knob.</summary>
    private const int KnobRows = 3;

    /// <summary>Radius of the knob relative to that of the root, when the feature asks for neither a smaller nor a larger one.</summary>
    private const float Knob = 1.55f;

    /// <summary>Radius of the tube at its end relative to that of the root.</summary>
    private const float EndTaper = 0.28f;

    /// <summary>Appends a feeler of the left side. Its joints are <see cref="FeatureCurve.JointPoints"/>.</summary>
    /// <param name="builder">Where the feeler goes.</param>
    /// <param name="feature">Radius at the root, taper, and size of the knob (flatness).</param>
    /// <param name="curve">Its axis.</param>
    /// <param name="scale">Factor from the blueprint's metres to those of the curve.</param>
    /// <param name="colour">Linear RGB of the tube.</param>
    /// <param name="knob">Linear RGB of the knob.</param>
    public static void Append(PieceBuilder builder, FeatureBlueprint feature, in FeatureCurve curve, float scale, Vector3 colour, Vector3 knob)
    {
        float radius = (float)feature.Radius * scale;
        float taper = Scalar.Clamp((float)feature.Taper, 0.2f, 3f);
        float knobRadius = Math.Max(Knob * Scalar.Clamp((float)feature.Flatness, 0.2f, 4f), EndTaper) * radius;
        float half = Math.Min(1.3f * knobRadius / curve.Length, 0.12f);
        float neck = 1f - (2f * half);
        float start = -curve.RootDepth(radius) / curve.Length;
        Span<TubeRow> rows = stackalloc TubeRow[Rows + KnobRows];
        for (int i = 0; i < Rows; i++)
        {
            float x = i / (Rows - 1f);
            float t = start + ((neck - start) * x);
            float r = radius * (EndTaper + ((1f - EndTaper) * (float)PortableMath.Pow(1f - x, taper)));
            rows[i] = new TubeRow(curve.Point(t), r, r, colour * Scalar.Lerp(0.75f, 1f, Math.Min(1f, 4f * x)));
        }

        // The knob starts at the neck itself: its colour edge is a ring of its own.
        float neckRadius = rows[Rows - 1].Major;
        rows[Rows] = new TubeRow(curve.Point(neck + (0.12f * half)), Math.Max(neckRadius, 0.62f * knobRadius), Math.Max(neckRadius, 0.62f * knobRadius), knob * 0.7f);
        rows[Rows + 1] = new TubeRow(curve.Point(neck + (0.85f * half)), knobRadius, knobRadius, knob);
        rows[Rows + 2] = new TubeRow(curve.Point(neck + (1.6f * half)), 0.72f * knobRadius, 0.72f * knobRadius, knob);
        SweptTube.Append(builder, rows, curve.Point(1f), knob, HornShape.MajorHint(curve), Sides);
    }
}
