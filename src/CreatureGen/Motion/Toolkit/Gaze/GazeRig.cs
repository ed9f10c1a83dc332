using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>The joints that turn when a creature looks at something: neck, head, eyes, and how much of the turn each takes. Immutable.</summary>
public sealed class GazeRig
{
    // A head with a neck takes this much of a turn, the neck's bones the rest in equal parts: looks are led by the head.
    private const float HeadFraction = 0.45f;

    private readonly int[] joints;
    private readonly float[] taken;

    /// <summary>Chooses the joints.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="joints">From the lowest that turns to the head; each the parent of the next. The parent of the first gives "ahead" and "up".</param>
    /// <param name="fractions">How much of the turn each takes; at least 0, with a positive sum.</param>
    /// <exception cref="ArgumentException">The joints are not a chain below a parent, or the shares are not as many or not as they should be.</exception>
    public GazeRig(Skeleton skeleton, ReadOnlySpan<int> joints, ReadOnlySpan<float> fractions)
    {
        if (joints.Length == 0 || fractions.Length != joints.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{joints.Length} joints and {fractions.Length} shares; expected one share for each of at least one joint"), nameof(fractions));
        }

        Skeleton = skeleton;
        this.joints = joints.ToArray();
        taken = new float[joints.Length];
        float sum = 0f;
        for (int i = 0; i < joints.Length; i++)
        {
            if ((uint)joints[i] >= (uint)skeleton.Count || skeleton.Parents[joints[i]] < 0 || (i > 0 && skeleton.Parents[joints[i]] != joints[i - 1]))
            {
                throw new ArgumentException(FormattableString.Invariant($"joints[{i}] = {joints[i]}; expected a chain of joints below a parent, lowest first"), nameof(joints));
            }

            Finite.RequireWithin(fractions[i], 0f, 1e6f, nameof(fractions));
            sum += fractions[i];
            taken[i] = sum;
        }

        if (!(sum > 0f))
        {
            throw new ArgumentException("shares add up to 0; expected a positive sum", nameof(fractions));
        }

        for (int i = 0; i < taken.Length; i++)
        {
            taken[i] = i == taken.Length - 1 ? 1f : taken[i] / sum;
        }

        Base = skeleton.Parents[joints[0]];
        Head = joints[joints.Length - 1];
        LeftEye = EyeOn(Side.Left);
        RightEye = EyeOn(Side.Right);
        BaseToModel = Rotation.Inverse(skeleton.ModelRotations[Base]);
        HeadToModel = Rotation.Inverse(skeleton.ModelRotations[Head]);
        Vector3 eyes = LeftEye >= 0 && RightEye >= 0 ? (skeleton.ModelPositions[LeftEye] + skeleton.ModelPositions[RightEye]) * 0.5f : skeleton.ModelPositions[Head];
        EyePoint = Rotation.Rotate(HeadToModel, eyes - skeleton.ModelPositions[Head]);
    }

    /// <summary>Of these joints.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>The joints that turn, lowest first.</summary>
    public ReadOnlySpan<int> Joints => joints;

    /// <summary>The joint that carries them.</summary>
    public int Base { get; }

    /// <summary>The last of them.</summary>
    public int Head { get; }

    /// <summary>The left eye's joint, −1 without.</summary>
    public int LeftEye { get; }

    /// <summary>The right eye's joint, −1 without.</summary>
    public int RightEye { get; }

    /// <summary>Between the eyes, in the head's space, metres.</summary>
    internal Vector3 EyePoint { get; }

    /// <summary>What undoes the base's rest rotation: with it the base's frame faces +Z at rest.</summary>
    internal Quaternion BaseToModel { get; }

    /// <summary>What undoes the head's rest rotation.</summary>
    internal Quaternion HeadToModel { get; }

    /// <summary>Share of the turn that each joint has together with those below it; 1 for the head.</summary>
    internal ReadOnlySpan<float> Taken => taken;

    /// <summary>Head and neck of a creature.</summary>
    /// <param name="skeleton">With a joint of the role <see cref="JointRole.Head"/>.</param>
    /// <exception cref="ArgumentException">There is no head, or nothing carries it.</exception>
    public static GazeRig Of(Skeleton skeleton) => Of(skeleton, skeleton.FirstOf(JointRole.Head));

    /// <summary>One of several heads, and its neck.</summary>
    internal static GazeRig Of(Skeleton skeleton, int head)
    {
        if (head < 0)
        {
            throw new ArgumentException("no joint is a head; expected one to look with", nameof(skeleton));
        }

        var chain = new List<int> { head };
        for (int joint = skeleton.Parents[head]; joint >= 0 && skeleton.Joints[joint].Role == JointRole.Neck; joint = skeleton.Parents[joint])
        {
            chain.Insert(0, joint);
        }

        float[] fractions = new float[chain.Count];
        for (int i = 0; i < fractions.Length; i++)
        {
            fractions[i] = i < fractions.Length - 1 ? (1f - HeadFraction) / (fractions.Length - 1) : HeadFraction;
        }

        return new GazeRig(skeleton, chain.ToArray(), fractions);
    }

    private int EyeOn(Side side)
    {
        for (int i = 0; i < Skeleton.Count; i++)
        {
            Joint joint = Skeleton.Joints[i];
            if (joint.Role == JointRole.Eye && joint.Side == side && joint.Parent == Head)
            {
                return i;
            }
        }

        return -1;
    }
}
