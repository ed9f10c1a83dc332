using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Bodies;
using CreatureGen.Maths;

namespace CreatureGen.Limbs;

/// <summary>Pushes points of a left limb out of the body's sections near its socket, sideways.</summary>
internal sealed class BodyKeepOut
{
    /// <summary>Metres between the skin and a point that was pushed.</summary>
    private const double Gap = 0.007;

    private readonly BodyShape shape;
    private readonly int first;
    private readonly int last;

    /// <summary>Guards the given rings, both included.</summary>
    public BodyKeepOut(BodyShape shape, int first, int last)
    {
        this.shape = shape;
        this.first = Math.Max(first, 1);
        this.last = Math.Min(last, BodyGrid.Rings - 2);
    }

    /// <summary>The point itself, or its image on the skin at the same height and length.</summary>
    public Vector3 Push(Vector3 p)
    {
        if (p.X <= 0f)
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
            double score = a + (0.25 * Math.Sqrt((d.Y * d.Y) + (d.Z * d.Z)));
            if (score < best)
            {
                best = score;
                ring = i;
                axial = a;
            }
        }

        if (axial >= shape.Step[ring] * 1.2)
        {
            return p;
        }

        double y = Vec.Dot(p - shape.Centre(ring), shape.Up(ring));
        double extent = y > 0 ? shape.Top[ring] : shape.Bottom[ring];
        double exponent = y > 0 ? shape.TopExponent[ring] : shape.BottomExponent[ring];
        double q = Math.Abs(y) / extent;
        if (q >= 1)
        {
            return p;
        }

        double skin = (shape.Width[ring] * PortableMath.Pow(1 - PortableMath.Pow(q, exponent), 1 / exponent)) + Gap;
        if (p.X < skin)
        {
            p.X = (float)skin;
        }

        return p;
    }
}
