using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>The middle of a foot's sole: what stays where it is while a foot rolls about its ball.</summary>
internal static class SoleMiddle
{
    /// <summary>Its place, model space.</summary>
    /// <param name="leg">The foot's.</param>
    /// <param name="skeleton">At rest.</param>
    /// <param name="model">The pose.</param>
    public static Vector3 Of(LegRig leg, Skeleton skeleton, in Pose model)
    {
        Quaternion turn = Rotation.Multiply(model.Rotations[leg.Ball], Rotation.Inverse(skeleton.ModelRotations[leg.Ball]));
        return model.Positions[leg.Ball] + Rotation.Rotate(turn, leg.SoleMiddle - new Vector3(0f, leg.BallHeight, 0f));
    }
}
