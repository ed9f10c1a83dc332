using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Shapes;

/// <summary>Draws tails without fins and feathers, those of the parent that gives the tail or any on a strange creature, and how straight fans of rays end.</summary>
internal static class TailSampler
{
    /// <summary>Probability at full strangeness of a tail that is none of the parent's.</summary>
    private const double AnyTail = 0.45;

    // Fork of a fan, negative for a rounded rear edge, and how much rounder that of a mixed creature is: on another body's tail a straight edge looks sawn off.
    private const double RoundestFan = -0.5;
    private const double StraightestFan = 0.1;
    private const double RoundedBy = 0.4;

    private static readonly Weighted<TailStyle>[] any =
        Weights.Of((TailStyle.Whip, 1), (TailStyle.Paddle, 1), (TailStyle.Club, 0.8), (TailStyle.Prehensile, 1), (TailStyle.Stinger, 0.8));

    private static readonly Weighted<TailStyle>[] flown = Weights.Of((TailStyle.Whip, 1), (TailStyle.Paddle, 0.7));

    /// <summary>The tail of a creature; null where it ends as its parents' do.</summary>
    public static TailBlueprint? Draw(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("tail family");
        SpeciesProfile donor = builder.Parents.Tail;
        bool strange = random.Chance(AnyTail * builder.Strangeness);
        double own = random.Uniform();
        TailStyle other = CreatureBuilder.Choose(random, builder.Kind == LocomotionKind.Flying ? flown : any);
        double fraction = random.Uniform(0.8, 1);
        TailStyle style = strange ? other : OwnOf(donor, own);

        // What lies, or balances on two legs, needs the tail that it has; on a bird's legs a long one would lie on the ground.
        bool carried = builder.Plan is not (BodyPlan.Legless or BodyPlan.Theropod) && builder.Parents.Legs.Bird is null && builder.Parents.First.Class != AnimalClass.Arthropod
            && builder.Parents.First.Disc.Sweep == 0;
        return style == TailStyle.Plain || !carried ? null : new TailBlueprint(style, fraction, 0);
    }

    /// <summary>The tail of a creature that has none of a family: as the tables give it, or evenly to a point where these end in what it does not have, as those of fish do in a fin, those of insects in an abdomen, and those of furred ones in hair.</summary>
    public static TailBlueprint Other(CreatureBuilder builder)
    {
        SpeciesProfile donor = builder.Parents.Tail;
        bool lacks = donor.Class switch
        {
            AnimalClass.Fish => true,
            AnimalClass.Arthropod => builder.Species.Class != AnimalClass.Arthropod,
            AnimalClass.Mammal => builder.Parents.Skin.Cover != SkinCover.Fur,
            _ => false,
        };
        bool runs = lacks && builder.Fitting > 0 && builder.Plan is not (BodyPlan.Legless or BodyPlan.ManyLegged) && builder.Species.Class != AnimalClass.Arthropod && builder.Species.Disc.Sweep == 0;
        return runs ? new TailBlueprint(TailStyle.Saurian, Math.Max(BlueprintRules.MinTailSize, builder.Fitting), 0) : new TailBlueprint(TailStyle.Plain, 0, 0);
    }

    /// <summary>The fork of a fan of fin rays.</summary>
    public static double FanFork(CreatureBuilder builder, RandomStream random) => random.Uniform(RoundestFan, StraightestFan) - (RoundedBy * builder.Fitting);

    private static TailStyle OwnOf(SpeciesProfile donor, double draw)
    {
        foreach (Weighted<TailStyle> tail in donor.Tails)
        {
            draw -= tail.Weight;
            if (draw < 0)
            {
                return tail.Value;
            }
        }

        return TailStyle.Plain;
    }
}
