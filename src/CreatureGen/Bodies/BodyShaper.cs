using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Blueprints;
using CreatureGen.Lattices;
using CreatureGen.Maths;

namespace CreatureGen.Bodies;

/// <summary>From the blueprint to the sections of the body along its bent spine.</summary>
internal static class BodyShaper
{
    /// <summary>Metres. No section is thinner than this.</summary>
    internal const double ThinnestSection = 0.006;

    /// <summary>Share of the distance between two rings that a bend may take up on its inner side: below 1 rings never cross.</summary>
    private const double BendLimit = 0.75;

    // How far a ring of an abdomen swells and its groove is drawn in, in its depth: deeper, three rings of the grid are the facets of a cone.
    private const double Swell = 0.4, Groove = 0.6;

    /// <summary>Height of the spine of a body that lies, relative to its depth: the weight presses the belly flat by the rest, and it lies on a strip instead of a line.</summary>
    private const double Rest = 0.965;

    /// <summary>Exponents below this make sections with sharp edges.</summary>
    private const double Edged = 1.5;

    // Exponents of the sections of a fish above and below its spine: between back and keel its flanks are planes, and no ball from behind.
    private const double Ridged = 1.8;
    private const double Keeled = 1.7;

    /// <summary>Metres that the outline of a tail's fan or fin lies off its ring, along the spine: a bend must leave room for it.</summary>
    private const double TailOutline = 0.16;

    // From where on outlines are evened out and how often: that of the rump into the tail of all, and that of what swims from behind its neck on, which has no legs to end its trunk at.
    private const int RumpFirst = 40;
    private const int RumpRounds = 3;
    private const int SwimmerFirst = 24;
    private const int SwimmerRounds = 10;

    /// <summary>The sections of the body. The trunk of a legless body lies on the ground ring by ring.</summary>
    public static BodyShape Shape(BodyPlan plan, BodyBlueprint body, HeadBlueprint head, TailBlueprint tail)
    {
        BodyStations stations = BodyBlender.Blend(body);
        Span<double> cumulative = stackalloc double[BodyGrid.StationCount];
        double sum = 0;
        for (int i = 0; i < BodyGrid.StationCount; i++)
        {
            sum += stations.Length[i];
            cumulative[i] = sum;
        }

        Span<double> arc = stackalloc double[BodyGrid.Rings];
        var shape = new BodyShape();
        RingCurve.Through(cumulative, arc);
        RingCurve.Through(stations.Width, shape.Width);
        RingCurve.Through(stations.Top, shape.Top);
        RingCurve.Through(stations.Bottom, shape.Bottom);
        ApplyLattice(body, arc, shape.Step, shape.Width, shape.Top, shape.Bottom);
        ApplyDepth(body.Proportions, shape.Width, shape.Top, shape.Bottom);
        Fair(plan, body, shape);
        InsectWaist.Constrict(plan, body, shape);
        Divide(body.Annuli, shape.Width, shape.Top, shape.Bottom);
        TailShaper.Shape(tail, shape.Step, shape.Width, shape.Top, shape.Bottom);
        SetExponents(shape, plan, stations, head, tail);
        for (int i = 1; i < BodyGrid.Rings; i++)
        {
            shape.Arc[i] = shape.Arc[i - 1] + shape.Step[i];
        }

        Bend(shape, plan, body, tail);
        return shape;
    }

    /// <summary>What <see cref="Shape"/> gives for the same body in another posture, for a third of its cost.</summary>
    public static BodyShape Bent(BodyShape shape, BodyPlan plan, BodyBlueprint body, TailBlueprint tail)
    {
        BodyShape bent = shape.WithOtherBends();
        Bend(bent, plan, body, tail);
        return bent;
    }

    /// <summary>What <see cref="Shape"/> gives for the same body at another elevation, for a fortieth of its cost.</summary>
    public static BodyShape Raised(BodyShape shape, BodyPlan plan, double elevation)
    {
        BodyShape raised = shape.WithOtherHeights();
        SetHeights(raised, plan, elevation);
        return raised;
    }

