using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Sampling;

/// <summary>How much oftener or more rarely than usual a body plan is drawn.</summary>
/// <param name="Plan">The plan.</param>
/// <param name="Weight">Factor on its usual frequency, 0..1000; 0 excludes it.</param>
public sealed record BodyPlanWeight(BodyPlan Plan, double Weight)
{
    /// <summary>Its JSON text on one line, the same in every culture.</summary>
    public override string ToString() => RecordJson.LineOf(this, OptionsFields.PlanWeight);
}
