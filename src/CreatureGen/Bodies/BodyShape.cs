using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>
/// The sections of a body along its spine, all in the plane x = 0: one entry per ring in every array. Metres at scale 1, radians; +Z front, +Y up.
/// </summary>
internal sealed class BodyShape
{
    private readonly float[] sine = new float[BodyGrid.Rings];
    private readonly float[] cosine = new float[BodyGrid.Rings];

    /// <summary>Takes the pitch of the spine at each ring, radians.</summary>
    public BodyShape(double[] pitch)
    {
        Pitch = pitch;
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            sine[i] = (float)PortableMath.Sin(pitch[i]);
            cosine[i] = (float)PortableMath.Cos(pitch[i]);
        }
    }

    /// <summary>Height of the spine.</summary>
    public double[] Y { get; } = new double[BodyGrid.Rings];

    /// <summary>Place of the spine along the body; the nose has the greatest.</summary>
    public double[] Z { get; } = new double[BodyGrid.Rings];

    /// <summary>Pitch of the spine, radians; its forward direction is (0, sin, cos).</summary>
    public double[] Pitch { get; }

    /// <summary>Half width of the section.</summary>
    public double[] Width { get; } = new double[BodyGrid.Rings];

    /// <summary>Height of the section above the spine.</summary>
    public double[] Top { get; } = new double[BodyGrid.Rings];

    /// <summary>Depth of the section below the spine.</summary>
    public double[] Bottom { get; } = new double[BodyGrid.Rings];

    /// <summary>Superellipse exponent above the spine.</summary>
    public double[] TopExponent { get; } = new double[BodyGrid.Rings];

    /// <summary>Superellipse exponent below the spine.</summary>
    public double[] BottomExponent { get; } = new double[BodyGrid.Rings];

    /// <summary>Length of the spine from the ring before; 0 at ring 0.</summary>
    public double[] Step { get; } = new double[BodyGrid.Rings];

    /// <summary>Length of the spine from the nose.</summary>
    public double[] Arc { get; } = new double[BodyGrid.Rings];

    /// <summary>The shape moved along z.</summary>
    public BodyShape Placed(double shift)
    {
        var placed = new BodyShape(Pitch);
        Y.CopyTo(placed.Y, 0);
        Width.CopyTo(placed.Width, 0);
        Top.CopyTo(placed.Top, 0);
        Bottom.CopyTo(placed.Bottom, 0);
        TopExponent.CopyTo(placed.TopExponent, 0);
        BottomExponent.CopyTo(placed.BottomExponent, 0);
        Step.CopyTo(placed.Step, 0);
        Arc.CopyTo(placed.Arc, 0);
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            placed.Z[i] = Z[i] + shift;
        }

        return placed;
    }

    /// <summary>Unit forward direction of the spine at a ring.</summary>
    public Vector3 Forward(int ring) => new(0f, sine[ring], cosine[ring]);

    /// <summary>Unit dorsal direction of the spine at a ring.</summary>
    public Vector3 Up(int ring) => new(0f, cosine[ring], -sine[ring]);

    /// <summary>The spine's point at a ring.</summary>
    public Vector3 Centre(int ring) => new(0f, (float)Y[ring], (float)Z[ring]);

    /// <summary>The ring, with its fraction, at a length of the spine from the nose.</summary>
    public double RingAt(double arc)
    {
        int i = 0;
        while (i < Arc.Length - 2 && Arc[i + 1] < arc)
        {
            i++;
        }

        return i + ((arc - Arc[i]) / Math.Max(Arc[i + 1] - Arc[i], 1e-9));
    }

    /// <summary>The value of one of the arrays at a fractional ring.</summary>
    public static double At(double[] values, double ring)
    {
        if (ring <= 0)
        {
            return values[0];
        }

        int i = (int)ring;
        return i >= values.Length - 1 ? values[values.Length - 1] : values[i] + ((values[i + 1] - values[i]) * (ring - i));
    }
}
