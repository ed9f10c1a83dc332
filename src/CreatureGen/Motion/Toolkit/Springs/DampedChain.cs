using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;
using CreatureGen.Motion.Toolkit.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>
/// The simpler sibling of <see cref="SpringBones"/>: every joint of a chain turns after the one before it with a lag, without swinging. A turn of the first joint runs down the chain as a wave. Nothing is allocated.
/// </summary>
/// <remarks>
/// In world space each joint approaches the rotation that its parent, as it is now, and the animated pose give it: exponentially at a rate, and never more than an angle behind.
/// Based on: Christo, "Procedural creature generation and animation for games" (2022), damped transforms along the spine.
/// </remarks>
public static class DampedChain
{
    /// <summary>Notes the rotations of the joints as they are, so that the next update starts without a lag.</summary>
    /// <param name="joints">The chain, parents first.</param>
    /// <param name="root">Where the creature is.</param>
    /// <param name="model">The animated pose in model space.</param>
    /// <param name="remembered">Receives one world rotation per joint of the chain.</param>
    /// <exception cref="ArgumentException">There are not as many rotations as joints.</exception>
    public static void Reset(ReadOnlySpan<int> joints, in RootPlace root, in Pose model, Span<Quaternion> remembered)
    {
        root.Require(nameof(root));
        Require(joints, remembered.Length);
        for (int i = 0; i < joints.Length; i++)
        {
            remembered[i] = Rotation.Multiply(root.Rotation, model.Rotations[joints[i]]);
        }
    }

    /// <summary>Lets time pass and poses the joints.</summary>
    /// <param name="skeleton">Gives the parents.</param>
    /// <param name="joints">The chain, parents first.</param>
    /// <param name="rate">s⁻¹, from the first to the last joint; the lag of each is about 1/rate seconds.</param>
    /// <param name="max">Radians that a joint may be behind, 0..π.</param>
    /// <param name="root">Where the creature is now.</param>
    /// <param name="seconds">Time since the last call.</param>
    /// <param name="remembered">One world rotation per joint, from <see cref="Reset"/> or the last call.</param>
    /// <param name="local">The animated pose in the parents' space; the joints are turned.</param>
    /// <param name="model">The same in model space; brought up to date from the first joint outwards.</param>
    /// <exception cref="ArgumentException">A pose is not as long as the skeleton, there are not as many rotations as joints, or a number is not finite.</exception>
    public static void Update(Skeleton skeleton, ReadOnlySpan<int> joints, ChainCurve rate, float max, in RootPlace root, float seconds, Span<Quaternion> remembered, in Pose local, in Pose model)
    {
        local.Require(skeleton);
        model.Require(skeleton);
        root.Require(nameof(root));
        Finite.RequireStep(seconds);
        Finite.RequireWithin(max, 0f, 3.1416f, nameof(max));
        Require(joints, remembered.Length);
        if (joints.Length == 0)
        {
            return;
        }

        Quaternion toModel = Rotation.Inverse(root.Rotation);
        for (int i = 0; i < joints.Length; i++)
        {
            int joint = joints[i];
            if (i > 0 && skeleton.Parents[joint] != joints[i - 1])
            {
                throw new ArgumentException(FormattableString.Invariant($"joints[{i}] = {joint}; expected a child of joints[{i - 1}] = {joints[i - 1]}"), nameof(joints));
            }

            float along = joints.Length > 1 ? (float)i / (joints.Length - 1) : 0f;
            Quaternion parent = Rotation.Inverse(JointRelations.ParentInverse(skeleton, joint, model));
            Quaternion goal = Rotation.Multiply(root.Rotation, Rotation.Multiply(parent, local.Rotations[joint]));
            if (!Finite.Is(goal) || !Finite.Is(remembered[i]))
            {
                throw PoseCheck.NotFinite(joint);
            }

            Quaternion now = Damping.Approach(remembered[i], goal, Math.Max(rate.At(along), 0f), seconds);
            double behind = Rotation.Angle(Rotation.Multiply(Rotation.Inverse(goal), now));
            remembered[i] = behind > max ? Rotation.Slerp(goal, now, max / behind) : now;
            local.Rotations[joint] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(parent), Rotation.Multiply(toModel, remembered[i])));
            Subtree.Place(skeleton.Parents[joint], joint, local, model);
        }

        Subtree.LocalToModel(skeleton, joints[0], local, model);
    }

    private static void Require(ReadOnlySpan<int> joints, int rotations)
    {
        if (joints.Length != rotations)
        {
            throw new ArgumentException(FormattableString.Invariant($"{rotations} remembered rotations; expected one for each of {joints.Length} joints"));
        }
    }
}
