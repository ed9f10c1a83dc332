using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Genetics.Populations;

namespace CreatureGen.Console.Evolving;

/// <summary>How a generation did.</summary>
/// <param name="Number">0 for the founders.</param>
/// <param name="Best">The best score.</param>
/// <param name="Median">The score in the middle.</param>
/// <param name="Champion">Who has the best.</param>
/// <param name="Creatures">How many live.</param>
internal sealed record GenerationRow(int Number, double Best, double Median, ulong Champion, int Creatures);

/// <summary>A creature that lived in a run, whether it still does or not.</summary>
/// <param name="Identity">The number by which it is known.</param>
/// <param name="Born">The generation in which it first lived.</param>
/// <param name="Score">How well it did then.</param>
/// <param name="Lineage">Its parents and what they gave it; null for a founder from a seed.</param>
internal sealed record Ancestor(ulong Identity, int Born, double Score, LineageBlueprint? Lineage);

/// <summary>All that is known of a run of generations.</summary>
/// <param name="Settings">What it was started with, name by name; it can only be taken up with the same.</param>
/// <param name="Picks">The creatures that somebody picked last.</param>
/// <param name="Rows">How each generation did, from the founders on.</param>
/// <param name="Ancestors">Everybody who lived, in the order in which they came.</param>
/// <param name="Now">The last generation.</param>
internal sealed record EvolutionRun(
    IReadOnlyList<(string Name, string Value)> Settings,
    IReadOnlyList<ulong> Picks,
    IReadOnlyList<GenerationRow> Rows,
    IReadOnlyList<Ancestor> Ancestors,
    Generation Now)
{
    /// <summary>A run of its founders alone.</summary>
    public static EvolutionRun Started(IReadOnlyList<(string Name, string Value)> settings, IReadOnlyList<ulong> picks, Generation founders) =>
        new EvolutionRun(settings, picks, [], [], founders).With(founders);

    /// <summary>The run with one generation more.</summary>
    public EvolutionRun With(Generation generation)
    {
        var known = Ancestors.Select(one => one.Identity).ToHashSet();
        IEnumerable<Ancestor> newcomers = generation.Individuals.Where(one => known.Add(one.Identity)).Select(one => new Ancestor(one.Identity, generation.Number, one.Score, one.Blueprint.Lineage));
        return this with
        {
            Rows = [.. Rows, new GenerationRow(generation.Number, generation.Best.Score, generation.Median, generation.Best.Identity, generation.Individuals.Count)],
            Ancestors = [.. Ancestors, .. newcomers],
            Now = generation,
        };
    }
}
