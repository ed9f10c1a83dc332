using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>One section of a <see cref="SweptTube"/>.</summary>
internal readonly struct TubeRow
{
    public TubeRow(Vector3 centre, float major, float minor, Vector3 colour)
    {
        Centre = centre;
        Major = major;
        Minor = minor;
        Colour = colour;
    }

    /// <summary>Model space, metres.</summary>
    public Vector3 Centre { get; }

    /// <summary>Radius along the first axis of the section, metres.</summary>
    public float Major { get; }

    /// <summary>Radius along the second axis, metres.</summary>
    public float Minor { get; }

    /// <summary>Linear RGB.</summary>
    public Vector3 Colour { get; }
}

/// <summary>A closed shell of elliptic sections along a curve that ends in a point.</summary>
internal static class SweptTube
{
    /// <summary>
    /// Appends the shell: one ring per row (at least 2), filled at the first, closed at <paramref name="tip"/> after the last.
    /// </summary>
    /// <param name="builder">Where the shell goes.</param>
    /// <param name="rows">Sections from root to tip; consecutive centres differ.</param>
    /// <param name="tip">The point beyond the last section.</param>
    /// <param name="tipColour">Linear RGB at the tip.</param>
    /// <param name="majorHint">Direction of the first axis of the sections, as far as the curve allows it; not parallel to the start of the curve.</param>
    /// <param name="sides">Vertices per ring.</param>
    public static void Append(PieceBuilder builder, ReadOnlySpan<TubeRow> rows, Vector3 tip, Vector3 tipColour, Vector3 majorHint, int sides)
    {
        ReadOnlySpan<Vector2> circle = UnitCircle.Directions(sides);
        int first = builder.VertexCount;
        Vector3 major = majorHint;
        for (int i = 0; i < rows.Length; i++)
        {
            Vector3 ahead = i + 1 < rows.Length ? rows[i + 1].Centre : tip;
            Vector3 behind = rows[i > 0 ? i - 1 : 0].Centre;
            Vector3 tangent = Vec.Normalize(ahead - behind, Vector3.UnitY);

            // Carried along the curve by projection, so the sections do not twist about it.
            major = Vec.Normalize(Vec.Reject(major, tangent), major);
            Vector3 minor = Vec.Cross(tangent, major);
            TubeRow row = rows[i];
            for (int k = 0; k < sides; k++)
            {
                builder.Vertex(row.Centre + (major * (row.Major * circle[k].X)) + (minor * (row.Minor * circle[k].Y)), tangent, row.Colour);
            }
        }

        Vector3 tipDirection = Vec.Normalize(tip - rows[rows.Length - 1].Centre, Vector3.UnitY);
        int pole = builder.Vertex(tip, tipDirection, tipColour);
        builder.FillBelow(first, sides);
        for (int i = 0; i + 1 < rows.Length; i++)
        {
            builder.Band(first + (i * sides), first + ((i + 1) * sides), sides);
        }

        builder.Fan(first + ((rows.Length - 1) * sides), pole, sides);
        SetNormals(builder, first, rows.Length, sides, tip);
    }

    // Central differences along and around: exact mirror images get exactly mirrored normals, whatever the diagonals of the quads.
    private static void SetNormals(PieceBuilder builder, int first, int rowCount, int sides, Vector3 tip)
    {
        for (int i = 0; i < rowCount; i++)
        {
            int ring = first + (i * sides);
            for (int k = 0; k < sides; k++)
            {
                Vector3 around = builder.Position(ring + ((k + 1) % sides)) - builder.Position(ring + ((k + sides - 1) % sides));
                Vector3 ahead = i + 1 < rowCount ? builder.Position(ring + sides + k) : tip;
                Vector3 behind = builder.Position(i > 0 ? ring - sides + k : ring + k);
                Vector3 normal = Vec.Cross(around, ahead - behind);
                builder.SetNormal(ring + k, Vec.Normalize(normal / Vec.Length(around), Vector3.UnitY));
            }
        }
    }
}
