using System.Collections.Generic;
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

    /// <summary>Share of the lip at which it runs out.</summary>
    private const float End = 0.96f;

    /// <summary>Share of the lip before which it bends for the last time.</summary>
    private const float LastBend = 0.88f;

    /// <summary>What is left of its height there.</summary>
    private const float AtEnd = 0.5f;

    /// <summary>Appends the gum of one lip of the left side. It ends at the middle with a plane face, on which its mirror image stands.</summary>
    /// <param name="builder">Where the gum goes.</param>
    /// <param name="lip">The lip's edge.</param>
    /// <param name="height">How far it stands out beyond the lip, metres.</param>
    /// <param name="inset">How far behind the edge its middle is, metres.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, LipLine lip, float height, float inset, Vector3 colour)
    {
        // It bends with each second point of the lip.
        var rows = new List<TubeRow>();
        for (int i = 0; i < lip.Count && lip.ShareOf(i) < LastBend; i += 2)
        {
            float size = height * Scalar.Lerp(1f, AtEnd, lip.ShareOf(i));
            rows.Add(new TubeRow(Middle(lip.ShareOf(i)), size, Thickness * size, colour));
        }

        SweptTube.Append(builder, rows.ToArray(), Middle(End), colour, lip.Direction, Sides);

        Vector3 Middle(float share)
        {
            Vector3 edge = lip.At(share, out Vector3 inward);
            Vector3 place = edge + (inward * inset) - (lip.Direction * (Sunk * height));
            return share > 0f ? place : new Vector3(0f, place.Y, place.Z);
        }
    }
}
