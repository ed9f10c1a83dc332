using CreatureGen.Anatomy;

namespace CreatureGen.Sampling;

/// <summary>What plans have in common.</summary>
internal static class PlanTraits
{
    /// <summary>Whether a body goes on four legs that stand under it.</summary>
    public static bool IsQuadruped(BodyPlan plan) => plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar;

    /// <summary>Whether a level body has its legs under it: as those of quadrupeds stand, with arms or without.</summary>
    public static bool IsAboveLegs(BodyPlan plan) => IsQuadruped(plan) || plan == BodyPlan.Centaur;
}
