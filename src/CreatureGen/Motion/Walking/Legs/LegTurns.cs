using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>Local rotations of the joints of a leg, from its hip to its ball.</summary>
internal struct LegTurns
{
    private Quaternion hip;
    private Quaternion knee;
    private Quaternion ankle;
    private Quaternion ball;

    /// <summary>Those of a pose.</summary>
    public static LegTurns Of(LegRig leg, in Pose local) => new()
    {
        hip = local.Rotations[leg.Hip],
        knee = local.Rotations[leg.Knee],
        ankle = local.Rotations[leg.Ankle],
        ball = local.Rotations[leg.Ball],
    };

    /// <summary>Cosine of half the angle by which that joint turns from these to others that turns farthest.</summary>
    public readonly float CosineTo(in LegTurns other) => Math.Min(
        Math.Min(Math.Abs(SimdKernels.Dot(hip, other.hip)), Math.Abs(SimdKernels.Dot(knee, other.knee))),
        Math.Min(Math.Abs(SimdKernels.Dot(ankle, other.ankle)), Math.Abs(SimdKernels.Dot(ball, other.ball))));

    /// <summary>Writes what is part of the way from these to others, within the limits of the joints: on the straight way between two places within them there may be one that is not.</summary>
    /// <param name="other">The others.</param>
    /// <param name="fraction">Of the way, 0..1.</param>
    /// <param name="leg">Whose.</param>
    /// <param name="local">Receives them.</param>
    public readonly void WriteTowards(in LegTurns other, float fraction, LegRig leg, in Pose local)
    {
        local.Rotations[leg.Hip] = leg.Limits.Hip.Clamp(Rotation.Slerp(hip, other.hip, fraction));
        local.Rotations[leg.Knee] = Rotation.Slerp(knee, other.knee, fraction);
        local.Rotations[leg.Ankle] = leg.Limits.Ankle.Clamp(Rotation.Slerp(ankle, other.ankle, fraction));
        local.Rotations[leg.Ball] = leg.Limits.Ball.Clamp(Rotation.Slerp(ball, other.ball, fraction));
    }
}
