using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy.Teeth;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Teeth along a lip: a small closed shell each, pointed or with an edge.</summary>
internal static class ToothRow
{
    private const int Sides = 4;

    /// <summary>How deep roots stand in the gum, in heights.</summary>
    private const float Root = 0.25f;

    /// <summary>How far from root to end a tooth is widest but one, and how much is left of a pointed one there.</summary>
    private const float Waist = 0.5f;
    private const float AtWaist = 0.72f;

    /// <summary>Shade of roots, which lie in the shadow of the lip.</summary>
    private const float RootShade = 0.7f;

    /// <summary>Share of the way between the middles of neighbours that their halves may fill: on a lip that bends teeth behind it stand closer than the lip is long.</summary>
    private const float Room = 0.8f;

    /// <summary>Appends the teeth of one lip of the left side.</summary>
    /// <param name="builder">Where the teeth go.</param>
    /// <param name="lip">The lip's edge.</param>
    /// <param name="sets">Which teeth.</param>
    /// <param name="length">Length of the longest tooth, metres.</param>
    /// <param name="inset">How far behind the edge they stand, metres.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, LipLine lip, ToothSet[] sets, float length, float inset, Vector3 colour)
    {
        List<Tooth> teeth = Place(lip, sets, length, inset);
        for (int i = 0; i < teeth.Count; i++)
        {
            // The image of the first one is its neighbour.
            Tooth tooth = teeth[i];
            float before = i > 0 ? Vec.Distance(tooth.At, teeth[i - 1].At) / (tooth.Half + teeth[i - 1].Half) : tooth.At.X / tooth.Half;
            float behind = i + 1 < teeth.Count ? Vec.Distance(tooth.At, teeth[i + 1].At) / (tooth.Half + teeth[i + 1].Half) : 1f / Room;
            Append(builder, tooth, tooth.Half * Math.Min(1f, Room * Math.Min(before, behind)), lip.Direction, colour);
        }
    }

    /// <summary>All teeth of a lip, from the front to the corner.</summary>
    private static List<Tooth> Place(LipLine lip, ToothSet[] sets, float length, float inset)
    {
        var teeth = new List<Tooth>();
        foreach (ToothSet set in sets)
        {
            float room = (set.Stretch.To - set.Stretch.From) / set.Count;
            for (int i = 0; i < set.Count; i++)
            {
                float height = length * Scalar.Lerp(set.Height.First, set.Height.Last, set.Count > 1 ? i / (set.Count - 1f) : 0f) * ((i & 1) == 0 ? 1f : set.Second);
                float breadth = Math.Min(set.Fill * room * lip.Length, set.Stoutest * height);
                Vector3 edge = lip.At(set.Stretch.From + ((i + 0.5f) * room), out Vector3 inward);
                teeth.Add(new Tooth(set, edge + (inward * inset), inward, height, breadth / 2f));
            }
        }

        return teeth;
    }

    private static void Append(PieceBuilder builder, Tooth tooth, float half, Vector3 direction, Vector3 colour)
    {
        Span<TubeRow> rows = stackalloc TubeRow[2];
        (ToothSet set, Vector3 at, Vector3 inward, float height, _) = tooth;
        float thick = half * set.Depth;
        Vector3 across = Vec.Cross(direction, inward);
        rows[0] = new TubeRow(at - (direction * (Root * height)), half, thick, colour * RootShade);
        Vector3 tip = at + (direction * height) + (inward * (set.Curve * height));
        if (set.Edge > 0f)
        {
            // Its edge is half as thick as its root, and all but level.
            rows[1] = new TubeRow(at + (direction * (0.92f * height)) + (inward * (set.Curve * height)), half * set.Edge, 0.5f * thick, colour);
        }
        else
        {
            rows[1] = new TubeRow(Vec.Lerp(at, tip, Waist) - (inward * (0.4f * set.Curve * height)), AtWaist * half, AtWaist * thick, colour);
        }

        SweptTube.Append(builder, rows, tip, colour, across, Sides);
    }

    /// <summary>A tooth in its place: where its root leaves the gum, the direction into the mouth there, its height and half of its breadth at most, metres.</summary>
    private readonly record struct Tooth(ToothSet Set, Vector3 At, Vector3 Inward, float Height, float Half);
}
