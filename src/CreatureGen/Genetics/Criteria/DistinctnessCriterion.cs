using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;

namespace CreatureGen.Genetics.Criteria;

/// <inheritdoc cref="CriterionCatalogue.Distinct"/>
internal sealed class DistinctnessCriterion : ICriterion
{
    /// <summary>Neighbours that count.</summary>
    private const int Neighbours = 5;

    /// <inheritdoc/>
    public string Name => "distinct";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Company;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        return Sparseness(candidate.Blueprint, candidate.Company, Neighbours);
    }

    /// <summary>Mean distance of a blueprint to the nearest of others; 1 if there are none.</summary>
    internal static double Sparseness(CreatureBlueprint blueprint, IReadOnlyList<CreatureBlueprint> others, int neighbours)
    {
        var distances = new List<double>(others.Count);
        foreach (CreatureBlueprint other in others)
        {
            distances.Add(SpeciesDistance.Between(blueprint, other));
        }

        distances.Sort();
        int near = Math.Min(neighbours, distances.Count);
        double sum = 0;
        for (int i = 0; i < near; i++)
        {
            sum += distances[i];
        }

        return near == 0 ? 1 : sum / near;
    }
}
