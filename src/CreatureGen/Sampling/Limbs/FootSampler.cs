using CreatureGen.Anatomy;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Draws what feet with toes and hooves end in: those of the parent that gives the legs, or of anybody on a strange creature.</summary>
internal static class FootSampler
{
    /// <summary>Probability at full strangeness of feet that are none of the parent's.</summary>
    private const double AnyFeet = 0.5;

    /// <summary>Probability of a split hoof on a strange creature with hooves.</summary>
    private const double AnyCleft = 0.5;

    private static readonly Weighted<FootStyle>[] mammal = Weights.Of((FootStyle.Paw, 0.75), (FootStyle.Plain, 0.25));
    private static readonly Weighted<FootStyle>[] bird = Weights.Of((FootStyle.Talon, 0.7), (FootStyle.Plain, 0.3));
    private static readonly Weighted<FootStyle>[] amphibian = Weights.Of((FootStyle.Sucker, 0.4), (FootStyle.Web, 0.4), (FootStyle.Plain, 0.2));
    private static readonly Weighted<FootStyle>[] others = Weights.Of((FootStyle.Plain, 0.7), (FootStyle.Sucker, 0.15), (FootStyle.Web, 0.15));
    private static readonly Weighted<FootStyle>[] any =
        Weights.Of((FootStyle.Plain, 0.6), (FootStyle.Paw, 1), (FootStyle.Web, 1), (FootStyle.Talon, 1), (FootStyle.Sucker, 0.8), (FootStyle.Stump, 0.8));

    /// <summary>The feet with toes of a creature: webbed on who swims by them.</summary>
    public static FootStyle Toes(CreatureBuilder builder)
    {
        if (builder.Kind == LocomotionKind.Swimming)
        {
            return FootStyle.Web;
        }

        RandomStream random = builder.Stream("feet");
        SpeciesProfile legs = builder.Parents.Legs;
        bool strange = random.Chance(AnyFeet * builder.Strangeness);
        FootStyle own = CreatureBuilder.Choose(random, legs.Feet ?? OfClass(legs.Class));
        FootStyle other = CreatureBuilder.Choose(random, any);

        // Neighbours on many legs stand too near for long toes, and discs at the ends of short toes that stand under the body are balls.
        FootStyle drawn = strange ? other : own;
        return builder.Plan == BodyPlan.ManyLegged ? FootStyle.Plain : drawn == FootStyle.Sucker && PlanTraits.IsAboveLegs(builder.Plan) ? FootStyle.Plain : drawn;
    }

    /// <summary>The hooves of a creature.</summary>
    public static FootStyle Hooves(CreatureBuilder builder)
    {
        RandomStream random = builder.Stream("hooves");
        bool strange = random.Chance(AnyCleft * builder.Strangeness);
        return strange || builder.Parents.Legs.IsCloven ? FootStyle.Cloven : FootStyle.Plain;
    }

    private static Weighted<FootStyle>[] OfClass(AnimalClass group) => group switch
    {
        AnimalClass.Mammal => mammal,
        AnimalClass.Bird => bird,
        AnimalClass.Amphibian => amphibian,
        _ => others,
    };
}
