using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Blueprints;
using CreatureGen.Repairs;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics;

/// <summary>Breeds creatures of any kinds with one another. A child is a function of its parents, a seed and the settings: the same ones always have the same child.</summary>
/// <remarks>
/// Crossing by linked groups, then mutation (<see cref="Mutation"/>), then repair. Based on: J. Hudson, "Creature Generation using Genetic Algorithms and
/// Auto-Rigging" (2013), which crosses whole meshes of one topology; linked groups are our own.
/// </remarks>
public static class Breeding
{
    /// <summary>Children that are tried before one of the parents is taken for the child, changed by mutation alone.</summary>
    internal const int MaxAttempts = 6;

    /// <summary>The child of two creatures.</summary>
    /// <param name="first">One parent.</param>
    /// <param name="second">The other; the same one for a child by mutation alone.</param>
    /// <param name="seed">Which of their children.</param>
    /// <param name="settings">How it is bred.</param>
    /// <exception cref="ArgumentException">A parent is not valid; the message tells all that is wrong with it.</exception>
    public static Offspring Child(CreatureBlueprint first, CreatureBlueprint second, ulong seed, BreedingSettings settings)
    {
        BlueprintValidator.ThrowIfInvalid(first);
        BlueprintValidator.ThrowIfInvalid(second);
        _ = settings ?? throw new ArgumentNullException(nameof(settings));
        (ulong firstIdentity, ulong secondIdentity) = (BlueprintIdentity.Of(first), BlueprintIdentity.Of(second));
        // Other parents have other children of the same number.
        Seed root = new Seed(seed).Child(Name(firstIdentity)).Child(Name(secondIdentity));
        for (int attempt = 0; attempt < MaxAttempts; attempt++)
        {
            Offspring? child = Try((first, firstIdentity), (second, secondIdentity), seed, root.Child(attempt), settings, attempt + 1);
            if (child != null)
            {
                return child;
            }
        }

        return Try((first, firstIdentity), (first, firstIdentity), seed, root.Child("alone"), BreedingSettings.Default with { Mutation = 0 }, MaxAttempts + 1)
            ?? throw new ArgumentException("the first parent builds a broken creature; expected one that is sound, or repaired", nameof(first));
    }

    /// <summary>Brothers and sisters: the children of seeds that follow from one.</summary>
    /// <exception cref="ArgumentException">A parent is not valid; the message tells all that is wrong with it.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The count is not above zero.</exception>
    public static IReadOnlyList<Offspring> Litter(CreatureBlueprint first, CreatureBlueprint second, ulong seed, int count, BreedingSettings settings)
    {
        if (count < 1)
        {
            throw new ArgumentOutOfRangeException(nameof(count), count, "expected at least 1");
        }

        var litter = new Offspring[count];
        for (int i = 0; i < count; i++)
        {
            litter[i] = Child(first, second, new Seed(seed).Child("litter").Child(i).Value, settings);
        }

        return litter;
    }

    private static string Name(ulong identity) => identity.ToString("x16", CultureInfo.InvariantCulture);

    private static Offspring? Try((CreatureBlueprint Blueprint, ulong Identity) first, (CreatureBlueprint Blueprint, ulong Identity) second, ulong seed, Seed root, BreedingSettings settings, int attempt)
    {
        CreatureBlueprint crossed = Crossover.Cross(first.Blueprint, second.Blueprint, root.Child("crossover"), out Inheritance inheritance);
        CreatureBlueprint mutated = Mutation.Mutate(crossed, settings.Mutation, root.Child("mutation"));
        var lineage = new LineageBlueprint(
            1 + Math.Max(first.Blueprint.Lineage?.Generation ?? 0, second.Blueprint.Lineage?.Generation ?? 0),
            first.Identity,
            second.Identity,
            settings.Mutation,
            inheritance.Frame,
            inheritance.Head,
            inheritance.Tail,
            inheritance.Ornaments,
            inheritance.Skin);
        RepairReport report = BlueprintRepair.Repair(mutated with { Seed = seed, Algorithm = CreatureBlueprint.CurrentAlgorithm, Lineage = lineage });
        return report.IsSound ? new Offspring(report.Creature, report.Changes, attempt) : null;
    }
}
