using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling.Parents;

/// <summary>Draws the parents of a creature and who gives what. Without strangeness a species is mixed with its kin and gives everything itself.</summary>
/// <remarks>Every decision has a stream of its own that it draws from at any strangeness, so that a seed's creature changes step by step with it.</remarks>
internal static class ParentSampler
{
    /// <summary>Probability at full strangeness that a group of parts comes from another parent.</summary>
    private const double Swapped = 0.72;

    /// <summary>The same of plan and legs: a body can stand on few other legs than its own.</summary>
    private const double SwappedLegs = 0.75;

    /// <summary>Probability at full strangeness that a swimmer whose parents have none has legs.</summary>
    private const double LeggedSwimmers = 0.35;

    /// <summary>How much of the strangeness other bodies gain in the trunk of an insect.</summary>
    private const double InsectLoosening = 0.35;

    /// <summary>Probability that the second parent gives a part that the first does not.</summary>
    private const double FromSecond = 0.6;

    /// <summary>How often a partner of the first parent's own class is drawn again.</summary>
    private const int Redraws = 8;

    private static readonly double[] partnerWeights = { 0.45, 0.3, 0.15, 0.1 };

    /// <summary>Draws the parents of a creature.</summary>
    /// <param name="root">Its seed.</param>
    /// <param name="kind">How it moves.</param>
    /// <param name="first">Its first parent.</param>
    /// <param name="mover">A species that moves so; where the first parent does not, it is the second and lends its limbs.</param>
    /// <param name="choice">What the options allow.</param>
    /// <param name="strangeness">0..1.</param>
    public static Parentage Draw(Seed root, LocomotionKind kind, SpeciesProfile first, SpeciesProfile mover, PlanChoice choice, double strangeness)
    {
        RandomStream random = root.Child("blend").Stream();
        string partner = first.Partners[random.Weighted(partnerWeights)];
        double kin = random.Uniform();
        IReadOnlyList<string> siblings = SpeciesCatalogue.SiblingsOf(first);
        int sibling = random.Integer(0, Math.Max(1, siblings.Count));
        if (kin < first.Kinship && siblings.Count > 0)
        {
            partner = siblings[sibling];
        }

        double t = strangeness;
        bool carried = !choice.Leaves(first, kind);
        SpeciesProfile second = Stranger(root.Child("second parent").Stream(), first, null, choice, t) ?? SpeciesCatalogue.Find(partner);
        second = carried ? mover : second;
        var rest = new List<SpeciesProfile>();
        foreach (SpeciesProfile family in SpeciesCatalogue.Families)
        {
            if (family.Body != first.Family && family != second)
            {
                rest.Add(family);
            }
        }

        SpeciesProfile third = rest[random.Integer(0, rest.Count)];

        // As wide as wings, a body is nothing without its edges, and an insect whose waist others fill in is a log on wires.
        double loosened = first.Disc.Sweep != 0 ? 0 : first.Class == AnimalClass.Arthropod ? InsectLoosening * t : t;
        double dominant = random.Uniform(Scalar.Lerp(first.Dominance.Min, 0.3, loosened), Scalar.Lerp(first.Dominance.Max, 0.6, loosened));
        double fraction = random.Uniform(Scalar.Lerp(0.6, 0.5, t), Scalar.Lerp(0.9, 0.85, t));
        third = Stranger(root.Child("third parent").Stream(), first, second, choice, t) ?? third;
        RandomStream regions = root.Child("regions").Stream();
        var parents = new Parentage(first, second, third)
        {
            Torso = (dominant, (1 - dominant) * fraction, (1 - dominant) * (1 - fraction)),
            Region = (Math.Min(1, 3 * t) * regions.Uniform(0.72, 0.90), Math.Min(1, 3 * t) * regions.Uniform(0.65, 0.90)),
        };
        parents = parents with
        {
            Legs = Donor("legs", SwappedLegs),
            Head = Donor("head", Swapped),
            Tail = Donor("tail", Swapped),
            Skin = Donor("skin", Swapped),
            Ornaments = Donor("ornaments", Swapped),
            Wings = Donor("wings", Swapped),
            Fins = Donor("fins", Swapped),
        };
        double distance = root.Child("distance").Stream().Uniform();
        if (distance < t * t && DistanceOf(parents) < 1)
        {
            parents = parents with { Head = second };
        }

        SpeciesProfile own = carried ? mover : first;
        if (!choice.Leaves(parents.Legs, kind))
        {
            parents = parents with { Legs = own };
        }

        parents = Harmony.Settle(parents, own, kind);
        foreach (SpeciesProfile other in new[] { second, third })
        {
            // Legs and head make the outline, of insects and fliers the wings: of what has both of its first parent there are doubles.
            bool unmixed = parents.Legs == first && parents.Head == first && first.Class != AnimalClass.Arthropod && kind != LocomotionKind.Flying;
            parents = unmixed && distance < t * (2 - t) ? Harmony.Settle(parents with { Head = other }, own, kind) : parents;
        }

        parents = distance < t * t * t ? Estranged(parents) : parents;
        parents = kind == LocomotionKind.Swimming ? parents with { Paddles = PaddlesOf(parents, root.Child("paddles").Stream(), t) } : parents;
        return parents with { Ears = EarsOf(parents, root.Child("foreign ears").Stream(), t) };

        SpeciesProfile Donor(string group, double swapped)
        {
            RandomStream stream = root.Child("donor").Child(group).Stream();
            bool other = stream.Chance(swapped * t);
            return stream.Chance(FromSecond) ? other ? second : first : other ? third : first;
        }
    }

