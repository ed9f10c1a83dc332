using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Brings the end of a limb of two bones to a target, its middle towards a pole. Closed form; nothing is allocated.</summary>
/// <remarks>
/// <para>The middle joint turns about its hinge alone, so skin at the knee is bent and never wrung; the whole limb then turns so that knee and pole are on the same side. The end of the reach is
/// eased (see <see cref="Reach"/>). A target at the root, beyond reach or in line with the pole gives a pose too, and a status that says so.</para>
/// <para>Based on: the law of cosines; WeaverDev, "Bonehead" (2018); D. Holden, "Simple two joint IK" (2017); the frame of chord and hinge in place of both authors' world axes.</para>
/// </remarks>
public static class TwoBoneIk
{
    /// <summary>Solves on points alone.</summary>
    /// <param name="root">Hip, metres.</param>
    /// <param name="middle">Knee, metres.</param>
    /// <param name="end">Ankle, metres.</param>
    /// <param name="hinge">Unit axis about which the lower bone turns as the limb folds.</param>
    /// <param name="target">Where the end has to be, metres.</param>
    /// <param name="pole">Direction in which the middle points, of any length; its part along root to target does not matter. In line with the target, the plane of the bend stays as near as it can to where it is.</param>
    /// <param name="reach">How far the limb stretches and folds.</param>
    /// <param name="upperTurn">Turns the upper bone: its new model rotation is this times the old.</param>
    /// <param name="lowerTurn">Turns the lower bone likewise.</param>
    /// <exception cref="ArgumentException">A number is not finite, the hinge is not unit, or a bone has no length across it.</exception>
    /// <remarks>Written out where it is called, which takes a third off the time: vectors that are handed over by value are put together by way of memory.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static IkResult Solve(Vector3 root, Vector3 middle, Vector3 end, Vector3 hinge, Vector3 target, Vector3 pole, in Reach reach, out Quaternion upperTurn, out Quaternion lowerTurn)
    {
        if (!Finite.Is((root - root) + (middle - middle) + (end - end) + (target - target) + (pole - pole)))
        {
            Refuse(root, middle, end, target, pole);
        }

        Finite.RequireUnit(hinge, nameof(hinge));
        Vector3 along = target - root;
        Vector3 side = Vec.Cross(pole, along);
        if (Vec.LengthSquared(side) <= 1e-8f * Vec.LengthSquared(pole) * Vec.LengthSquared(along))
        {
            side = hinge;
        }

        return HingedLimb.Solve(middle - root, end - middle, hinge, along, side, reach, out upperTurn, out lowerTurn);
    }

    /// <summary>Poses a limb of a skeleton.</summary>
    /// <param name="skeleton">Gives the parents; the hinge of the middle joint is read from its limits (<see cref="HingeAxis"/>), of one that turns any way from its bend.</param>
    /// <param name="upper">Hip or shoulder.</param>
    /// <param name="lower">Knee or elbow, somewhere below <paramref name="upper"/>.</param>
    /// <param name="end">Ankle or wrist, or any joint that hangs rigidly below <paramref name="lower"/>.</param>
    /// <param name="target">Where the end has to be, model space, metres.</param>
    /// <param name="pole">Direction in which the middle points, model space.</param>
    /// <param name="reach">How far the limb stretches and folds.</param>
    /// <param name="weight">0 leaves the pose, 1 solves; between them both bones turn part of the way.</param>
    /// <param name="local">Pose in the parents' space; upper and lower joint are turned.</param>
    /// <param name="model">The same in model space; brought up to date from the upper joint outwards. The end keeps its rotation relative to the lower bone.</param>
    /// <exception cref="ArgumentException">The joints are not a limb, a pose is not as long as the skeleton, or a number is not finite.</exception>
    public static IkResult Apply(Skeleton skeleton, int upper, int lower, int end, Vector3 target, Vector3 pole, in Reach reach, float weight, in Pose local, in Pose model)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        JointRelations.Require(skeleton, upper, lower);
        JointRelations.Require(skeleton, lower, end);
        Finite.RequireWithin(weight, 0f, 1f, nameof(weight));
        Quaternion lowerModel = model.Rotations[lower];
        Vector3 hinge = HingeAxis.OfLimb(skeleton.Joints[lower], lowerModel, model.Positions[lower] - model.Positions[upper], model.Positions[end] - model.Positions[lower], pole);
        IkResult result = Solve(model.Positions[upper], model.Positions[lower], model.Positions[end], hinge, target, pole, reach, out Quaternion upperTurn, out Quaternion lowerTurn);
        if (weight == 0f)
        {
            return result;
        }

        ReadOnlySpan<int> parents = skeleton.Parents;
        Quaternion upperModel = Rotation.Multiply(upperTurn, model.Rotations[upper]);
        Quaternion carrier = parents[lower] == upper ? upperModel : Rotation.Multiply(upperTurn, model.Rotations[parents[lower]]);
        Quaternion upperLocal = Rotation.Multiply(JointRelations.ParentInverse(skeleton, upper, model), upperModel);
        Quaternion lowerLocal = Rotation.Multiply(Rotation.Inverse(carrier), Rotation.Multiply(lowerTurn, lowerModel));
        local.Rotations[upper] = weight == 1f ? Rotation.Normalize(upperLocal) : Rotation.Slerp(local.Rotations[upper], upperLocal, weight);
        local.Rotations[lower] = weight == 1f ? Rotation.Normalize(lowerLocal) : Rotation.Slerp(local.Rotations[lower], lowerLocal, weight);
        Subtree.LocalToModel(skeleton, upper, local, model);
        return result;
    }

    /// <summary>Says which of the places is none.</summary>
    private static void Refuse(Vector3 root, Vector3 middle, Vector3 end, Vector3 target, Vector3 pole)
    {
        Finite.Require(root, nameof(root));
        Finite.Require(middle, nameof(middle));
        Finite.Require(end, nameof(end));
        Finite.Require(target, nameof(target));
        Finite.Require(pole, nameof(pole));
    }
}
