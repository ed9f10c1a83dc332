using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Teeth along a lip: one small cone for each given point.</summary>
internal static class ToothRow
{
    private const int Sides = 4;

    /// <summary>Index of the longest tooth of a row that starts at the front: the canine.</summary>
    private const int Canine = 2;

    /// <summary>Appends the teeth of one lip of the left side.</summary>
    /// <param name="builder">Where the teeth go.</param>
    /// <param name="lip">Points of the lip's edge from the front to the corner, with the outward directions of the skin.</param>
    /// <param name="direction">Unit direction in which the teeth grow: down from the upper lip, up from the lower one.</param>
    /// <param name="length">Length of the longest tooth, metres.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, ReadOnlySpan<SurfacePoint> lip, Vector3 direction, float length, Vector3 colour)
    {
        Span<TubeRow> rows = stackalloc TubeRow[2];
        for (int i = 0; i < lip.Length; i++)
        {
            // Neighbours differ in height; behind the canine the row falls off towards the corner.
            float back = lip.Length > 1 ? i / (lip.Length - 1f) : 0f;
            float height = length * (i == Canine && lip.Length > 4 ? 1f : ((i & 1) == 0 ? 0.78f : 0.58f) * (1f - (0.35f * back)));
            float radius = 0.24f * height;
            Vector3 inward = Vec.Normalize(Vec.Reject(Vector3.Zero - lip[i].Normal, direction), Vector3.Zero - lip[i].Normal);
            Vector3 root = lip[i].Position + (inward * (1.3f * radius)) - (direction * (0.30f * height));
            Vector3 tip = root + (direction * (1.30f * height)) + (inward * (0.18f * height));
            Vector3 middle = Vec.Lerp(root, tip, 0.55f) - (inward * (0.05f * height));
            rows[0] = new TubeRow(root, radius, 1.1f * radius, colour * 0.72f);
            rows[1] = new TubeRow(middle, 0.72f * radius, 0.78f * radius, colour);
            SweptTube.Append(builder, rows, tip, colour, inward, Sides);
        }
    }
}
