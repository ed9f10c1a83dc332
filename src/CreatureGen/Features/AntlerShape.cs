using System;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>An antler: a curved beam whose tines start inside it and point ahead and up.</summary>
internal static class AntlerShape
{
    private const int BeamRows = 7;
    private const int Sides = 7;
    private const int TineSides = 6;

    /// <summary>Shares of the beam at which tines branch off, and their lengths relative to it.</summary>
    private static readonly (float At, float Length)[] tines = { (0.16f, 0.34f), (0.48f, 0.36f), (0.74f, 0.24f) };

    /// <summary>Appends the antler of the left side.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="feature">Radius and taper.</param>
    /// <param name="curve">Axis of the beam.</param>
    /// <param name="scale">Factor from the blueprint's metres to those of the curve.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, FeatureBlueprint feature, in FeatureCurve curve, float scale, Vector3 colour)
    {
        float radius = (float)feature.Radius * scale;
        float start = -curve.RootDepth(radius) / curve.Length;
        Span<TubeRow> rows = stackalloc TubeRow[BeamRows];
        for (int i = 0; i < BeamRows; i++)
        {
            float x = (float)i / BeamRows;
            float t = start + ((1f - start) * x);
            float r = RadiusAt(radius, x);
            rows[i] = new TubeRow(curve.Point(t), r, r, colour * (0.7f + (0.3f * x)));
        }

        SweptTube.Append(builder, rows, curve.Point(1f), colour * 1.1f, HornShape.MajorHint(curve), Sides);
        Vector3 lean = Vec.Normalize((curve.Forward * 0.75f) + (Vector3.UnitY * 0.65f) - (curve.Skin.Normal * 0.1f));
        Span<TubeRow> tine = rows.Slice(0, 2);
        foreach ((float at, float fraction) in tines)
        {
            Vector3 root = curve.Point(at);
            Vector3 tip = root + (lean * (fraction * curve.Length)) + (Vector3.UnitY * (0.12f * fraction * curve.Length));
            float r = 0.62f * RadiusAt(radius, at);
            tine[0] = new TubeRow(root, r, r, colour * 0.85f);
            tine[1] = new TubeRow(Vec.Lerp(root, tip, 0.55f) + (curve.Forward * (0.06f * fraction * curve.Length)), 0.6f * r, 0.6f * r, colour);
            SweptTube.Append(builder, tine, tip, colour * 1.15f, Vector3.UnitX, TineSides);
        }
    }

    private static float RadiusAt(float radius, float x) => radius * (1f - (0.72f * x));
}
