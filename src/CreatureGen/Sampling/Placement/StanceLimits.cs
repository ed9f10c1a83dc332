using CreatureGen.Anatomy;

namespace CreatureGen.Sampling.Placement;

/// <summary>What a plan's anatomy allows when legs turn out too short or the creature unbalanced.</summary>
/// <param name="MinimumLength">Shortest leg, relative to the body's length.</param>
/// <param name="MaximumRaise">How far the body may be raised to give legs that length, relative to the body's length.</param>
/// <param name="RearwardShear">How far the feet may be set back, relative to the leg.</param>
/// <param name="ForwardShear">How far the feet may be set forward, relative to the leg.</param>
/// <param name="MaximumPitchDegrees">How far the torso may be pitched about the hips, either way, degrees.</param>
/// <param name="MaximumFootGrowth">Largest factor by which feet may be enlarged.</param>
/// <param name="LowerPlan">The plan for a body that lies too low for these legs.</param>
/// <param name="FewerPlan">The plan for a body without room for as many pairs.</param>
internal sealed record StanceLimits(
    double MinimumLength,
    double MaximumRaise,
    double RearwardShear,
    double ForwardShear,
    double MaximumPitchDegrees,
    double MaximumFootGrowth,
    BodyPlan LowerPlan,
    BodyPlan FewerPlan)
{
    /// <summary>By which part of the width of the feet's hull the centre of mass must lie inside it: more where the rules know the weight less well.</summary>
    public double BalanceMargin { get; init; } = Balance.MinMargin;
}
