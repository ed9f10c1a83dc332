using System;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>The leather of a nose as a piece: a low cushion on the front of a muzzle with an edge all around it and a groove down its middle.</summary>
internal static class NosePadShape
{
    /// <summary>Points around it; an even number.</summary>
    private const int Sides = 16;

    // Loops from the edge to the middle: size, and how far they stand off the skin in half widths of the pad.
    private static readonly Vector2[] loops = { new(1f, -0.25f), new(0.98f, 0.09f), new(0.84f, 0.17f), new(0.48f, 0.19f) };

    /// <summary>How far the middle stands off, in half widths.</summary>
    private const float Crown = 0.19f;

    // How far a nostril and the cushion beside it stand off, and how far from it that is, in half widths.
    private const float NostrilLift = 0.175f;
    private const float EdgeLift = 0.12f;
    private const float Aside = 0.25f;

    /// <summary>Where its upper end is, in half heights.</summary>
    private const float Top = 0.84f;

    // Depth and half breadth of the groove, in half widths.
    private const float Groove = 0.1f;
    private const float GrooveBreadth = 0.16f;

    // What is left of its breadth at its upper and lower ends.
    private const float AtTop = 0.9f;
    private const float AtChin = 0.6f;

    /// <summary>Appends the pad.</summary>
    /// <param name="builder">Where it goes.</param>
    /// <param name="bed">What it lies on.</param>
    /// <param name="colour">Linear RGB.</param>
    public static void Append(PieceBuilder builder, in NoseBed bed, Vector3 colour)
    {
        int first = builder.VertexCount;
        Span<Vector3> half = stackalloc Vector3[(Sides / 2) + 1];
        foreach (Vector2 loop in loops)
        {
            for (int k = 0; k < half.Length; k++)
            {
                PortableMath.SinCos(PortableMath.Tau * k / Sides, out double sine, out double cosine);
                float x = k == 0 || 2 * k == Sides ? 0f : (float)sine * loop.X;
                half[k] = On(bed, x, (float)cosine * loop.X, loop.Y);
            }

            Vector3 shade = colour * (loop.Y < 0f ? 0.7f : 1f);
            for (int k = 0; k < Sides; k++)
            {
                // Counter-clockwise as seen from ahead, where the left is on the right.
                Vector3 p = half[k > Sides / 2 ? Sides - k : k];
                builder.Vertex(k > Sides / 2 ? p : new Vector3(-p.X, p.Y, p.Z), bed.Pad.Forward, shade);
            }
        }

        LoopLoft.Close(builder, first, Sides, On(bed, 0f, 0f, loops[0].Y - 0.2f), colour * 0.7f, On(bed, 0f, 0f, Crown), colour, 0);
    }

    /// <summary>The place of the left nostril on it.</summary>
    public static SurfacePoint Nostril(in NoseBed bed)
    {
        Vector3 aside = On(bed, NosePad.NostrilAside + Aside, NosePad.NostrilAbove, EdgeLift) - On(bed, NosePad.NostrilAside - Aside, NosePad.NostrilAbove, NostrilLift);
        Vector3 above = On(bed, NosePad.NostrilAside, NosePad.NostrilAbove + Aside, NostrilLift) - On(bed, NosePad.NostrilAside, NosePad.NostrilAbove - Aside, NostrilLift);
        return new SurfacePoint(On(bed, NosePad.NostrilAside, NosePad.NostrilAbove, NostrilLift), Vec.Normalize(Vec.Cross(aside, above), bed.Pad.Forward));
    }

    /// <summary>A place over the bed, in half widths and half heights of the pad from its middle.</summary>
    private static Vector3 On(in NoseBed bed, float x, float y, float lift)
    {
        NosePad pad = bed.Pad;
        y *= y > 0f ? Top : 1f;
        float breadth = y > 0f ? Scalar.Lerp(1f, AtTop, y * y) : Scalar.Lerp(1f, AtChin, -y);
        float groove = y < 0.4f ? Groove * (float)PortableMath.Exp(-(x * x) / (GrooveBreadth * GrooveBreadth)) * Scalar.Smooth((0.4f - y) / 0.6f) : 0f;
        float ahead = bed.At(x * breadth, y) + ((lift - groove) * pad.HalfWidth);
        return pad.Centre + (pad.Up * (y * pad.HalfHeight)) + (Vector3.UnitX * (x * breadth * pad.HalfWidth)) + (pad.Forward * ahead);
    }
}
