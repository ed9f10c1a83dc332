using System;

namespace CreatureGen.Genetics.Criteria;

/// <summary>Height for its size: giraffes rather than hippos.</summary>
public sealed class TallnessCriterion : ICriterion
{
    /// <inheritdoc/>
    public string Name => "tall";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Creature;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        return candidate.Measures.Height / candidate.Measures.Size;
    }
}
