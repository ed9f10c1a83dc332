using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;

namespace CreatureGen.Genetics.Criteria;

/// <summary>What somebody likes: nearness to the nearest of the creatures that were picked, 0..1. With no picks all are alike.</summary>
/// <remarks>Breeding by eye, after: R. Dawkins, "The Blind Watchmaker" (1986); J. Secretan et al., "Picbreeder" (2011).</remarks>
public sealed class PicksCriterion : ICriterion
{
    private readonly IReadOnlyList<CreatureBlueprint> picks;

    /// <summary>Takes the picks.</summary>
    public PicksCriterion(IReadOnlyList<CreatureBlueprint> picks) => this.picks = picks ?? throw new ArgumentNullException(nameof(picks));

    /// <inheritdoc/>
    public string Name => "picks";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Blueprint;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        double near = picks.Count == 0 ? 1 : 0;
        foreach (CreatureBlueprint pick in picks)
        {
            near = Math.Max(near, 1 - SpeciesDistance.Between(pick, candidate.Blueprint));
        }

        return near;
    }
}
