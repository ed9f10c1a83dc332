using System;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion;

namespace CreatureGen.Genetics.Criteria;

/// <summary>Speed for its size: the top speed v that the creature's motion allows, as v / √(g·size). The root of a Froude number, so that mice and horses compare.</summary>
/// <remarks>What walks has the top speed of its gaits (<see cref="GaitSet.TopSpeed"/>); what flies, swims or crawls has that of its cruise. Source of the ratio: R. McN. Alexander, A. S. Jayes (1983).</remarks>
public sealed class SpeedCriterion : ICriterion
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
