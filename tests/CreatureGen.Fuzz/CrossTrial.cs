using System;
using CreatureGen.Blueprints;
using CreatureGen.Genetics;
using CreatureGen.Inspection;
using CreatureGen.Sampling;
using CreatureGen.Seeding;

namespace CreatureGen.Fuzz;

/// <summary>A random cross of two creatures of any kinds.</summary>
internal static class CrossTrial
{
    /// <summary>Breeds the pair of a number and says what came of it.</summary>
    public static string Of(long index, FuzzInputs parents)
    {
        RandomStream random = new Seed((ulong)index).Child("cross").Stream();
        CreatureBlueprint first = Whole(parents.Parent(random)), second = Whole(parents.Parent(random));
        try
        {
            Offspring child = Breeding.Child(first, second, (ulong)index, new BreedingSettings { Mutation = 0.25 });
            if (CreatureInspection.Inspect(child.Creature).Count > 0)
            {
                return "broken";
            }

            return child.Attempts > Breeding.MaxAttempts ? "given up"
                : child.Attempts > 1 ? "another child tried"
                : child.Repairs.Count > 0 ? "repaired" : "clean";
        }
        catch (Exception problem) when (problem is not OutOfMemoryException)
        {
            return "crashed " + problem.GetType().Name;
        }
    }

    /// <summary>The parent at the usual budget, within which the surface stays as it grew: what is judged is the cross, not the thinning, and it takes a quarter of the time.</summary>
    private static CreatureBlueprint Whole(CreatureBlueprint parent) => parent with { TriangleBudget = CreatureOptions.Default.TriangleBudget };
}
