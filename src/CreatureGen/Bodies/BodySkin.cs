using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Bodies;

/// <summary>The points of the body's skin on the grid of rings and segments, exactly mirrored, and points in between.</summary>
internal sealed class BodySkin
{
    private const int Half = BodyGrid.Segments / 2;

    // How far the edges of a fan of feathers are below its middle, in its half widths, and the part of that by which the middle is raised: by all of it where the edges lie on the ground.
    private const double Arch = 0.34;
    private const double Crest = 0.4;

    private static readonly float[] sine = Around(PortableMath.Sin);
    private static readonly float[] cosine = Around(PortableMath.Cos);

    private readonly Vector3[] grid = new Vector3[BodyGrid.Rings * BodyGrid.Segments];

    private BodySkin(BodyShape shape, ShellBlueprint shell)
    {
        Shape = shape;
        Shell = shell;
    }

    /// <summary>The sections that the skin is spanned over.</summary>
    public BodyShape Shape { get; }

    /// <summary>The hard cover over its back.</summary>
    public ShellBlueprint Shell { get; }

    /// <summary>The point of a ring and a segment.</summary>
    public Vector3 this[int ring, int segment] => grid[(ring * BodyGrid.Segments) + segment];

    /// <summary>Spans the skin of a creature over its sections and shapes head, torso and tail.</summary>
    public static BodySkin Span(BodyShape shape, CreatureBlueprint creature)
    {
        (BodyBlueprint body, HeadBlueprint head, TailBlueprint tail) = (creature.Body, creature.Head, creature.Tail);
        var skin = new BodySkin(shape, body.Shell);
        Span<float> x = stackalloc float[Half + 1];
        Span<float> y = stackalloc float[Half + 1];
        Span<float> powers = stackalloc float[2 * (Half + 1)];
        DiscSection? disc = body.Disc.Sweep != 0 || body.Disc.Curl != 0 ? new DiscSection(shape, body.Disc) : null;
        double topExponent = 0;
        double bottomExponent = 0;
        double crest = creature.Plan == BodyPlan.Legless ? 1 : Crest;
        double tailStep = 0;
        for (int i = StationRing.TailFirst; i < StationRing.TailTip; i++)
        {
            tailStep += shape.Step[i] / 8;
        }

        ValueList<HeadBump> relief = Girdles.Of(creature, shape);
        double[] withers = WithersLine.Of(creature, shape);
        var neck = new NeckOutline(shape);
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            if (shape.TopExponent[i] != topExponent || shape.BottomExponent[i] != bottomExponent)
            {
                topExponent = shape.TopExponent[i];
                bottomExponent = shape.BottomExponent[i];
                Superellipse(topExponent, bottomExponent, powers);
            }

            for (int j = 0; j <= Half; j++)
            {
                x[j] = powers[2 * j] * (float)shape.Width[i];
                y[j] = powers[(2 * j) + 1] * (float)(j < Half / 2 ? shape.Top[i] : shape.Bottom[i]);
                y[j] = disc?.Height(i, x[j], y[j]) ?? y[j];
            }

            if (i < StationRing.TrunkFirst)
            {
                ApplyBumps(head.Bumps, i, x, y);
            }
            else if (i < StationRing.TailFirst)
            {
                ApplyBumps(relief, i, x, y);
            }

            for (int j = 0; j < Half / 2 && withers[i] != 1; j++)
            {
                y[j] *= (float)Scalar.Lerp(1, withers[i], WithersLine.Share(j));
            }

            (float breadth, float depth) = (neck.BreadthAt(i), neck.DepthAt(i));
            for (int j = 0; j <= Half && (breadth != 1f || depth != 1f); j++)
            {
                x[j] *= breadth;
                y[j] *= j < Half / 2 ? 1f : depth;
            }

            ApplyShell(body.Shell, i, x, y);
            bool rayed = i >= StationRing.TailFirst && TailRays.Has(tail.Style);
            Span<float> thickness = tail.Style == TailStyle.Fluke ? y : x;
            double slimness = 2 * shape.Width[i] / (shape.Top[i] + shape.Bottom[i]);
            slimness = tail.Style == TailStyle.Fluke ? slimness : 1 / slimness;
            for (int j = 0; j <= Half && rayed; j++)
            {
                thickness[j] *= (float)TailRays.ThicknessAt(i, PortableMath.Tau * j / BodyGrid.Segments, slimness);
            }

            Vector3 centre = shape.Centre(i);
            Vector3 up = shape.Up(i);
            Vector3 forward = shape.Forward(i);
            for (int j = 0; j <= Half; j++)
            {
                float along = i >= StationRing.TailFirst ? TailShift(shape, tail, tailStep, i, x[j], y[j]) : 0f;
                along += rayed && TailRays.AreSplit(tail.Style) ? (float)TailRays.DrawnInAt(tail.Style, i, PortableMath.Tau * j / BodyGrid.Segments, tail.Size, tailStep) : 0f;
                float lift = i >= StationRing.TailFirst ? Camber(shape, tail, crest, i, x[j]) : 0f;
                if (disc != null)
                {
                    along += disc.Along(x[j]);
                    lift += disc.Lift(i, x[j]);
                }

                Vector3 p = centre + Vec.Scale(up, y[j] + lift) + Vec.Scale(forward, along);
                p.X = j is 0 or Half ? 0f : x[j];
                skin.grid[(i * BodyGrid.Segments) + j] = p;
                skin.grid[(i * BodyGrid.Segments) + BodyGrid.MirrorSegment(j)] = j is 0 or Half ? p : Vec.Mirror(p);
            }
        }

