using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The toe of a bird's foot that points back, with its claw.</summary>
internal static class HalluxShape
{
    private const int Sides = 7;

    /// <summary>Share of the length at which the claw begins.</summary>
    private const float Nail = 0.6f;

    /// <summary>Appends the toe; no vertex of it is below height 0.</summary>
    /// <param name="builder">Where the toe goes.</param>
    /// <param name="heel">Where it leaves the foot, model space, metres.</param>
    /// <param name="direction">Unit direction, level.</param>
    /// <param name="radius">Of the toe, metres.</param>
    /// <param name="length">With the claw, metres.</param>
    /// <param name="toe">Linear RGB of the toe.</param>
    /// <param name="claw">Linear RGB of the claw.</param>
    public static void Append(PieceBuilder builder, Vector3 heel, Vector3 direction, float radius, float length, Vector3 toe, Vector3 claw)
    {
        ReadOnlySpan<float> along = stackalloc float[] { -0.15f, 0.2f, 0.45f, Nail, Nail + 0.01f, 0.82f };
        ReadOnlySpan<float> girth = stackalloc float[] { 0.9f, 1f, 0.9f, 0.75f, 0.6f, 0.38f };
        Span<TubeRow> rows = stackalloc TubeRow[along.Length];
        for (int i = 0; i < rows.Length; i++)
        {
            float r = radius * girth[i];
            Vector3 centre = heel + (direction * (along[i] * length));
            centre.Y = Math.Max(1.1f * r, Scalar.Lerp(heel.Y, 1.1f * r, Scalar.Smooth(along[i] * 4f)));
            rows[i] = new TubeRow(centre, r, r, along[i] > Nail ? claw : toe);
        }

        Vector3 tip = heel + (direction * length);
        tip.Y = 0.05f * radius;
        SweptTube.Append(builder, rows, tip, claw * 0.6f, Vector3.UnitY, Sides);
    }
}
