using System;
using CreatureGen.Bodies;
using CreatureGen.Sampling.Features;
using CreatureGen.Sampling.Placement;

namespace CreatureGen.Sampling.Shapes;

/// <summary>What the jaws of an open mouth enclose: it weighs at the front of the head, and the feet stand under it.</summary>
internal static class OpenJaw
{
    /// <summary>Part of the wedge between the jaws that the skin of the mouth leaves inside the body: .5 to .6 of grown creatures.</summary>
    private const double Enclosed = 0.55;

    /// <summary>Foremost rings that may be the hinge of a jaw, and rings from a mouth's corner to it.</summary>
    private const int LastHinge = 14;
    private const int BehindCorner = 3;

    /// <summary>The torso with the weight of an open mouth. Asked for up to five times while legs are placed on one shape, and measured once.</summary>
    public static SpineMeasure Measure(CreatureBuilder builder)
    {
        BodyShape s = builder.Shape;
        if (builder.Measured is not var (measured, measure) || measured != s)
        {
            measure = Load(builder, SpineSurvey.Measure(s.Y, s.Z, s.Width, s.Top, s.Bottom));
            builder.Measured = (s, measure);
        }

        return measure;
    }

    /// <summary>The body with the weight of its open mouth, as far as it opens where no ground is in its way.</summary>
    private static SpineMeasure Load(CreatureBuilder builder, SpineMeasure measure)
    {
        double angle = HeadSampler.Opening(builder);
        if (angle == 0)
        {
            return measure;
        }

        BodyShape s = builder.Shape;
        int hinge = HingeOf(builder);
        double volume = 0;
        double moment = 0;
        for (int i = 0; i < hinge; i++)
        {
            double slice = 2 * s.Width[i] * angle * (s.Arc[hinge] - s.Arc[i]) * s.Step[i];
            volume += slice;
            moment += slice * s.Z[i];
        }

        return measure.Laden(moment / volume, Enclosed * volume / ((Enclosed * volume) + StanceSampler.Volume(s)));
    }

    /// <summary>The ring about which the lower jaw turns.</summary>
    public static int HingeOf(CreatureBuilder builder) => Math.Min(builder.Parents.Head.MouthCorner + BehindCorner, LastHinge);
}
