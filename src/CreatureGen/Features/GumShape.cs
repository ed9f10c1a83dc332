using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The gum that a row of teeth stands in: a ridge along the inner side of a lip, from the middle of the front to near the corner.</summary>
internal static class GumShape
{
    private const int Sides = 4;

    /// <summary>Thickness across the lip, in heights.</summary>
    private const float Thickness = 0.8f;

    /// <summary>How far its middle lies within the jaw, in heights: not much more than its crest stands out of the lip.</summary>
    private const float Sunk = 0.25f;

    /// <summary>How far beside the middle it begins, in heights.</summary>
    private const float Apart = 0.03f;

    /// <summary>Share of the lip at which it runs out.</summary>
    private const float End = 0.96f;

    /// <summary>Share of the lip before which it bends for the last time at the latest.</summary>
    private const float LastBend = 0.88f;

    /// <summary>What is left of its height there.</summary>
    private const float AtEnd = 0.5f;

    /// <summary>Appends the gum of one lip of the left side. It begins with a plane face a hair beside the middle, across which its mirror image begins.</summary>
    /// <param name="builder">Where the gum goes.</param>
    /// <param name="lip">The lip's edge.</param>
    /// <param name="height">How far it stands out beyond the lip, metres.</param>
    /// <param name="inset">How far behind the edge its middle is, metres.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, LipLine lip, float height, float inset, Vector3 colour)
    {
        int first = builder.VertexCount;
        Vector3 start = Middle(0f, out Vector3 back);

        // Loops run the same way around in both jaws, seen from the corner.
        float side = Vec.Cross(lip.Direction, back).X > 0f ? 1f : -1f;

        // It bends with each second point of the lip, whatever shape this has: all of a species are triangulated alike.
        int last = (lip.Count - 2) & ~1;
        float squeeze = Math.Min(1f, LastBend / lip.ShareOf(last));
        for (int i = 0; i <= last; i += 2)
        {
            float share = lip.ShareOf(i) * squeeze;
            float size = height * Scalar.Lerp(1f, AtEnd, share);
            Vector3 middle = Middle(share, out Vector3 inward);
            Vector3 up = lip.Direction * size;
            Vector3 across = inward * (side * Thickness * size);
            builder.Vertex(middle + up, Vector3.UnitY, colour);
            builder.Vertex(middle + across, Vector3.UnitY, colour);
            builder.Vertex(middle - up, Vector3.UnitY, colour);
            builder.Vertex(middle - across, Vector3.UnitY, colour);
        }

        LoopLoft.Close(builder, first, Sides, start, colour, Middle(End, out _), colour);

        Vector3 Middle(float share, out Vector3 inward)
        {
            Vector3 edge = lip.At(share, out inward);
            if (share == 0f)
            {
                inward = Vec.Normalize(new Vector3(0f, inward.Y, inward.Z), inward);
                edge.X = Apart * height;
            }

            // On a narrow muzzle both halves would meet behind the lip.
            float room = inward.X < 0f ? Math.Max(edge.X - (Thickness * height), 0f) / -inward.X : inset;
            return edge + (inward * Math.Min(inset, room)) - (lip.Direction * (Sunk * height));
        }
    }
}
