using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Rigging;

namespace CreatureGen.Inspection;

/// <summary>Whether engines can take the joints, and whether they make up the limbs that the blueprint asks for. That joints agree with one another is proved by the skeleton itself.</summary>
internal static class SkeletonChecks
{
    /// <summary>Most joints that engines with joint numbers of one byte can take.</summary>
    private const int MostJoints = 255;

    public static void Check(Creature creature, ViolationList found)
    {
        CheckJoints(creature.Skeleton, found);
        CheckLimbs(creature, found);
    }

    private static void CheckJoints(Skeleton skeleton, ViolationList found)
    {
        if (skeleton.Count > MostJoints)
        {
            found.Add(CreatureInspection.Joints, $"{skeleton.Count} joints; expected at most {MostJoints}");
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

    /// <summary>What a plan cannot move without: the sampler may leave out an ornament for want of room, never one of these.</summary>
    private static void RequireMovers(CreatureBlueprint blueprint, ViolationList found)
    {
        int pectorals = 0;
        foreach (FinBlueprint fin in blueprint.Fins)
        {
            pectorals += fin.Place == FinPlace.Pectoral ? 1 : 0;
        }

        int standing = 0;
        foreach (LegBlueprint leg in blueprint.Legs)
        {
            // A mantis stands on four legs and holds up its first two.
            standing += leg.Stance == LegStance.Standing || leg.Archetype == LimbArchetype.Raptorial ? 1 : 0;
        }

        (int have, int need, string what) = blueprint.Plan switch
        {
            BodyPlan.Flapping => (blueprint.Wings.Count, 1, "pairs of wings"),
            BodyPlan.Buzzing => (blueprint.InsectWings.Count, 1, "pairs of thin wings"),
            BodyPlan.Fish or BodyPlan.Whale => (pectorals, 1, "pairs of fins"),
            BodyPlan.Flipper => (pectorals, 2, "pairs of fins"),
            BodyPlan.Legless or BodyPlan.Eel => (0, 0, "limbs"),
            BodyPlan.Upright or BodyPlan.Theropod => (standing, 1, "pairs of standing legs"),
            BodyPlan.Hexapod => (standing, 3, "pairs of standing legs"),
            BodyPlan.ManyLegged => (standing, 4, "pairs of standing legs"),
            _ => (standing, 2, "pairs of standing legs"),
        };
        if (have < need)
        {
            found.Add(CreatureInspection.Limbs, $"{have} {what}; expected at least {need} for the plan {blueprint.Plan}");
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