    /// <summary>How far a ring of a legless body lies on the ground, 0..1.</summary>
    public static double Lying(BodyPlan plan, int ring) => plan == BodyPlan.Legless ? Scalar.Smooth((ring - 21) / 7.0) : 0;

    /// <summary>Lays sections along the spine as the posture bends it.</summary>
    private static void Bend(BodyShape shape, BodyPlan plan, BodyBlueprint body, TailBlueprint tail)
    {
        double[] pitch = shape.Pitch;
        Span<double> stations = stackalloc double[BodyGrid.StationCount];
        BodyBlender.Pitch(body, stations);
        RingCurve.Through(stations, pitch);
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            pitch[i] += body.Posture.Trunk * Scalar.Smooth((i - 12) / 8.0);
        }

        Smooth(pitch);
        LimitCurvature(pitch, shape.Step, shape.Top, shape.Bottom, IsFinned(tail.Style) || tail.Style == TailStyle.Feathers ? TailOutline : 0);
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            pitch[i] *= 1 - Lying(plan, i);
        }

        shape.TurnSections();
        LaySpine(shape);
        SetHeights(shape, plan, body.Elevation);
    }

    private static void ApplyLattice(BodyBlueprint body, Span<double> arc, Span<double> step, double[] width, double[] top, double[] bottom)
    {
        Span<double> sliceWidth = stackalloc double[11];
        Span<double> sliceHeight = stackalloc double[11];
        Span<double> sliceLength = stackalloc double[11];
        for (int k = 0; k < 11; k++)
        {
            sliceWidth[k] = body.Slices[k].Width;
            sliceHeight[k] = body.Slices[k].Height;
            sliceLength[k] = body.Slices[k].Length;
        }

        Span<double> t = stackalloc double[BodyGrid.Rings];
        Span<double> widthFactor = stackalloc double[BodyGrid.Rings];
        Span<double> heightFactor = stackalloc double[BodyGrid.Rings];
        Span<double> position = stackalloc double[BodyGrid.Rings];
        double total = arc[BodyGrid.Rings - 1] - arc[0];
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            t[i] = (arc[i] - arc[0]) / total;
        }

        RingLattice.Evaluate(sliceWidth, sliceHeight, sliceLength, t, widthFactor, heightFactor, position);
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            width[i] = Math.Max(width[i], ThinnestSection) * widthFactor[i];
            top[i] = Math.Max(top[i], ThinnestSection) * heightFactor[i];
            bottom[i] = Math.Max(bottom[i], ThinnestSection) * heightFactor[i];
            step[i] = i == 0 ? 0 : (position[i] - position[i - 1]) * total;
        }
    }

    /// <summary>Deepens or flattens the body between the head and the tail, which keep more of their own shape.</summary>
    private static void ApplyDepth(BodyProportions p, double[] width, double[] top, double[] bottom)
    {
        double depth = p.Depth;
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            double fraction = i <= 6 ? Scalar.Lerp(0.08, 0.25, i / 6.0)
                : i <= StationRing.TrunkFirst ? Scalar.Lerp(0.25, 1, (i - 6) / 14.0)
                : i <= StationRing.Belly ? 1
                : i <= StationRing.TorsoLast ? Scalar.Lerp(1, 0.4, (i - StationRing.Belly) / 10.0)
                : Scalar.Lerp(0.4, 0, (i - StationRing.TorsoLast) / 10.0);
            double factor = 1 + (fraction * (depth - 1));
            top[i] *= factor;
            bottom[i] *= factor;
            width[i] *= p.Width;
        }
    }

    /// <summary>Evens out outlines where stations are far apart and their regions come from other bodies: a change of slope there is the corner of an abdomen, of a belly or of a shoulder.</summary>
    private static void Fair(BodyPlan plan, BodyBlueprint body, BodyShape shape)
    {
        bool swims = IsStreamlined(plan, body);
        foreach (double[] size in new[] { shape.Width, shape.Top, shape.Bottom })
        {
            Fair(size, RumpFirst, RumpRounds);
            if (swims)
            {
                Fair(size, SwimmerFirst, SwimmerRounds);
            }
        }
    }

    /// <summary>Draws sizes of rings, from the first up to the tip of the tail, near to those beside them.</summary>
    private static void Fair(double[] size, int first, int rounds)
    {
        for (int round = 0; round < rounds; round++)
        {
            double before = size[first - 1];
            for (int i = first; i < StationRing.TailTip; i++)
            {
                double here = size[i];
                size[i] = (before + (2 * here) + size[i + 1]) / 4;
                before = here;
            }
        }
    }

    /// <summary>Whether a body slips through water; a disc is all edge.</summary>
    private static bool IsStreamlined(BodyPlan plan, BodyBlueprint body) => plan is BodyPlan.Fish or BodyPlan.Eel or BodyPlan.Whale or BodyPlan.Flipper && body.Disc.Sweep == 0;

    /// <summary>Rings like those of an abdomen: every third ring of the grid swells, the one before it is drawn in.</summary>
    private static void Divide(AnnuliBlueprint annuli, double[] width, double[] top, double[] bottom)
    {
        for (int i = annuli.Ring; annuli.Depth > 0 && i < BodyGrid.Rings - 2; i++)
        {
            int phase = (i - annuli.Ring) % 3;
            double factor = phase == 0 ? 1 + (Swell * annuli.Depth) : phase == 1 ? 1 : 1 - (Groove * annuli.Depth);
            width[i] *= factor;
            top[i] *= factor;
            bottom[i] *= factor;
        }
    }

    private static void Smooth(double[] pitch)
    {
        for (int round = 0; round < 3; round++)
        {
            double before = pitch[0];
            for (int i = 1; i < pitch.Length - 1; i++)
            {
                double here = pitch[i];
                pitch[i] = (before + (2 * here) + pitch[i + 1]) / 4;
                before = here;
            }
        }
    }

    /// <summary>
    /// Spreads bends that are too sharp for the thickness of the body over their neighbours, so that rings never cross on the inner side of a bend.
    /// The anchor ring keeps its pitch.
    /// </summary>
    private static void LimitCurvature(double[] pitch, ReadOnlySpan<double> step, double[] top, double[] bottom, double tailReach)
    {
        const int Rounds = 60;
        const double Settled = 1e-4;
        int last = pitch.Length - 1;
        Span<double> bend = stackalloc double[BodyGrid.Rings];
        Span<double> clamped = stackalloc double[BodyGrid.Rings];

        // How far a ring may bend down and up: known before the rounds, which take most of the time of a shape.
        Span<double> down = stackalloc double[BodyGrid.Rings];
        Span<double> up = stackalloc double[BodyGrid.Rings];
        double anchor = pitch[BodyGrid.AnchorRing];
        for (int i = 1; i <= last; i++)
        {
            bend[i] = pitch[i] - pitch[i - 1];
            double reach = i > StationRing.TorsoLast ? tailReach : 0;
            down[i] = BendLimit * step[i] / Math.Max(Math.Max(top[i], top[i - 1]), reach);
            up[i] = BendLimit * step[i] / Math.Max(Math.Max(bottom[i], bottom[i - 1]), reach);
        }

        int first = 1;
        for (int round = 0; round < Rounds; round++)
        {
            double worst = 0;
            int sharp = 0;
            for (int i = first; i <= last; i++)
            {
                double held = Held(bend[i], down[i], up[i]);
                double excess = Math.Abs(held - bend[i]);
                clamped[i] = held;
                worst = excess > worst ? excess : worst;
                sharp = sharp == 0 && excess > 0 ? i : sharp;
            }

            if (worst < Settled)
            {
                break;
            }

            // Before the first bend that is too sharp nothing is spread: the next round begins where this one changes something.
            first = Math.Max(1, sharp - 1);
            double spread = 0;
            for (int i = sharp; i <= last; i++)
            {
                clamped[i] += spread;
                spread = 0.5 * (bend[i] - clamped[i]);
                if (i > 1)
                {
                    clamped[i - 1] += spread;
                }
            }

            clamped.Slice(first).CopyTo(bend.Slice(first));
        }

        // What could not be spread is cut off: rings never cross, whatever the posture asks for.
        pitch[0] = 0;
        for (int i = 1; i <= last; i++)
        {
            pitch[i] = pitch[i - 1] + Held(bend[i], down[i], up[i]);
        }

        double shift = anchor - pitch[BodyGrid.AnchorRing];
        for (int i = 0; i <= last; i++)
        {
            pitch[i] += shift;
        }
    }

    /// <summary>A bend within what a ring may bend down and up.</summary>
    private static double Held(double bend, double down, double up) => bend < 0 ? (bend < -down ? -down : bend) : bend > up ? up : bend;

    private static void LaySpine(BodyShape shape)
    {
        for (int i = 1; i < BodyGrid.Rings; i++)
        {
            double p = (shape.Pitch[i] + shape.Pitch[i - 1]) / 2;
            PortableMath.SinCos(p, out double sine, out double cosine);
            shape.Rise[i] = shape.Rise[i - 1] - (shape.Step[i] * sine);
            shape.Z[i] = shape.Z[i - 1] - (shape.Step[i] * cosine);
        }

        double z = shape.Z[BodyGrid.AnchorRing];
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            shape.Z[i] -= z;
        }
    }

    private static void SetHeights(BodyShape shape, BodyPlan plan, double elevation)
    {
        double y = shape.Rise[BodyGrid.AnchorRing] - elevation;
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            shape.Y[i] = Scalar.Lerp(shape.Rise[i] - y, Rest * shape.Bottom[i], Lying(plan, i));
        }
    }

    private static void SetExponents(BodyShape shape, BodyPlan plan, BodyStations stations, HeadBlueprint head, TailBlueprint tail)
    {
        bool finned = IsFinned(tail.Style);
        for (int i = 0; i < BodyGrid.Rings; i++)
        {
            double keel = plan == BodyPlan.Fish ? Scalar.Smooth((i - StationRing.Nape) / (double)(StationRing.Shoulder - StationRing.Nape)) : 0;
            double top = Scalar.Lerp(stations.TopExponent, Math.Min(stations.TopExponent, Ridged), keel);
            double bottom = Scalar.Lerp(stations.BottomExponent, Math.Min(stations.BottomExponent, Keeled), keel);
            if (i < StationRing.Nape)
            {
                top = bottom = 2.2;
                if (i < 9)
                {
                    // The muzzle is boxiest at ring 3.
                    double q = i <= 3 ? i / 3.0 : (8 - i) / 5.0;
                    top = bottom = 2.2 + (Math.Max(0, q) * (head.MuzzleSquareness - 2.2));
                }
            }
            else if (i >= StationRing.TorsoLast)
            {
                top = bottom = finned && i >= StationRing.TailFirst ? 1.7 : 2;
            }

            // A body that is thin at its edges thins out from the muzzle on; its tail is round again.
            double thin = i < StationRing.Nape ? Scalar.Smooth((i - 2) / 9.0) : i >= StationRing.TorsoLast ? 0 : 1;
            double edge = Scalar.Smooth((i - StationRing.Loin) / 8.0);
            shape.TopExponent[i] = stations.TopExponent < Edged ? Scalar.Lerp(Scalar.Lerp(1.8, stations.TopExponent, thin), 1.7, edge) : top;
            shape.BottomExponent[i] = stations.BottomExponent < Edged ? Scalar.Lerp(Scalar.Lerp(1.8, stations.BottomExponent, thin), 1.7, edge) : bottom;
        }
    }

    /// <summary>Whether a tail ends in a fin.</summary>
    private static bool IsFinned(TailStyle style) => style is TailStyle.Fork or TailStyle.Fan or TailStyle.Lance or TailStyle.Fluke || TailFin.Of(style) != null;
}
