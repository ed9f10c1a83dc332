using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>Pushes points of a left limb out of the body's sections near its socket, sideways.</summary>
internal sealed class BodyKeepOut
{
    /// <summary>Metres between the skin and a point that was pushed.</summary>
    private const double Gap = 0.007;

    /// <summary>Steps between rings that a section reaches along the spine.</summary>
    private const double NearestSteps = 1.2;

    /// <summary>Keeps quick answers clear of rounding.</summary>
    private const double Slack = 1.001;

    private readonly BodyShape shape;
    private readonly ShellBlueprint shell;
    private readonly int first;
    private readonly int last;

    // What no section reaches beyond: a plane to the side, and a circle about a point of the sagittal plane.
    private readonly double widest;
    private readonly Vector3 middle;
    private readonly double reach;

    /// <summary>Guards the given rings, both included.</summary>
    public BodyKeepOut(BodySkin skin, int first, int last)
    {
        shape = skin.Shape;
        shell = skin.Shell;
        this.first = Math.Max(first, 1);
        this.last = Math.Min(last, BodyGrid.Rings - 2);
        middle = (shape.Centre(this.first) + shape.Centre(this.last)) / 2f;
        for (int i = this.first; i <= this.last; i++)
        {
            double swell = ShellRelief.Greatest(shell, i);
            double extent = swell * Math.Max(shape.Top[i], shape.Bottom[i]);
            double step = NearestSteps * shape.Step[i];
            widest = Math.Max(widest, Slack * ((swell * shape.Width[i]) + Gap));
            reach = Math.Max(reach, Slack * (Vec.Distance(shape.Centre(i), middle) + Math.Sqrt((extent * extent) + (step * step))));
        }
    }

    /// <summary>The point itself, or its image on the skin at the same height and length.</summary>
    public Vector3 Push(Vector3 p)
    {
        Vector3 beside = p - middle;
        if (p.X <= 0f || p.X > widest || ((double)beside.Y * beside.Y) + ((double)beside.Z * beside.Z) > reach * reach)
        {
            return p;
        }

        int ring = first;
        double best = double.MaxValue;
        double axial = 0;
        for (int i = first; i <= last; i++)
        {
            Vector3 d = p - shape.Centre(i);
            double a = Math.Abs(Vec.Dot(d, shape.Forward(i)));
            if (a >= best)
            {
                continue;
            }

            double score = a + (0.25 * Math.Sqrt((d.Y * d.Y) + (d.Z * d.Z)));
            if (score < best)
            {
                best = score;
                ring = i;
                axial = a;
            }
        }

        if (axial >= shape.Step[ring] * NearestSteps)
        {
            return p;
        }

        double y = Vec.Dot(p - shape.Centre(ring), shape.Up(ring));
        double swell = ShellRelief.Greatest(shell, ring);
        double extent = y > 0 ? swell * shape.Top[ring] : shape.Bottom[ring];
        double exponent = y > 0 ? shape.TopExponent[ring] : shape.BottomExponent[ring];
        double q = Math.Abs(y) / extent;
        if (q >= 1)
        {
            return p;
        }

        double skin = (swell * shape.Width[ring] * PortableMath.Pow(1 - PortableMath.Pow(q, exponent), 1 / exponent)) + Gap;
        if (p.X < skin)
        {
            p.X = (float)skin;
        }

        return p;
    }
}
