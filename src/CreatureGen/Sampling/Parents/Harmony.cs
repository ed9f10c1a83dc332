using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Parents;

/// <summary>Withdraws what would look stuck on or could not be carried, one part at a time; all else stays as it was drawn.</summary>
internal static class Harmony
{
    /// <summary>The parents after the rules.</summary>
    /// <param name="parents">The parents as drawn.</param>
    /// <param name="mover">The parent whose own limbs carry the creature.</param>
    /// <param name="kind">How it moves.</param>
    public static Parentage Settle(Parentage parents, SpeciesProfile mover, LocomotionKind kind)
    {
        SpeciesProfile first = parents.First;
        if (!CanLend(parents.Legs, first, kind) || (parents.Legs.Class == AnimalClass.Arthropod) != (first.Class == AnimalClass.Arthropod))
        {
            parents = parents with { Legs = mover };
        }

        // Feelers and palps would stand in the place of a face.
        if (parents.Head.Class == AnimalClass.Arthropod && first.Class != AnimalClass.Arthropod)
        {
            parents = parents with { Head = first };
        }

        // A ray thins out into its wings from the muzzle on: a skull with a neck is a plug in it.
        if (first.Disc.Sweep != 0 && parents.Head.Class is AnimalClass.Mammal or AnimalClass.Bird)
        {
            parents = parents with { Head = first };
        }

        // And on another body its skull is a slit without a face, with lobes before it.
        if (first.Disc.Sweep == 0 && parents.Head.Disc.Sweep != 0)
        {
            parents = parents with { Head = first };
        }

        if (parents.Head.Disc.Sweep == 0 && parents.Ornaments.Disc.Sweep != 0)
        {
            parents = parents with { Ornaments = parents.Head };
        }

        // Hair and collars would stand along its edges.
        if (first.Disc.Sweep != 0)
        {
            parents = parents with { Ornaments = parents.Head };
        }

        // What insects wear on their heads belongs to their heads, and what others wear does not.
        if ((parents.Ornaments.Class == AnimalClass.Arthropod) != (parents.Head.Class == AnimalClass.Arthropod))
        {
            parents = parents with { Ornaments = parents.Head };
        }

        // Standing on two legs of a bird's height, a long tail would lie on the ground.
        if (parents.Legs.Bird != null && kind != LocomotionKind.Swimming && parents.Tail.Class != AnimalClass.Bird)
        {
            parents = parents with { Tail = first };
        }

        // On the thin legs of an insect a tail would hang through the ground where an abdomen ends.
        if (first.Class == AnimalClass.Arthropod && parents.Tail.Class != AnimalClass.Arthropod)
        {
            parents = parents with { Tail = first };
        }

        bool steers = parents.Fins.Fins is null == first.Fins is null && PairsOf(parents.Fins) >= PairsOf(first);
        return kind != LocomotionKind.Swimming || (steers && parents.Fins.Class == first.Class) ? parents : parents with { Fins = first };
    }

    /// <summary>The parents on a plan: a body that lies on the ground would be tipped over by the heads of mammals and birds.</summary>
    public static Parentage On(Parentage parents, BodyPlan plan) =>
        plan == BodyPlan.Legless && !LiesLow(parents.Head) ? parents with { Head = parents.First, Ears = parents.First } : parents;

    private static bool LiesLow(SpeciesProfile species) => species.Class is AnimalClass.Reptile or AnimalClass.Amphibian or AnimalClass.Fish;

    /// <summary>The shell of a creature: wing cases on insects alone, a carapace on legs under a level back.</summary>
    public static ShellBlueprint ShellOf(Parentage parents, BodyPlan plan)
    {
        ShellBlueprint shell = parents.Ornaments.Shell;
        bool own = parents.Ornaments == parents.First;
        bool level = plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Sprawling;
        bool fits = own || (shell.Style == ShellStyle.Elytra ? parents.First.Class == AnimalClass.Arthropod : level);
        return fits ? shell : new ShellBlueprint(ShellStyle.None, Ring: 24, Rows: 20, Columns: 6, Rise: 0);
    }

    /// <summary>Pairs of fins that a species brings with it, without which nothing steers.</summary>
    private static int PairsOf(SpeciesProfile species)
    {
        int pairs = 0;
        foreach (FinSitePreset fin in species.Fins?.Fins ?? Array.Empty<FinSitePreset>())
        {
            pairs += fin.Place == FinPlace.Pectoral ? 1 : 0;
        }

        return pairs;
    }

    /// <summary>Whether a species can give plan and legs to another body: swimmers keep their own, and only bodies that lie on the ground anyway go without.</summary>
    private static bool CanLend(SpeciesProfile legs, SpeciesProfile body, LocomotionKind kind)
    {
        Weighted<BodyPlan>[] plans = legs.PlansOf(kind);
        bool lies = Array.Exists(plans, plan => plan.Value == BodyPlan.Legless);
        return legs == body || (plans.Length > 0 && legs.FrequencyOf(kind) > 0 && kind != LocomotionKind.Swimming && (!lies || Array.Exists(body.PlansOf(kind), plan => plan.Value == BodyPlan.Legless)));
    }
}
