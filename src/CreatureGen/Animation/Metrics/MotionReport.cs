namespace CreatureGen.Animation.Metrics;

/// <summary>How well a motion keeps to what animals do: figures of a recording. Lengths are in leg lengths, so that creatures of all sizes compare.</summary>
/// <param name="Frames">Number of frames recorded.</param>
/// <param name="Seconds">Their time.</param>
/// <param name="Slip">Farthest that the flat sole of a standing foot drifted in one stance.</param>
/// <param name="LockDrift">Farthest that the place a flat standing foot is locked to was missed by the foot's ball. Feet that turn with their leg, of legs out to the side, do not count.</param>
/// <param name="SkatingShare">Share of frames of standing feet, flat on the ground, that move faster than a tenth of the body's own speed.</param>
/// <param name="Penetration">Deepest that any part of a foot was in the ground.</param>
/// <param name="MeanPenetration">Mean over frames of standing feet of how deep they were.</param>
/// <param name="Float">Highest that the lowest point of a flat standing foot was above the ground.</param>
/// <param name="Clearance">Least height of the lowest point of a foot in the middle of its swing.</param>
/// <param name="LimitExcess">Most that a joint was beyond its limits, radians.</param>
/// <param name="LimitViolations">Number of joints in frames beyond their limits by more than 0.1°.</param>
/// <param name="WorstJoint">Skeleton index of the joint with <paramref name="LimitExcess"/>; −1 for none.</param>
/// <param name="StanceResidual">Farthest that a standing leg fell short of its place.</param>
/// <param name="SwingResidual">Farthest that a swinging leg fell short of its place.</param>
/// <param name="StretchedShare">Share of frames of standing legs that were eased at the end of their reach.</param>
/// <param name="FastestJoint">Greatest rate of turn of a joint relative to its parent, radians per second; what swings by itself (tail, ears, feelers) does not count.</param>
/// <param name="PoseJump">Greatest change of the whole pose from frame to frame, in medians of it.</param>
/// <param name="LeastSupport">Least number of feet down.</param>
/// <param name="MeanSupport">Mean number of feet down.</param>
/// <param name="Bob">Rise and fall of the pelvis from its lowest to its highest.</param>
public sealed record MotionReport(
    int Frames,
    float Seconds,
    float Slip,
    float LockDrift,
    float SkatingShare,
    float Penetration,
    float MeanPenetration,
    float Float,
    float Clearance,
    float LimitExcess,
    int LimitViolations,
    int WorstJoint,
    float StanceResidual,
    float SwingResidual,
    float StretchedShare,
    float FastestJoint,
    float PoseJump,
    int LeastSupport,
    float MeanSupport,
    float Bob);
