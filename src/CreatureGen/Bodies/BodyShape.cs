using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>
/// The sections of a body along its spine, all in the plane x = 0: one entry per ring in every array. Metres at scale 1, radians; +Z front, +Y up.
/// </summary>
internal sealed class BodyShape
{
    private readonly float[] sine;
    private readonly float[] cosine;

    /// <summary>A straight and level spine without length or thickness.</summary>
    public BodyShape()
    {
        sine = new float[BodyGrid.Rings];
        cosine = new float[BodyGrid.Rings];
        Array.Fill(cosine, 1f);
        Cosine = new double[BodyGrid.Rings];
        Array.Fill(Cosine, 1);
        Pitch = new double[BodyGrid.Rings];
        Rise = new double[BodyGrid.Rings];
        Width = new double[BodyGrid.Rings];
        Top = new double[BodyGrid.Rings];
        Bottom = new double[BodyGrid.Rings];
        TopExponent = new double[BodyGrid.Rings];
        BottomExponent = new double[BodyGrid.Rings];
        Step = new double[BodyGrid.Rings];
        Arc = new double[BodyGrid.Rings];
    }

    /// <summary>The same sections, which are shared, along another spine.</summary>
    private BodyShape(BodyShape same, float[] sine, float[] cosine, double[] exactCosine, double[] pitch, double[] rise)
    {
        this.sine = sine;
        this.cosine = cosine;
        Cosine = exactCosine;
        Pitch = pitch;
        Rise = rise;
        Width = same.Width;
        Top = same.Top;
        Bottom = same.Bottom;
        TopExponent = same.TopExponent;
        BottomExponent = same.BottomExponent;
        Step = same.Step;
        Arc = same.Arc;
    }

    /// <summary>Height of the spine.</summary>
    public double[] Y { get; } = new double[BodyGrid.Rings];

    /// <summary>Place of the spine along the body; the nose has the greatest.</summary>
    public double[] Z { get; } = new double[BodyGrid.Rings];

    /// <summary>Height of the spine above that of the nose, as it is bent and before it is raised or laid on the ground.</summary>
    public double[] Rise { get; }

    /// <summary>Pitch of the spine, radians; its forward direction is (0, sin, cos).</summary>
    public double[] Pitch { get; }

    /// <summary>Cosine of the pitch: the lowest points of a body are asked for again and again while it is settled.</summary>
    public double[] Cosine { get; }

    /// <summary>Half width of the section.</summary>
    public double[] Width { get; }

    /// <summary>Height of the section above the spine.</summary>
    public double[] Top { get; }

    /// <summary>Depth of the section below the spine.</summary>
    public double[] Bottom { get; }

    /// <summary>Superellipse exponent above the spine.</summary>
    public double[] TopExponent { get; }

    /// <summary>Superellipse exponent below the spine.</summary>
    public double[] BottomExponent { get; }

    /// <summary>Length of the spine from the ring before; 0 at ring 0.</summary>
    public double[] Step { get; }

    /// <summary>Length of the spine from the nose.</summary>
    public double[] Arc { get; }

    /// <summary>The shape with other heights of its spine, which are still to be set.</summary>
    public BodyShape WithOtherHeights()
    {
        var other = new BodyShape(this, sine, cosine, Cosine, Pitch, Rise);
        Z.CopyTo(other.Z, 0);
        return other;
    }

    /// <summary>The shape along another spine, which is still to be bent.</summary>
    public BodyShape WithOtherBends() => new(this, new float[BodyGrid.Rings], new float[BodyGrid.Rings], new double[BodyGrid.Rings], new double[BodyGrid.Rings], new double[BodyGrid.Rings]);

    /// <summary>Turns the sections across the spine, once its <see cref="Pitch"/> is set.</summary>
    public void TurnSections()
    {
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            PortableMath.SinCos(Pitch[i], out double s, out Cosine[i]);
            sine[i] = (float)s;
            cosine[i] = (float)Cosine[i];
        }
    }

    /// <summary>Unit forward direction of the spine at a ring.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector3 Forward(int ring) => new(0f, sine[ring], cosine[ring]);

    /// <summary>Unit dorsal direction of the spine at a ring.</summary>
    public Vector3 Up(int ring) => new(0f, cosine[ring], -sine[ring]);

    /// <summary>The spine's point at a ring.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
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
