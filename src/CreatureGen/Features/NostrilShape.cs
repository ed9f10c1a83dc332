using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>A nostril: a low oval rim in the colour of the skin around a dark bowl.</summary>
/// <remarks>A real hole would need the skin cut; the bowl lies a hair above the skin and reads as a pit by its colour and its normals.</remarks>
internal static class NostrilShape
{
    private const int Sides = 10;

    /// <summary>Half its width at its root, in half widths, and which part of the way to the middle of the muzzle that may fill.</summary>
    private const float Widest = 1.45f;
    private const float InHalf = 0.95f;

    private static readonly Vector3 dark = new(0.012f, 0.008f, 0.008f);

    /// <summary>Appends the left nostril.</summary>
    /// <param name="builder">Where the nostril goes.</param>
    /// <param name="at">Its place on the skin.</param>
    /// <param name="along">Direction of its longer axis; not along the normal.</param>
    /// <param name="radius">Half its width across that axis, metres.</param>
    /// <param name="length">Half its length along that axis, in half widths.</param>
    /// <param name="skin">Linear RGB of the skin around it.</param>
    public static void Append(PieceBuilder builder, SurfacePoint at, Vector3 along, float radius, float length, Vector3 skin)
    {
        ReadOnlySpan<Vector2> circle = UnitCircle.Directions(Sides);
        Vector3 major = Vec.Normalize(Vec.Reject(along, at.Normal), Vector3.UnitY);
        Vector3 minor = Vec.Cross(at.Normal, major);

        // Its image is beside it on a narrow muzzle: neither reaches past the middle.
        float breadth = Widest * radius * (float)Math.Sqrt((length * length * major.X * major.X) + (minor.X * minor.X));
        radius *= Math.Min(1f, InHalf * at.Position.X / breadth);

        // Root below the skin, crest of the rim, edge of the bowl (doubled: the colours part there), floor of the bowl.
        ReadOnlySpan<float> widths = stackalloc float[] { Widest, 1.05f, 0.86f, 0.86f };
        ReadOnlySpan<float> lifts = stackalloc float[] { -0.30f, 0.17f, 0.16f, 0.16f };
        ReadOnlySpan<float> tilts = stackalloc float[] { 0.8f, 0.1f, -0.7f, -0.9f };
        ReadOnlySpan<float> lengths = stackalloc float[] { 0.9f, 0.98f, 1f, 1f };
        int first = builder.VertexCount;
        for (int i = 0; i < widths.Length; i++)
        {
            for (int k = 0; k < Sides; k++)
            {
                Vector3 across = (major * circle[k].X) + (minor * circle[k].Y);
                Vector3 point = at.Position + (((major * (circle[k].X * length * lengths[i])) + (minor * circle[k].Y)) * (radius * widths[i])) + (at.Normal * (radius * lifts[i]));
                Vector3 normal = Vec.Normalize((across * tilts[i]) + at.Normal);
                builder.Vertex(point, normal, i < 2 ? skin * (i == 0 ? 1f : 0.86f) : i == 2 ? skin * 0.4f : dark);
            }
        }

        int floor = builder.Vertex(at.Position + (at.Normal * (0.06f * radius)), at.Normal, dark * 0.5f);
        builder.FillBelow(first, Sides);
        builder.Band(first, first + Sides, Sides);
        builder.Band(first + Sides, first + (2 * Sides), Sides);
        builder.Fan(first + (3 * Sides), floor, Sides);
    }
}
