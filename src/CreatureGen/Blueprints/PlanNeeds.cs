using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;

namespace CreatureGen.Blueprints;

/// <summary>What a body plan cannot move without, and how much of it a blueprint has.</summary>
/// <param name="List">The list of the blueprint that it is in.</param>
/// <param name="What">Its name in messages.</param>
/// <param name="Have">Pairs that there are.</param>
/// <param name="Need">Pairs that the plan asks for at least.</param>
internal sealed record PlanNeeds(string List, string What, int Have, int Need)
{
    /// <summary>The needs of a blueprint's plan. Its lists are there.</summary>
    public static PlanNeeds Of(CreatureBlueprint blueprint) => blueprint.Plan switch
    {
        BodyPlan.Flapping => new PlanNeeds("wings", "pairs of wings", blueprint.Wings.Count, 1),
        BodyPlan.Buzzing => new PlanNeeds("insectWings", "pairs of thin wings", blueprint.InsectWings.Count, 1),
        BodyPlan.Fish or BodyPlan.Whale => new PlanNeeds("fins", "pairs of fins", PairedFins(blueprint), 1),
        BodyPlan.Flipper => new PlanNeeds("fins", "pairs of fins", PairedFins(blueprint), 2),
        BodyPlan.Legless or BodyPlan.Eel => new PlanNeeds("legs", "limbs", 0, 0),
        BodyPlan.Upright or BodyPlan.Theropod => Legs(blueprint, 1),
        BodyPlan.Hexapod => Legs(blueprint, 3),
        BodyPlan.ManyLegged => Legs(blueprint, 4),
        _ => Legs(blueprint, 2),
    };

    /// <summary>Pairs of legs that a walker may stand on. A mantis stands on four legs and holds up its first two.</summary>
    public static int StandingLegs(CreatureBlueprint blueprint)
    {
        int standing = 0;
        foreach (LegBlueprint leg in blueprint.Legs)
        {
            standing += leg.Stance == LegStance.Standing || LegKinds.Of(leg.Archetype).Outline is { Carried: true, Handed: false } ? 1 : 0;
        }

        return standing;
    }

    /// <summary>Pairs of fins on the flanks.</summary>
    public static int PairedFins(CreatureBlueprint blueprint)
    {
        int pairs = 0;
        foreach (FinBlueprint fin in blueprint.Fins)
        {
            pairs += fin.Place == FinPlace.Pectoral ? 1 : 0;
        }

        return pairs;
    }

    private static PlanNeeds Legs(CreatureBlueprint blueprint, int need) => new("legs", "pairs of standing legs", StandingLegs(blueprint), need);
}