    /// <summary>Any body that the options allow, rather of another class than the first parent's; null for kin.</summary>
    private static SpeciesProfile? Stranger(RandomStream random, SpeciesProfile first, SpeciesProfile? second, PlanChoice choice, double strangeness)
    {
        if (!random.Chance(strangeness))
        {
            return null;
        }

        IReadOnlyList<SpeciesProfile> all = SpeciesCatalogue.All;
        double[] weights = new double[all.Count];
        double total = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            weights[i] = all[i] == first || all[i] == second ? 0 : choice.WeightOf(all[i]);
            total += weights[i];
        }

        if (!(total > 0))
        {
            return null;
        }

        SpeciesProfile drawn = all[random.Weighted(weights)];
        for (int redraw = 0; redraw < Redraws && (second is null || Group(second) == Group(first)) && Group(drawn) == Group(first) && random.Chance(strangeness); redraw++)
        {
            drawn = all[random.Weighted(weights)];
        }

        return drawn;
    }

    /// <summary>The parents after head, skin and tail came from others, one after the other, until nobody would name the creature after its first; what the rules of harmony withdrew stays so.</summary>
    private static Parentage Estranged(Parentage parents)
    {
        SpeciesProfile first = parents.First;
        foreach (SpeciesProfile other in new[] { parents.Second, parents.Third })
        {
            // Over one pair of a bird's legs a long jaw would tip the body forward.
            bool fits = first.Disc.Sweep == 0 && other.Disc.Sweep == 0 && other.Class != AnimalClass.Arthropod && first.Class != AnimalClass.Arthropod && parents.Legs.Bird is null;
            parents = DistanceOf(parents) < 1 && fits && Group(other) != Group(first) ? parents with { Head = other, Ornaments = parents.Ornaments.Class == AnimalClass.Arthropod ? other : parents.Ornaments } : parents;
            parents = DistanceOf(parents) < 1 && Group(other) != Group(first) ? parents with { Skin = other } : parents;
        }

        bool tailed = parents.Legs.Bird is null && first.Class != AnimalClass.Arthropod;
        return DistanceOf(parents) < 1 && tailed ? parents with { Tail = parents.Second } : parents;
    }

    /// <summary>How far the parts are from what the first parent would have: 1 is enough for nobody to name it after an animal.</summary>
    private static double DistanceOf(Parentage parents)
    {
        SpeciesProfile first = parents.First;
        return (Group(parents.Head) != Group(first) ? 1 : parents.Head != first ? 0.5 : 0)
            + (parents.Tail != first ? 0.4 : 0)
            + (Group(parents.Skin) != Group(first) ? 0.4 : 0)
            + (parents.Legs != first ? 0.4 : 0);
    }

    /// <summary>Ears of a mammal among the parents now and then, on a head that has none.</summary>
    private static SpeciesProfile EarsOf(Parentage parents, RandomStream random, double strangeness)
    {
        bool foreign = random.Chance(0.35 * strangeness);
        if (!foreign || parents.Head.Class is AnimalClass.Mammal or AnimalClass.Arthropod)
        {
            return parents.Head;
        }

        foreach (SpeciesProfile parent in new[] { parents.First, parents.Second, parents.Third })
        {
            if (parent.Class == AnimalClass.Mammal)
            {
                return parent;
            }
        }

        return parents.Head;
    }

    /// <summary>The legs that a swimmer hangs: those of its parents, or of any species that has some.</summary>
    private static LegPreset? PaddlesOf(Parentage parents, RandomStream random, double strangeness)
    {
        var lenders = new List<LegPreset>();
        foreach (SpeciesProfile species in SpeciesCatalogue.All)
        {
            if (species.Paddles is LegPreset paddles)
            {
                lenders.Add(paddles);
            }
        }

        bool legged = random.Chance(LeggedSwimmers * strangeness);
        LegPreset lent = lenders[random.Integer(0, lenders.Count)];
        return parents.Legs.Paddles ?? (legged && parents.First.Disc.Sweep == 0 ? lent : null);
    }

    /// <summary>The class, lizards and toads taken as one.</summary>
    private static AnimalClass Group(SpeciesProfile species) => species.Class == AnimalClass.Amphibian ? AnimalClass.Reptile : species.Class;
}
