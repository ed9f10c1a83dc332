using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>A collar that stands off the back of the head: the bony shield of a horned dinosaur or the fan of a frilled lizard. A thin closed shell with a scalloped rim.</summary>
internal static class FrillShape
{
    private const int ColumnsPerPoint = 6;

    /// <summary>Points across the shell from the skin to the rim, on either side.</summary>
    private const int Rows = 3;

    private const int Sides = (2 * Rows) + 2;

    /// <summary>Share of the length below the skin.</summary>
    private const float Cover = 0.10f;

    /// <summary>Appends the frill, left and right.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="frill">Where it grows and how.</param>
    /// <param name="skin">The body.</param>
    /// <param name="front">Linear RGB of the side that faces forward.</param>
    /// <param name="back">Linear RGB of the side that lies towards the neck.</param>
    /// <param name="rim">Linear RGB of the rim.</param>
    public static void Append(PieceBuilder builder, FrillBlueprint frill, BodySkin skin, Vector3 front, Vector3 back, Vector3 rim)
    {
        int half = ColumnsPerPoint * frill.Points;
        Span<Vector3> column = stackalloc Vector3[Sides];
        Span<Vector3> colours = stackalloc Vector3[Sides];
        int first = builder.VertexCount;
        for (int c = -half; c <= half; c++)
        {
            Column(frill, skin, Math.Abs(c), half, column);
            Shades(frill, Math.Abs(c), half, front, back, rim, colours);
            for (int k = 0; k < Sides; k++)
            {
                Vector3 p = c == 0 ? new Vector3(0f, column[k].Y, column[k].Z) : c > 0 ? column[k] : Vec.Mirror(column[k]);
                builder.Vertex(p, Vector3.UnitY, colours[k]);
            }
        }

        Column(frill, skin, half, half, column);
        Vector3 end = Middle(column) + (Vec.Normalize(skin.At(frill.Ring, frill.Spread + 0.5).Position - skin.At(frill.Ring, frill.Spread).Position, Vector3.UnitX) * (0.08f * (float)frill.Length));
        LoopLoft.Close(builder, first, Sides, Vec.Mirror(end), back, end, back);
    }

    /// <summary>The outline of the shell where it is cut across: from the skin to the rim on the side of the neck and down again on the front.</summary>
    private static void Column(FrillBlueprint frill, BodySkin skin, int c, int half, Span<Vector3> points)
    {
        int ring = (int)frill.Ring;
        double u = (double)c / half;
        SurfacePoint root = skin.At(frill.Ring, frill.Spread * u);
        Vector3 backward = Vector3.Zero - skin.Shape.Forward(ring);
        Vector3 radial = Vec.Normalize(Vec.Reject(root.Normal, backward), root.Normal);
        float cos = (float)PortableMath.Cos(frill.Tilt);
        float sin = (float)PortableMath.Sin(frill.Tilt);
        Vector3 direction = (radial * cos) + (backward * sin);
        Vector3 across = (backward * cos) - (radial * sin);

        // Each scallop is a rounded lobe between two notches.
        double lobe = Math.Abs(PortableMath.Sin(PortableMath.Pi * ((u * frill.Points) + 0.5)));
        float length = (float)(frill.Length * FrillOutline.HeightAt(u) * (1 - (frill.Scallop * (1 - PortableMath.Pow(lobe, 0.7)))));
        float thickness = (float)frill.Thickness;
        for (int k = 0; k <= Rows; k++)
        {
            float v = ((1f + Cover) * k / Rows) - Cover;
            float t = 0.5f * thickness * (k == Rows ? 0.55f : 1f - (0.35f * Math.Max(v, 0f)));
            Vector3 centre = root.Position + (direction * (length * v)) + (across * (float)(frill.Bend * length * v * Math.Abs(v)));
            points[k] = centre + (across * t);
            points[Sides - 1 - k] = centre - (across * t);
        }
    }

    private static void Shades(FrillBlueprint frill, int c, int half, Vector3 front, Vector3 back, Vector3 rim, Span<Vector3> colours)
    {
        // Ribs run from the skin to the lobes; between them the shell is darker.
        double lobe = Math.Abs(PortableMath.Sin(PortableMath.Pi * (((double)c / half * frill.Points) + 0.5)));
        float rib = Scalar.Lerp(1.06f - (0.36f * Math.Min(1f, (float)frill.Scallop / 0.16f)), 1.06f, (float)lobe);
        for (int k = 0; k <= Rows; k++)
        {
            float v = (float)k / Rows;
            float root = Scalar.Lerp(0.55f, 1f, Scalar.Smooth(v * 1.8f));
            colours[k] = k == Rows ? rim : back * (rib * root);
            colours[Sides - 1 - k] = k == Rows ? rim : Vec.Lerp(back, front, Scalar.Smooth(v * 1.6f)) * (rib * root);
        }
    }

    private static Vector3 Middle(ReadOnlySpan<Vector3> points)
    {
        Vector3 sum = Vector3.Zero;
        foreach (Vector3 p in points)
        {
            sum += p;
        }

        return sum / points.Length;
    }
}
