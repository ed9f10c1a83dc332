using System;
using CreatureGen.Anatomy;
using CreatureGen.Inspection;

namespace CreatureGen.Genetics.Criteria;

/// <inheritdoc cref="CriterionCatalogue.Stable"/>
internal sealed class StabilityCriterion : ICriterion
{
    /// <inheritdoc/>
    public string Name => "stable";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Creature;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        if (candidate.Blueprint.Kind != LocomotionKind.Walking && candidate.Measures.LegPairs == 0)
        {
            return 0;
        }

        double height = Math.Max(candidate.Creature.Mass.Centre.Y, 1e-6);
        return Math.Max(0, StandingBalance.Of(candidate.Creature).Metres) / height;
    }
}
