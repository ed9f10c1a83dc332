using System;
using System.Collections.Generic;

namespace CreatureGen.Blueprints;

/// <summary>Says what is wrong with a blueprint before anything is built from it.</summary>
public static class BlueprintValidator
{
    private const string What = "blueprint";

    /// <summary>All problems of a blueprint: fields out of range, and parts that do not fit together. Empty for a good one. At most 1000 are kept.</summary>
    /// <exception cref="ArgumentNullException">The blueprint is null.</exception>
    public static IReadOnlyList<Problem> Validate(CreatureBlueprint blueprint)
    {
        if (blueprint is null)
        {
            throw new ArgumentNullException(nameof(blueprint));
        }

        var problems = new ProblemList(What);
        FieldChecker.Check(blueprint, CreatureFields.Creature, problems);
        BlueprintRules.Check(blueprint, problems);
        return problems.All;
    }

    /// <summary>Passes a good blueprint.</summary>
    /// <exception cref="ArgumentNullException">The blueprint is null.</exception>
    /// <exception cref="ArgumentException">The blueprint is not valid; the message tells all problems, each on a line of its own.</exception>
    public static void ThrowIfInvalid(CreatureBlueprint blueprint) =>
        RecordJson.ThrowIfAny(Validate(blueprint), "the blueprint is not valid", nameof(blueprint));
}
