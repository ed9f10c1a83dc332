using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>A foot of claws, which turns along as its leg is swept by no more than its ankle does not twist: the rest of the turn would drag its claws about the middle of the sole.</summary>
internal static class FollowingFoot
{
    /// <summary>Part of its range that an ankle twists before its foot begins to turn: on slopes and aside it needs the rest.</summary>
    private const float TwistFraction = 0.85f;

    /// <summary>How a foot is turned, model space.</summary>
    /// <param name="leg">Its leg.</param>
    /// <param name="planned">How it was set down.</param>
    /// <param name="place">Where it is, under the ball, model space; its height does not count.</param>
    public static Quaternion Heading(LegRig leg, Quaternion planned, Vector3 place)
    {
        Quaternion swept = leg.Sweep(place);
        Quaternion between = Rotation.Multiply(Rotation.Inverse(planned), swept);
        float turn = 2f * FastTrigonometry.Of(Math.Abs(between.Y), Math.Abs(between.W));
        float free = TwistFraction * leg.Limits.AnkleTwist;
        return turn > free ? UnitRotation.Nlerp(planned, swept, (turn - free) / turn) : planned;
    }
}
