using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>A tongue on the floor of the mouth: a low dome with a furrow along its middle, or a narrow one that parts into two points.</summary>
/// <remarks>
/// It is laid out along the lower lip and stays within its curve at a share of the lip's width, so that no jaw, however hooked or flat, lets it out. Its underside is sunk into the
/// floor; where jaws are shut its back lies within the palate.
/// </remarks>
internal static class TongueShape
{
    private const int Sides = 8;

    // Across a section: share of the half width, and height in thicknesses. The fourth point is the furrow; behind the first point come those of the left side.
    private static readonly Vector2[] profile =
    {
        new(-1f, 0f), new(-0.62f, -0.8f), new(0f, -1f), new(0.62f, -0.8f), new(1f, 0f), new(0.55f, 0.92f), new(0f, 0.55f), new(-0.55f, 0.92f),
    };

    // Where the sections lie from root to tip, and how wide they are there.
    private static readonly Vector2[] outline =
    {
        new(0f, 0.80f), new(0.25f, 0.95f), new(0.50f, 1f), new(0.72f, 0.97f), new(0.88f, 0.80f), new(0.97f, 0.48f),
    };

    private static readonly Vector2[] tine =
    {
        new(0f, 1f), new(0.3f, 1f), new(0.55f, 0.95f), new(0.72f, 0.85f), new(0.88f, 0.55f),
    };

    /// <summary>Appends a rounded tongue.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="floor">The lower lip as the tongue sees it.</param>
    /// <param name="breadth">Half width of the tongue in half widths of the mouth.</param>
    /// <param name="colour">Linear RGB at the tip; the root lies in the shadow of the mouth.</param>
    public static void AppendRounded(PieceBuilder builder, in MouthFloor floor, float breadth, Vector3 colour)
    {
        int first = builder.VertexCount;
        foreach (Vector2 station in outline)
        {
            Vector3 centre = floor.At(station.X, out float half);
            float width = breadth * half * station.Y;
            float thickness = floor.Thickness * Scalar.Lerp(1f, 0.45f, station.X * station.X);
            foreach (Vector2 p in profile)
            {
                Vector3 shade = colour * Scalar.Lerp(0.55f, 1f, Scalar.Smooth(1.4f * station.X)) * (p.Y < 0f ? 0.7f : p.X == 0f ? 0.74f : 1f);
                builder.Vertex(centre + new Vector3(p.X * width, 0f, 0f) + (floor.Up * (p.Y * thickness)), floor.Up, shade);
            }
        }

        Vector3 root = floor.At(-0.06f, out _);
        Vector3 tip = floor.At(1f, out _);
        LoopLoft.Close(builder, first, Sides, root, colour * 0.35f, tip, colour);
    }

    /// <summary>Appends a forked tongue: two narrow strips that lie side by side and part towards their points.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="floor">The lower lip as the tongue sees it.</param>
    /// <param name="breadth">Half width of the tongue in half widths of the mouth.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void AppendForked(PieceBuilder builder, in MouthFloor floor, float breadth, Vector3 colour)
    {
        int vertex = builder.VertexCount;
        int index = builder.IndexCount;
        Span<TubeRow> rows = stackalloc TubeRow[tine.Length];
        floor.At(0.3f, out float middle);
        float width = breadth * middle;
        for (int i = 0; i < rows.Length; i++)
        {
            float parted = Scalar.Smooth((tine[i].X - 0.5f) / 0.5f);
            Vector3 centre = floor.At(tine[i].X, out _) + (floor.Up * (0.35f * floor.Thickness));
            float r = 0.55f * width * tine[i].Y;
            rows[i] = new TubeRow(centre + (Vector3.UnitX * (width * (0.5f + (0.8f * parted)))), r, 0.6f * floor.Thickness * tine[i].Y, colour);
        }

        Vector3 tip = floor.At(1f, out _) + (Vector3.UnitX * (1.45f * width)) + (floor.Up * (0.35f * floor.Thickness));
        SweptTube.Append(builder, rows, tip, colour, Vector3.UnitX, 6);
        builder.AppendMirrored(vertex, index);
    }
}
