using System;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>How much oftener or more rarely than usual a body plan is drawn.</summary>
/// <param name="Plan">The plan.</param>
/// <param name="Weight">Factor on its usual frequency, 0..1000; 0 excludes it.</param>
public sealed record BodyPlanWeight(BodyPlan Plan, double Weight)
{
    /// <summary>Weights for <see cref="CreatureOptions.BodyPlans"/> that leave only some plans: 1 for each of them, 0 for all others.</summary>
    /// <param name="plans">Those that are wanted.</param>
    /// <exception cref="ArgumentException">There are none.</exception>
    /// <exception cref="ArgumentNullException">There is no array.</exception>
    public static ValueList<BodyPlanWeight> Only(params BodyPlan[] plans)
    {
        if (plans is null)
        {
            throw new ArgumentNullException(nameof(plans));
        }

        if (plans.Length == 0)
        {
            throw new ArgumentException("no body plans; expected at least one", nameof(plans));
        }

        var weights = new BodyPlanWeight[AnatomyChoices.Plan.Count];
        for (int i = 0; i < weights.Length; i++)
        {
            var plan = (BodyPlan)i;
            weights[i] = new BodyPlanWeight(plan, Array.IndexOf(plans, plan) >= 0 ? 1 : 0);
        }

        return new ValueList<BodyPlanWeight>(weights);
    }

    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, OptionsFields.PlanWeight);
}
