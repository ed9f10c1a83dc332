using System;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>How a flier was last posed on its legs, and its share in a pose in the air: of all joints but the wings.</summary>
internal sealed class StancePose
{
    /// <summary>Share from which on it counts as all, and up to which it counts as none: it decays for minutes, and a mixture costs a flier a tenth of its update.</summary>
    private const double Whole = 0.9995;
    private const double None = 1 - Whole;

    private readonly LocalPose local;
    private readonly float[] mask;

    public StancePose(Skeleton skeleton)
    {
        local = new LocalPose(skeleton);
        mask = new float[skeleton.Count];
        for (int i = 0; i < mask.Length; i++)
        {
            int parent = skeleton.Parents[i];
            bool end = skeleton.Joints[i].Role == JointRole.End && parent >= 0 && skeleton.Joints[parent].Role == JointRole.Wing;
            mask[i] = end || skeleton.Joints[i].Role == JointRole.Wing ? 0f : 1f;
        }
    }

    /// <summary>Whether a share is all of the pose.</summary>
    public static bool IsWhole(double fraction) => fraction >= Whole;

    /// <summary>Takes over how another was posed.</summary>
    public void CopyFrom(StancePose other) => local.Take(other.local.Pose);

    /// <summary>Takes over a pose on its legs.</summary>
    public void Take(in Pose pose) => local.Take(pose);

    /// <summary>The pose, at rest, to be written anew.</summary>
    public Pose Cleared()
    {
        local.SetToRest();
        return local.Pose;
    }

    /// <summary>Mixes the pose into another.</summary>
    /// <param name="fraction">0 leaves the other as it is, 1 all but its wings is replaced.</param>
    /// <param name="other">In the parents' space.</param>
    public void Mix(double fraction, in Pose other)
    {
        if (fraction <= None)
        {
            return;
        }

        Pose own = local.Pose;
        if (!IsWhole(fraction))
        {
            PoseBlend.Mix(other, own, (float)fraction, mask, other);
            return;
        }

        for (int i = 0; i < mask.Length; i++)
        {
            if (mask[i] != 0f)
            {
                other.Rotations[i] = own.Rotations[i];
                other.Positions[i] = own.Positions[i];
            }
        }
    }
}
