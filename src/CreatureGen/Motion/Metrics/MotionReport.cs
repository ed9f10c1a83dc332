using CreatureGen.Motion.Metrics;

namespace CreatureGen.Motion.Metrics;

/// <summary>How well a motion keeps to what animals do: figures of a recording. Lengths are in leg lengths, so that creatures of all sizes compare. What does not apply is null: a fish has no feet that could slide.</summary>
/// <param name="Frames">Number of frames recorded.</param>
/// <param name="Seconds">Their time.</param>
/// <param name="LimitExcess">Most that a joint was beyond its limits, radians.</param>
/// <param name="LimitViolations">Number of joints in frames beyond their limits by more than 0.1°.</param>
/// <param name="WorstJoint">Skeleton index of the joint with <paramref name="LimitExcess"/>; −1 for none.</param>
/// <param name="FastestJoint">Greatest rate of turn of a joint relative to its parent, radians per second; what swings by itself (tail, ears, feelers) does not count.</param>
/// <param name="PoseJump">Greatest change of the whole pose from frame to frame, in medians of it.</param>
public sealed record MotionReport(int Frames, float Seconds, float LimitExcess, int LimitViolations, int WorstJoint, float FastestJoint, float PoseJump)
{
    /// <summary>Farthest that the flat sole of a standing foot drifted in one stance.</summary>
    public float? Slip { get; init; }

    /// <summary>Farthest that the place a flat standing foot is locked to was missed by the foot's ball. Feet that turn with their leg, of legs out to the side, do not count.</summary>
    public float? LockDrift { get; init; }

    /// <summary>Share of frames of standing feet, flat on the ground, that move faster than a tenth of the body's own speed.</summary>
    public float? SkatingFraction { get; init; }

    /// <summary>Deepest that any part of a foot was in the ground.</summary>
    public float? Penetration { get; init; }

    /// <summary>Mean over frames of standing feet of how deep they were.</summary>
    public float? MeanPenetration { get; init; }

    /// <summary>Highest that the lowest point of a flat standing foot was above the ground.</summary>
    public float? Float { get; init; }

    /// <summary>Least height of the lowest point of a foot in the middle of its swing.</summary>
    public float? Clearance { get; init; }

    /// <summary>Farthest that a standing leg fell short of its place.</summary>
    public float? StanceResidual { get; init; }

    /// <summary>Farthest that a swinging leg fell short of its place.</summary>
    public float? SwingResidual { get; init; }

    /// <summary>Share of frames of standing legs that were eased at the end of their reach.</summary>
    public float? StretchedFraction { get; init; }

    /// <summary>Least number of feet down.</summary>
    public int? MinSupport { get; init; }

    /// <summary>Mean number of feet down.</summary>
    public float? MeanSupport { get; init; }

    /// <summary>Rise and fall of the pelvis from its lowest to its highest.</summary>
    public float? Bob { get; init; }

    /// <summary>Deepest that two legs went into one another, by the capsules of their bones, beyond what the same bones do at rest.</summary>
    public float? LegOverlap { get; init; }

    /// <summary>Deepest that a leg went into the trunk from its knee downwards, by the capsules of their bones, beyond what the same bones do at rest.</summary>
    public float? BellyOverlap { get; init; }
}
