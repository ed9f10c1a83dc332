using System;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Beaks;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Features;

/// <summary>Draws the beak of the parent whose head a creature has, as long as suits its own head.</summary>
internal static class BeakSampler
{
    /// <summary>Metres between the tip of a beak and the ground.</summary>
    private const double Clearance = 0.02;

    /// <summary>What is left of a beak at the least that would touch the ground, metres.</summary>
    private const double Shortest = 0.004;

    /// <summary>The beak; null for a head that has none.</summary>
    public static BeakBlueprint? Sample(CreatureBuilder builder)
    {
        SpeciesProfile species = builder.Parents.Head;
        if (species.Snout != SnoutKind.Beak || species.MouthCorner == 0)
        {
            return null;
        }

        RandomStream random = builder.Stream("beak");
        BeakStyle style = CreatureBuilder.Choose(random, species.Beaks);
        BeakForm form = BeakForm.Of(style);
        double length = CreatureBuilder.Between(random, form.Length) * HeadSampler.HalfHeight(builder.Shape);
        double girth = random.LogNormal(0.12, 0.8, 1.3);
        double hook = form.Hook + Scalar.Clamp(random.Normal(0, 0.1), -0.2, 0.2);
        return new BeakBlueprint(style, OffGround(builder, length, hook), girth, hook);
    }

    /// <summary>A length that does not reach the ground.</summary>
    /// <param name="builder">The body.</param>
    /// <param name="length">The length that it would have, metres.</param>
    /// <param name="hook">How far it turns down to its tip, radians.</param>
    public static double OffGround(CreatureBuilder builder, double length, double hook)
    {
        BodyShape s = builder.Shape;
        double fall = Math.Max(0, -PortableMath.Sin(s.Pitch[StationRing.Nose] - (0.5 * hook)));
        double room = Math.Max(0, StanceSampler.Lowest(s, StationRing.Nose, StationRing.Nostrils) - Clearance);
        return builder.IsOnGround && fall * length > room ? Math.Max(Shortest, room / fall) : length;
    }
}
