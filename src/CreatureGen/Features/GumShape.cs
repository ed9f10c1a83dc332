using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The gum that a row of teeth stands in: a ridge along the inner side of a lip.</summary>
internal static class GumShape
{
    private const int Sides = 4;

    /// <summary>Radius of the ridge, in lengths of the longest tooth.</summary>
    private const float Thickness = 0.24f;

    /// <summary>Appends the gum of one lip of the left side.</summary>
    /// <param name="builder">Where the gum goes.</param>
    /// <param name="lip">Points of the lip's edge from the front to the corner, with the outward directions of the skin; at least 3, or nothing is added.</param>
    /// <param name="direction">Unit direction in which the teeth grow.</param>
    /// <param name="length">Length of the longest tooth, metres.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, ReadOnlySpan<SurfacePoint> lip, Vector3 direction, float length, Vector3 colour)
    {
        if (lip.Length < 3)
        {
            return;
        }

        float radius = Thickness * length;
        var rows = new TubeRow[(lip.Length / 2) + 1];
        Vector3 tip = Vector3.Zero;
        for (int i = 0; i <= rows.Length; i++)
        {
            // Teeth stand closer than the gum bends.
            SurfacePoint at = lip[i * (lip.Length - 1) / rows.Length];
            Vector3 inward = Vec.Normalize(Vec.Reject(Vector3.Zero - at.Normal, direction), Vector3.Zero - at.Normal);
            tip = at.Position + (inward * (1.2f * radius)) - (direction * (0.5f * radius));
            if (i < rows.Length)
            {
                float end = i == 0 ? 0.7f : 1f - (0.4f * i / rows.Length);
                rows[i] = new TubeRow(tip, radius * end, 0.8f * radius * end, colour * (i == 0 ? 0.8f : 1f));
            }
        }

        SweptTube.Append(builder, rows, tip, colour, direction, Sides);
    }
}
