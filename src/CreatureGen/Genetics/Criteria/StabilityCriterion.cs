using System;
using CreatureGen.Anatomy;
using CreatureGen.Inspection;

namespace CreatureGen.Genetics.Criteria;

/// <summary>How firmly a creature stands: the tangent of the least slope on which it would tip over. 0 for what does not stand.</summary>
/// <remarks>Based on: R. B. McGhee and A. A. Frank, "On the stability properties of quadruped creeping gaits" (1968), the margin of static stability, here over the height of the centre of mass.</remarks>
public sealed class StabilityCriterion : ICriterion
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
