using System;
using System.Collections.Generic;

namespace CreatureGen.Blueprints;

/// <summary>What came of reading a blueprint: either the blueprint or what is wrong with its text.</summary>
public sealed class BlueprintReading
{
    internal BlueprintReading(CreatureBlueprint? blueprint, IReadOnlyList<Problem> problems)
    {
        Draft = blueprint;
        Blueprint = problems.Count == 0 ? blueprint : null;
        Problems = problems;
    }

    /// <summary>The blueprint, valid in all its parts; null if there is any problem.</summary>
    public CreatureBlueprint? Blueprint { get; }

    /// <summary>
    /// What the text says as far as it could be read, problems or not: a field that has a problem holds a neutral value. Null for text that holds no object of a known format.
    /// Not to be built as it is; a repair makes it whole.
    /// </summary>
    public CreatureBlueprint? Draft { get; }

    /// <summary>All problems in the order of the text, those between several parts last; empty if there is a blueprint. At most 1000 are kept.</summary>
    public IReadOnlyList<Problem> Problems { get; }

    /// <summary>The blueprint.</summary>
    /// <exception cref="InvalidOperationException">There is none; the message tells all problems.</exception>
    public CreatureBlueprint GetBlueprint() =>
        Blueprint ?? throw new InvalidOperationException("this blueprint cannot be read:\n" + string.Join("\n", Problems));
}
