using System;
using System.Numerics;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>How a flier was last posed on its legs, and its share in a pose in the air: of all joints but the wings.</summary>
internal sealed class StancePose
{
    /// <summary>Share from which on it counts as all.</summary>
    private const double Whole = 0.9995;

    private readonly Skeleton skeleton;
    private readonly Quaternion[] rotations;
    private readonly Vector3[] positions;
    private readonly float[] mask;

    public StancePose(Skeleton skeleton)
    {
        this.skeleton = skeleton;
        rotations = new Quaternion[skeleton.Count];
        positions = new Vector3[skeleton.Count];
        mask = new float[skeleton.Count];
        for (int i = 0; i < mask.Length; i++)
        {
            int parent = skeleton.Parents[i];
            bool end = skeleton.Joints[i].Role == JointRole.End && parent >= 0 && skeleton.Joints[parent].Role == JointRole.Wing;
            mask[i] = end || skeleton.Joints[i].Role == JointRole.Wing ? 0f : 1f;
        }

        Local.SetToRest(skeleton);
    }

    /// <summary>The pose in the parents' space.</summary>
    public Pose Local => new(rotations, positions);

    /// <summary>Whether a share is all of the pose.</summary>
    public static bool IsWhole(double fraction) => fraction >= Whole;

    /// <summary>Takes over how another was posed.</summary>
    public void CopyFrom(StancePose other)
    {
        other.rotations.CopyTo(rotations, 0);
        other.positions.CopyTo(positions, 0);
    }

    /// <summary>The pose, at rest, to be written anew.</summary>
    public Pose Cleared()
    {
        Local.SetToRest(skeleton);
        return Local;
    }

    /// <summary>Mixes the pose into another.</summary>
    /// <param name="fraction">0 leaves the other as it is, 1 all but its wings is replaced.</param>
    /// <param name="local">The other.</param>
    public void Mix(double fraction, in Pose local)
    {
        if (fraction <= 0)
        {
            return;
        }

        if (!IsWhole(fraction))
        {
            PoseBlend.Mix(local, Local, (float)fraction, mask, local);
            return;
        }

        for (int i = 0; i < mask.Length; i++)
        {
            if (mask[i] != 0f)
            {
                local.Rotations[i] = rotations[i];
                local.Positions[i] = positions[i];
            }
        }
    }
}
