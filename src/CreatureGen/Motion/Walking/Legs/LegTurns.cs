using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>Local rotations of the joints of a leg, from its hip to its ball.</summary>
internal struct LegTurns
{
    public Quaternion Hip;
    public Quaternion Knee;
    public Quaternion Ankle;
    public Quaternion Ball;

    /// <summary>Those of a pose.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static LegTurns Of(LegRig leg, in Pose local) => new()
    {
        Hip = local.Rotations[leg.Hip],
        Knee = local.Rotations[leg.Knee],
        Ankle = local.Rotations[leg.Ankle],
        Ball = local.Rotations[leg.Ball],
    };

    /// <summary>Cosine of half the angle by which that joint turns from these to others that turns farthest.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public readonly float CosineTo(in LegTurns other) => Math.Min(
        Math.Min(Math.Abs(SimdKernels.Dot(Hip, other.Hip)), Math.Abs(SimdKernels.Dot(Knee, other.Knee))),
        Math.Min(Math.Abs(SimdKernels.Dot(Ankle, other.Ankle)), Math.Abs(SimdKernels.Dot(Ball, other.Ball))));

    /// <summary>Writes what is part of the way from these to others, within the limits of the joints: on the straight way between two places within them there may be one that is not.</summary>
    /// <param name="other">The others.</param>
    /// <param name="fraction">Of the way, 0..1.</param>
    /// <param name="leg">Whose.</param>
    /// <param name="local">Receives them.</param>
    public readonly void WriteTowards(in LegTurns other, float fraction, LegRig leg, in Pose local)
    {
        local.Rotations[leg.Hip] = leg.Limits.Hip.Clamp(Rotation.Slerp(Hip, other.Hip, fraction));
        local.Rotations[leg.Knee] = Rotation.Slerp(Knee, other.Knee, fraction);
        local.Rotations[leg.Ankle] = leg.Limits.Ankle.Clamp(Rotation.Slerp(Ankle, other.Ankle, fraction));
        local.Rotations[leg.Ball] = leg.Limits.Ball.Clamp(Rotation.Slerp(Ball, other.Ball, fraction));
    }
}
