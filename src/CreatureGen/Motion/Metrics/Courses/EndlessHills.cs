using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Metrics.Courses;

/// <summary>Smooth seeded hills without end: three waves of 1.9, 2.4 and 3 leg lengths in different directions, each 0.048 leg lengths high; solid below.</summary>
internal sealed class EndlessHills : IGround
{
    private const float HeightFraction = 0.048f;

    /// <summary>Leg lengths from probe to probe along rays that do not fall straight.</summary>
    private const float Stride = 0.1f;
    private const int Halvings = 24;

    // Wave numbers across and along, per leg length.
    private static readonly Vector2[] waves = { new(2.1f, 0f), new(0f, 3.3f), new(1.3f, 2.2f) };

    private readonly double legLength;
    private readonly double[] phases = new double[3];

    public EndlessHills(Seed seed, float legLength)
    {
        this.legLength = legLength;
        RandomStream random = seed.Child("hills").Stream();
        for (int i = 0; i < phases.Length; i++)
        {
            phases[i] = random.Uniform(0, PortableMath.Tau);
        }
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = Surface(origin);
        float fall = origin.Y - hit.Point.Y;
        if (fall <= 0f || (direction.X == 0f && direction.Z == 0f))
        {
            // A ray that begins in the ground is at once at its surface.
            return fall <= 0f || (direction.Y < 0f && fall <= distance);
        }

        float stride = Stride * (float)legLength;
        for (float before = 0f; before < distance; before += stride)
        {
            float after = Math.Min(before + stride, distance);
            if (IsInside(origin + (direction * after)))
            {
                hit = Surface(origin + (direction * Crossing(origin, direction, before, after)));
                return true;
            }
        }

        return false;
    }

    private float Crossing(Vector3 origin, Vector3 direction, float above, float below)
    {
        for (int i = 0; i < Halvings; i++)
        {
            float middle = 0.5f * (above + below);
            if (IsInside(origin + (direction * middle)))
            {
                below = middle;
            }
            else
            {
                above = middle;
            }
        }

        return below;
    }

    private bool IsInside(Vector3 point) => point.Y <= Surface(point).Point.Y;

    /// <summary>The surface above or below a point.</summary>
    private GroundHit Surface(Vector3 point)
    {
        double height = 0;
        double alongX = 0;
        double alongZ = 0;
        for (int i = 0; i < waves.Length; i++)
        {
            PortableMath.SinCos((((waves[i].X * (double)point.X) + (waves[i].Y * (double)point.Z)) / legLength) + phases[i], out double sine, out double cosine);
            height += HeightFraction * legLength * sine;
            alongX += HeightFraction * waves[i].X * cosine;
            alongZ += HeightFraction * waves[i].Y * cosine;
        }

        return new GroundHit(point with { Y = (float)height }, Vec.Normalize(new Vector3((float)-alongX, 1f, (float)-alongZ)));
    }
}
