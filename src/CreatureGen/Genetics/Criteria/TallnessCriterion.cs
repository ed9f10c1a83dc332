using System;
using CreatureGen.Rigging;

namespace CreatureGen.Genetics.Criteria;

/// <inheritdoc cref="CriterionCatalogue.Tall"/>
internal sealed class TallnessCriterion : ICriterion
{
    /// <inheritdoc/>
    public string Name => "tall";

    /// <inheritdoc/>
    public CriterionInput Input => CriterionInput.Creature;

    /// <inheritdoc/>
    public double Score(Candidate candidate)
    {
        _ = candidate ?? throw new ArgumentNullException(nameof(candidate));
        float highest = 0;
        foreach (Joint joint in candidate.Creature.Skeleton.Joints)
        {
            highest = joint.Role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Neck or JointRole.Head ? Math.Max(highest, joint.ModelPosition.Y) : highest;
        }

        return highest / candidate.Measures.Size;
    }
}
