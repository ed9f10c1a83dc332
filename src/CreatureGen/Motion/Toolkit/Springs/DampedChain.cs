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
/// In world space each joint approaches the rotation that its parent and the animated pose give it: exponentially at a rate, and never more than an angle behind. Its goal moves while it does, evenly from where it was
/// to where it is now (<see cref="Damping.Follow(Vector3, Vector3, Vector3, float, float)"/>, in rotation vectors from the goal), so that the chain moves the same at all frame rates.
/// Based on: Christo, "Procedural creature generation and animation for games" (2022), damped transforms along the spine.
/// </remarks>
public static class DampedChain
{
    /// <summary>Notes the rotations of the joints as they are, so that the next update starts without a lag.</summary>
    /// <param name="joints">The chain, parents first.</param>
    /// <param name="root">Where the creature is.</param>
    /// <param name="model">The animated pose in model space.</param>
    /// <param name="remembered">Receives one world rotation per joint of the chain, and one more: that of the first joint's goal.</param>
    /// <exception cref="ArgumentException">There is not one rotation more than joints.</exception>
    public static void Reset(ReadOnlySpan<int> joints, in RootPlace root, in Pose model, Span<Quaternion> remembered)
    {
        root.Require(nameof(root));
        Require(joints, remembered.Length);
        for (int i = 0; i < joints.Length; i++)
        {
            remembered[i] = Rotation.Multiply(root.Rotation, model.Rotations[joints[i]]);
        }

        remembered[joints.Length] = joints.Length > 0 ? remembered[0] : Quaternion.Identity;
    }

    /// <summary>Lets time pass and poses the joints.</summary>
    /// <param name="skeleton">Gives the parents.</param>
    /// <param name="joints">The chain, parents first.</param>
    /// <param name="rate">s⁻¹, from the first to the last joint; the lag of each is about 1/rate seconds.</param>
    /// <param name="max">Radians that a joint may be behind, 0..π.</param>
    /// <param name="root">Where the creature is now.</param>
    /// <param name="seconds">Time since the last call.</param>
    /// <param name="remembered">One world rotation per joint and one more, from <see cref="Reset"/> or the last call.</param>
    /// <param name="local">The animated pose in the parents' space; the joints are turned.</param>
    /// <param name="model">The same in model space; brought up to date from the first joint outwards.</param>
    /// <exception cref="ArgumentException">A pose is not as long as the skeleton, there is not one rotation more than joints, or a number is not finite.</exception>
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
        Quaternion goalBefore = remembered[joints.Length];
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

            Quaternion now = Follow(remembered[i], goalBefore, goal, Math.Max(rate.At(along), 0f), seconds);
            if (i == 0)
            {
                remembered[joints.Length] = goal;
            }

            if (i + 1 < joints.Length)
            {
                // Where the next goal was: carried by this joint as it was.
                goalBefore = Rotation.Multiply(remembered[i], local.Rotations[joints[i + 1]]);
            }

            double behind = Rotation.AngleBetween(goal, now);
            remembered[i] = behind > max ? Rotation.Slerp(goal, now, max / behind) : now;
            local.Rotations[joint] = Rotation.Normalize(Rotation.Multiply(Rotation.Inverse(parent), Rotation.Multiply(toModel, remembered[i])));
            Subtree.Place(skeleton.Parents[joint], joint, local, model);
        }

        Subtree.LocalToModel(skeleton, joints[0], local, model);
    }

    /// <summary>A rotation that follows a goal which goes evenly from where it was to where it is.</summary>
    private static Quaternion Follow(Quaternion x, Quaternion goalBefore, Quaternion goal, float rate, float seconds)
    {
        Quaternion toGoal = Rotation.Inverse(goal);
        Vector3 was = Vector(Rotation.Multiply(toGoal, goalBefore));
        Vector3 left = Damping.Follow(Vector(Rotation.Multiply(toGoal, x)), was, Vector3.Zero, rate, seconds);
        float angle = Vec.Length(left);
        return angle > 1e-9f ? Rotation.Normalize(Rotation.Multiply(goal, Rotation.FromAxisAngle(left / angle, angle))) : goal;
    }

    /// <summary>Axis times angle of a rotation, the shorter way.</summary>
    private static Vector3 Vector(Quaternion q)
    {
        var axis = new Vector3(q.X, q.Y, q.Z) * (q.W < 0f ? -1f : 1f);
        float sine = Vec.Length(axis);
        return sine < 1e-9f ? axis * 2f : axis * (float)(2 * PortableMath.Atan2(sine, Math.Abs(q.W)) / sine);
    }

    private static void Require(ReadOnlySpan<int> joints, int rotations)
    {
        if (joints.Length + 1 != rotations)
        {
            throw new ArgumentException(FormattableString.Invariant($"{rotations} remembered rotations; expected one for each of {joints.Length} joints and one more"));
        }
    }
}