        return skin;
    }

    /// <summary>A point between the grid's points and the skin's outward direction there. The segment may be any number; 0 is dorsal.</summary>
    public SurfacePoint At(double ring, double segment)
    {
        ring = Scalar.Clamp(ring, 0, BodyGrid.Rings - 1);
        Vector3 alongRings = Point(Math.Min(ring + 0.6, BodyGrid.Rings - 1), segment) - Point(Math.Max(ring - 0.6, 0), segment);
        Vector3 aroundRing = Point(ring, segment + 0.5) - Point(ring, segment - 0.5);
        return new SurfacePoint(Point(ring, segment), Vec.Normalize(Vec.Cross(aroundRing, alongRings), Vector3.UnitY));
    }

    private Vector3 Point(double ring, double segment)
    {
        int i = Math.Min((int)ring, BodyGrid.Rings - 2);
        float u = (float)(ring - i);
        double floor = Math.Floor(segment);
        float v = (float)(segment - floor);
        int j = (((int)floor % BodyGrid.Segments) + BodyGrid.Segments) % BodyGrid.Segments;
        int k = (j + 1) % BodyGrid.Segments;
        return Vec.Lerp(Vec.Lerp(this[i, j], this[i, k], v), Vec.Lerp(this[i + 1, j], this[i + 1, k], v), u);
    }

    private static void Superellipse(double topExponent, double bottomExponent, Span<float> powers)
    {
        for (int j = 0; j <= Half; j++)
        {
            double n = j < Half / 2 ? topExponent : bottomExponent;
            powers[2 * j] = (float)PortableMath.Pow(sine[j], 2 / n);
            powers[(2 * j) + 1] = (float)(cosine[j] < 0 ? -PortableMath.Pow(-cosine[j], 2 / n) : PortableMath.Pow(cosine[j], 2 / n));
        }
    }

    private static void ApplyBumps(ValueList<HeadBump> bumps, int ring, Span<float> x, Span<float> y)
    {
        Span<double> factor = stackalloc double[Half + 1];
        factor.Fill(1);
        foreach (HeadBump bump in bumps)
        {
            double u = (ring - bump.Ring) / bump.RingSpread;
            if (u * u > 9)
            {
                continue;
            }

            for (int j = 0; j <= Half; j++)
            {
                double v = (j - bump.Segment) / bump.SegmentSpread;
                double d = (u * u) + (v * v);
                if (d < 9)
                {
                    factor[j] += bump.Amount * PortableMath.Exp(-d);
                }
            }
        }

        for (int j = 0; j <= Half; j++)
        {
            x[j] *= (float)factor[j];
            y[j] *= (float)factor[j];
        }
    }

    private static void ApplyShell(ShellBlueprint shell, int ring, Span<float> x, Span<float> y)
    {
        for (int j = 0; j <= Half && ShellRelief.Covers(shell, ring, j); j++)
        {
            float factor = (float)ShellRelief.Factor(shell, ring, j);
            x[j] *= factor;
            y[j] *= factor;
        }
    }

    /// <summary>Shift of a tail point along the spine, metres: the outline of forks, flukes and feather fans.</summary>
    private static float TailShift(BodyShape shape, TailBlueprint tail, double tailStep, int ring, float x, float y)
    {
        double across = Math.Abs(x) / Math.Max(shape.Width[ring], 0.01);
        switch (tail.Style)
        {
            case TailStyle.Fork:
            case TailStyle.Fan:
            case TailStyle.Lance:
                // Deeper forks than the rings are apart, and rounder ends, would turn the end inside out.
                double deepest = 0.85 * tailStep / 0.0328;
                double fork = Scalar.Clamp(tail.Fork, -deepest, deepest);
                double height = Math.Abs(y) / Math.Max(shape.Top[ring], 1e-3);
                return (float)(-Scalar.Smooth((ring - 46) / 8.0) * fork * 0.16 * PortableMath.Pow(height, 1.6));
            case TailStyle.Fluke:
                // The tips sweep back, no farther than the rings are apart.
                double lobes = Math.Min(0.56 * tail.Fork * tail.Size, 3.4 * tailStep);
                return (float)(Scalar.Smooth((ring - 46) / 7.0) * (0.02 - (lobes * FlukeTail.EdgeAt(across, tail.Lobe))));
            case TailStyle.Feathers:
                double q = Scalar.Smooth((ring - 46) / 8.0);
                double edge = Math.Min(1, across);
                double quill = Math.Min(1, tailStep / 0.055);
                return (float)(quill * ((-q * (0.06 + (0.8 * tail.Size)) * (1 - (edge * edge))) + (q * 0.035 * PortableMath.Cos(across * PortableMath.Pi * 5))));
            default:
                if (TailFin.Of(tail.Style) is TailFin fin)
                {
                    // As with forks: no deeper than the rings are apart.
                    double half = y > 0 ? shape.Top[ring] : shape.Bottom[ring];
                    double reach = Math.Min(tail.Size, 3.6 * tailStep);
                    return (float)(-Scalar.Smooth((ring - 46) / 8.0) * reach * fin.EdgeAt(y / Math.Max(half, 1e-3)));
                }

                return 0f;
        }
    }

    /// <summary>How far a point of a tail's blade is above its plane, metres: flat, a fan or a fluke is a stick from the side and a sawn log from behind.</summary>
    private static float Camber(BodyShape shape, TailBlueprint tail, double crest, int ring, float x)
    {
        double across = Math.Min(1, Math.Abs(x) / Math.Max(shape.Width[ring], 0.01));
        return tail.Style switch
        {
            TailStyle.Feathers => (float)(Arch * tail.Size * Scalar.Smooth((ring - StationRing.TailFirst) / 8.0) * (crest - (across * across))),

            // By its place in the whole lobe: with its tips bent ring by ring a lobe is twisted along its leading edge, where both of its faces then cut through one another.
            TailStyle.Fluke => (float)(-tail.Size * Scalar.Smooth((ring - StationRing.TailFirst) / 7.0) * FlukeTail.FallAt(Math.Min(1, Math.Abs(x) / tail.Size))),
            _ => 0f,
        };
    }

    private static float[] Around(Func<double, double> function)
    {
        float[] values = new float[Half + 1];
        for (int j = 0; j <= Half; j++)
        {
            double value = function(PortableMath.Tau * j / BodyGrid.Segments);
            values[j] = Math.Abs(value) < 1e-12 ? 0f : (float)value;
        }

        return values;
    }
}
