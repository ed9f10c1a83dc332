using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;

namespace CreatureGen.Rigging;

/// <summary>
/// The line that the spine is laid along: from the tip of the head through the centres of the rings to the tip of the tail, in the sagittal plane.
/// Places on it are given as rings (fractional) or as arc length from ring 0, metres.
/// </summary>
internal sealed class SpineLine
{
    private readonly BodyShape shape;

    public SpineLine(BodyShape shape, Vector3 headTip, Vector3 tailTip)
    {
        this.shape = shape;
        HeadTip = new Vector3(0f, headTip.Y, headTip.Z);
        TailTip = new Vector3(0f, tailTip.Y, tailTip.Z);
    }

    /// <summary>Front end.</summary>
    public Vector3 HeadTip { get; }

    /// <summary>Rear end.</summary>
    public Vector3 TailTip { get; }

    /// <summary>Arc length from ring 0 to the last ring.</summary>
    public double Length => shape.Arc[BodyGrid.Rings - 1];

    /// <summary>The point at a ring.</summary>
    public Vector3 At(double ring) => new(0f, (float)BodyShape.At(shape.Y, ring), (float)BodyShape.At(shape.Z, ring));

    /// <summary>Arc length at a ring.</summary>
    public double ArcAt(double ring) => BodyShape.At(shape.Arc, ring);

    /// <summary>The ring at an arc length, between 0 and the last.</summary>
    public double RingAt(double arc)
    {
        int i = 1;
        while (i < BodyGrid.Rings - 1 && shape.Arc[i] < arc)
        {
            i++;
        }

        double step = shape.Arc[i] - shape.Arc[i - 1];
        double fraction = step > 0 ? (arc - shape.Arc[i - 1]) / step : 0;
        return i - 1 + Math.Min(Math.Max(fraction, 0), 1);
    }
}
