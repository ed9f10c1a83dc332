using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Maths;
using CreatureGen.Species;

namespace CreatureGen.Bodies;

/// <summary>The stalk between the thorax and the abdomen of an insect. Mixed with others its tables leave a shallow dip there, behind which the abdomen is an egg on the thorax.</summary>
internal static class InsectWaist
{
    /// <summary>Rings before and behind the loin over which the body goes over into its waist: a foot of the thorax stands before them.</summary>
    private const int Reach = 4;

    /// <summary>How full the end of a thorax is, in halves of a ball. Hollowed towards the stalk it is a bowl for who is behind it.</summary>
    private const double Fullness = 0.92;

    /// <summary>Draws the body in at its loin until it is as thin as its first species asks for.</summary>
    public static void Constrict(BodyPlan plan, BodyBlueprint body, BodyShape shape)
    {
        double wanted = SpeciesCatalogue.Find(body.Blend.First).Waist;
        if (wanted >= 1 || body.Shell.Style == ShellStyle.Elytra || plan is not (BodyPlan.Hexapod or BodyPlan.Buzzing))
        {
            return;
        }

        double thinner = wanted * Math.Min(Largest(shape, StationRing.Shoulder, StationRing.Belly), Largest(shape, StationRing.Pelvis, StationRing.TailTip));
        double factor = Math.Min(1, thinner / Size(shape, StationRing.Loin));
        for (int ring = StationRing.Loin - Reach; ring <= StationRing.Loin + Reach; ring++)
        {
            double here = Scalar.Lerp(factor, 1, Scalar.Smooth(Math.Abs(ring - StationRing.Loin) / (double)Reach));
            Scale(shape, ring, here);
        }

        Fill(shape);
    }

    /// <summary>Rounds the end of the thorax off before the stalk.</summary>
    private static void Fill(BodyShape shape)
    {
        double thorax = Size(shape, StationRing.Ribs);
        for (int ring = StationRing.Ribs + 1; ring < StationRing.Loin; ring++)
        {
            double along = (ring - StationRing.Ribs) / (double)(StationRing.Loin - StationRing.Ribs);
            double round = Fullness * thorax * Math.Sqrt(1 - (along * along));
            Scale(shape, ring, Math.Max(1, round / Size(shape, ring)));
        }
    }

    private static void Scale(BodyShape shape, int ring, double factor)
    {
        shape.Width[ring] *= factor;
        shape.Top[ring] *= factor;
        shape.Bottom[ring] *= factor;
    }

    /// <summary>Radius of the largest section, metres.</summary>
    private static double Largest(BodyShape shape, int first, int last)
    {
        double size = 0;
        for (int ring = first; ring <= last; ring++)
        {
            size = Math.Max(size, Size(shape, ring));
        }

        return size;
    }

    /// <summary>Radius of a section, metres.</summary>
    private static double Size(BodyShape shape, int ring) => Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
}
