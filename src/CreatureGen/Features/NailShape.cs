using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The broad nails of pillar feet: flat domes half sunk into the skin.</summary>
internal static class NailShape
{
    private const int Sides = 12;

    /// <summary>Appends a nail.</summary>
    /// <param name="builder">Where the nail goes.</param>
    /// <param name="position">Its centre on the skin, model space, metres.</param>
    /// <param name="outward">Unit direction out of the skin.</param>
    /// <param name="radius">Half its width, metres.</param>
    /// <param name="floor">No vertex goes below this height, metres.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, Vector3 position, Vector3 outward, float radius, float floor, Vector3 colour)
    {
        ReadOnlySpan<Vector2> circle = UnitCircle.Directions(Sides);
        Vector3 up = Vec.Normalize(Vec.Reject(Vector3.UnitY, outward), Vector3.UnitZ);
        Vector3 side = Vec.Cross(up, outward);
        ReadOnlySpan<float> lifts = stackalloc float[] { -0.35f, 0.10f, 0.24f };
        ReadOnlySpan<float> widths = stackalloc float[] { 1f, 0.94f, 0.62f };
        int first = builder.VertexCount;
        for (int i = 0; i < lifts.Length; i++)
        {
            for (int k = 0; k < Sides; k++)
            {
                // The first vertex points up: an arch over a straight lower edge.
                float rise = circle[k].X > 0f ? 1.3f : 0.85f;
                Vector3 across = (up * (circle[k].X * rise)) + (side * -circle[k].Y);
                Vector3 point = position + (across * (radius * widths[i])) + (outward * (radius * lifts[i]));
                point.Y = Math.Max(point.Y, floor);
                Vector3 normal = Vec.Normalize((across * (i == 0 ? 1f : 0.7f)) + (outward * (0.5f * i)));
                builder.Vertex(point, normal, colour * (i == 0 ? 0.5f : 0.9f));
            }
        }

        Vector3 top = position + (outward * (0.28f * radius));
        top.Y = Math.Max(top.Y, floor);
        int pole = builder.Vertex(top, outward, colour);
        builder.FillBelow(first, Sides);
        builder.Band(first, first + Sides, Sides);
        builder.Band(first + Sides, first + (2 * Sides), Sides);
        builder.Fan(first + (2 * Sides), pole, Sides);
    }
}
