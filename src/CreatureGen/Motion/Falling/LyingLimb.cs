using System;
using System.Collections.Generic;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A leg, an arm or a wing of a body on the ground: on its way to where it belongs it would go through the ground.</summary>
internal sealed class LyingLimb
{
    /// <summary>Number of joints of a limb at most; what is beyond them goes along.</summary>
    public const int MaxJoints = 8;

    private LyingLimb(int[] joints, float length, LimbYield yield)
    {
        Joints = joints;
        Length = length;
        Yield = yield;
    }

    /// <summary>From the trunk out: hip, knee and ankle, or what they are to an arm or a wing.</summary>
    public int[] Joints { get; }

    /// <summary>Metres.</summary>
    public float Length { get; }

    /// <summary>How it gives way to the ground.</summary>
    public LimbYield Yield { get; }

    /// <summary>Those of a creature: legs, then arms and wings.</summary>
    public static LyingLimb[] Of(MotionSubject subject, LyingLeg[] legs)
    {
        var limbs = new List<LyingLimb>();
        foreach (LyingLeg leg in legs)
        {
            limbs.Add(new LyingLimb([leg.Rig.Hip, leg.Rig.Knee, leg.Rig.Ankle], leg.Rig.Length, leg.Lateral ? LimbYield.Free : LimbYield.Under));
        }

        foreach (LimbChain chain in subject.Limbs)
        {
            bool arm = chain.Kind == LimbKind.Arm;
            if (arm || chain.Kind is LimbKind.Wing or LimbKind.InsectWing)
            {
                limbs.Add(Free(subject.Skeleton, chain.Joints, arm ? JointRole.Hip : JointRole.Wing, arm ? 3 : MaxJoints));
            }
        }

        return limbs.ToArray();
    }

    /// <summary>A limb on which nothing rests, from its first joint of a role on.</summary>
    private static LyingLimb Free(Skeleton skeleton, IReadOnlyList<int> chain, JointRole role, int most)
    {
        var joints = new List<int>();
        float length = 0f;
        foreach (int joint in chain)
        {
            if (joints.Count < most && (joints.Count > 0 || skeleton.Joints[joint].Role == role))
            {
                joints.Add(joint);
                length += skeleton.Joints[joint].Length;
            }
        }

        return new LyingLimb(joints.ToArray(), length, LimbYield.Free);
    }
}
