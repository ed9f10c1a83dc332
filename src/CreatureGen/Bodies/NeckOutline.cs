using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>How a neck leaves the jaw: a deep head on the thin neck of another body ended there like a hood with a cut edge. Throat and cheeks run out into the neck no steeper than a gullet does, on the skin alone.</summary>
internal readonly struct NeckOutline
{
    // The rings between which they do: from the corner of the jaw to the base of the neck, where the last few go over into the trunk.
    private const int First = StationRing.Cranium;
    private const int End = StationRing.NeckBase;
    private const double Fade = 4;

    /// <summary>Rise of the throat, and narrowing of a cheek, over the way back at most.</summary>
    private const float Steepest = 0.9f;

    /// <summary>Most that a ring becomes deeper or broader by, of what it is.</summary>
    private const double Most = 0.7;

    private readonly double[] depths;
    private readonly double[] breadths;

    /// <summary>The outline of a neck.</summary>
    /// <param name="shape">The body's sections.</param>
    public NeckOutline(BodyShape shape)
    {
        depths = new double[End];
        breadths = new double[End];
        Vector3 throat = Throat(shape, First, 1);
        double breadth = shape.Width[First];
        depths[First] = breadths[First] = 1;
        for (int i = First + 1; i < End; i++)
        {
            double part = Scalar.Smooth((End - i) / Fade);
            Vector3 step = Throat(shape, i, 1) - throat;
            double rise = Vec.Dot(step, shape.Up(i)) - (Steepest * Back(shape, i, step));
            depths[i] = 1 + (Scalar.Clamp(rise / shape.Bottom[i], 0, Most) * part);
            throat = Throat(shape, i, depths[i]);

            double narrowing = breadth - shape.Width[i] - (Steepest * Back(shape, i, shape.Centre(i) - shape.Centre(i - 1)));
            breadths[i] = 1 + (Scalar.Clamp(narrowing / shape.Width[i], 0, Most) * part);
            breadth = breadths[i] * shape.Width[i];
        }
    }

    /// <summary>Factor on how deep a ring is below its spine.</summary>
    public float DepthAt(int ring) => ring > First && ring < End ? (float)depths[ring] : 1f;

    /// <summary>Factor on its breadth.</summary>
    public float BreadthAt(int ring) => ring > First && ring < End ? (float)breadths[ring] : 1f;

    private static Vector3 Throat(BodyShape shape, int ring, double depth) => shape.Centre(ring) - Vec.Scale(shape.Up(ring), (float)(depth * shape.Bottom[ring]));

    private static float Back(BodyShape shape, int ring, Vector3 step) => Math.Max(0f, -Vec.Dot(step, shape.Forward(ring)));
}
