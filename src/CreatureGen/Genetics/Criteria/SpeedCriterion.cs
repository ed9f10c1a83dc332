using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;

namespace CreatureGen.Genetics.Criteria;

/// <inheritdoc cref="CriterionCatalogue.Fast"/>
internal sealed class SpeedCriterion : ICriterion
{
    /// <inheritdoc/>
    public string Name => "fast";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Creature;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        bool walks = candidate.Blueprint.Kind == LocomotionKind.Walking && candidate.Profile.Gaits != null;
        double speed = walks ? candidate.Profile.Gaits!.TopSpeed : candidate.Creature.DefaultSpeed;
        return speed / Math.Sqrt(StandardGravity.Acceleration * candidate.Measures.Size);
    }
}
