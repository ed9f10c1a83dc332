using System;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;

namespace CreatureGen.Genetics.Criteria;

/// <inheritdoc cref="CriterionCatalogue.Efficient"/>
internal sealed class EconomyCriterion : ICriterion
{
    /// <inheritdoc/>
    public string Name => "efficient";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Motion;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        double cost = TransportCost.Of(candidate.Profile);
        return cost > 0 && cost < double.MaxValue ? 1 / cost : 0;
    }
}
