using System.Numerics;

namespace CreatureGen.Motion;

/// <summary>How a foot is at a moment.</summary>
/// <param name="Phase">On the ground or in the air.</param>
/// <param name="Joint">Skeleton index of its ball.</param>
/// <param name="Place">On the ground under the ball where it stands, or where it is going, world space.</param>
/// <param name="Normal">Of the ground there, unit, world space.</param>
/// <param name="Progress">Of its stance or swing, 0..1.</param>
/// <param name="Load">About 1 in the middle of stance, 0 in the air.</param>
/// <param name="Stretch">Length that the leg needs, as part of its reach.</param>
/// <param name="Residual">By how much it misses its place, metres.</param>
public readonly record struct FootReport(FootPhase Phase, int Joint, Vector3 Place, Vector3 Normal, float Progress, float Load, float Stretch, float Residual);
