using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;

namespace CreatureGen.Inspection;

/// <summary>Whether engines can take the joints, and whether they make up the limbs that the blueprint asks for. That joints agree with one another is proved by the skeleton itself.</summary>
internal static class SkeletonChecks
{
    /// <summary>Most joints that engines with joint numbers of one byte can take.</summary>
    private const int MaxJoints = 255;

    public static void Check(Creature creature, ViolationList found)
    {
        CheckJoints(creature.Skeleton, found);
        CheckLimbs(creature, found);
    }

    private static void CheckJoints(Skeleton skeleton, ViolationList found)
    {
        if (skeleton.Count > MaxJoints)
        {
            found.Add(CreatureInspection.Joints, $"{skeleton.Count} joints; expected at most {MaxJoints}");
        }
    }

    private static void CheckLimbs(Creature creature, ViolationList found)
    {
        CreatureBlueprint blueprint = creature.Blueprint;
        int legs = 2 * blueprint.Legs.Count;
        int wings = 2 * blueprint.Wings.Count;
        int insectWings = 2 * blueprint.InsectWings.Count;
        int pectorals = 0;
        int midline = 0;
        foreach (FinBlueprint fin in blueprint.Fins)
        {
            pectorals += fin.Place == FinPlace.Pectoral ? 2 : 0;
            midline += fin.Place == FinPlace.Pectoral ? 0 : 1;
        }

        Require(Count(creature, LimbKind.Leg, LimbKind.Arm), legs, "legs and arms", found);
        Require(Count(creature, LimbKind.Wing, LimbKind.Wing), wings, "wings", found);
        Require(Count(creature, LimbKind.InsectWing, LimbKind.InsectWing), insectWings, "thin wings", found);
        Require(Count(creature, LimbKind.Pectoral, LimbKind.Pectoral), pectorals, "paired fins", found);
        Require(Count(creature, LimbKind.Dorsal, LimbKind.Ventral), midline, "fins on the midline", found);
        RequireMovers(blueprint, found);
    }

    /// <summary>The sampler may leave out an ornament for want of room, never what a plan moves by.</summary>
    private static void RequireMovers(CreatureBlueprint blueprint, ViolationList found)
    {
        PlanNeeds needs = PlanNeeds.Of(blueprint);
        if (needs.Have < needs.Need)
        {
            found.Add(CreatureInspection.Limbs, $"{needs.Have} {needs.What}; expected at least {needs.Need} for the plan {blueprint.Plan}");
        }
    }

    private static void Require(int count, int expected, string what, ViolationList found)
    {
        if (count != expected)
        {
            found.Add(CreatureInspection.Limbs, $"{count} chains of {what}; expected {expected}, as in the blueprint");
        }
    }

    private static int Count(Creature creature, LimbKind first, LimbKind second)
    {
        int count = 0;
        foreach (LimbChain limb in creature.Limbs)
        {
            count += limb.Kind == first || limb.Kind == second ? 1 : 0;
        }

        return count;
    }
}
