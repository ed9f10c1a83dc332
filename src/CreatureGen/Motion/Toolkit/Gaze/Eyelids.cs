using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit;

/// <summary>The lids of a creature's eyes. Immutable.</summary>
public sealed class Eyelids
{
    private readonly int[] joints;
    private readonly float[] closing;

    private Eyelids(Skeleton skeleton, int[] joints)
    {
        Skeleton = skeleton;
        this.joints = joints;
        closing = new float[joints.Length];
        for (int i = 0; i < joints.Length; i++)
        {
            // A lid opens a little further than at rest and shuts at the far end of its range.
            AngleRange range = skeleton.Joints[joints[i]].Limit.SwingX;
            closing[i] = range.Max > -range.Min ? range.Max : range.Min;
        }
    }

    /// <summary>Of these joints.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>The lids' joints.</summary>
    public ReadOnlySpan<int> Joints => joints;

    /// <summary>The lids of a skeleton; null when it has none.</summary>
    /// <exception cref="ArgumentNullException">There is no skeleton.</exception>
    public static Eyelids? Of(Skeleton skeleton) => Of(skeleton, -1);

    /// <summary>The lids of a skeleton but for those of heads other than one, or all where that is −1; null when there are none.</summary>
    internal static Eyelids? Of(Skeleton skeleton, int head)
    {
        int[] found = new int[(skeleton ?? throw new ArgumentNullException(nameof(skeleton))).Count];
        int count = 0;
        for (int i = 0; i < skeleton.Count; i++)
        {
            if (skeleton.Joints[i].Role == JointRole.Lid && (head < 0 || !Heads.IsOfAnother(skeleton, i, head)))
            {
                found[count++] = i;
            }
        }

        return count == 0 ? null : new Eyelids(skeleton, found.AsSpan(0, count).ToArray());
    }

    /// <summary>Poses all lids. Nothing is allocated.</summary>
    /// <param name="shut">0 as at rest, 1 shut; below 0 open wider, for surprise. What joints' limits do not allow is not done.</param>
    /// <param name="local">Pose in the parents' space; the lids are turned.</param>
    /// <param name="model">The same in model space, up to date but for the lids, which are brought up to date.</param>
    /// <exception cref="ArgumentException">A pose is not as long as the skeleton, or the share is not finite.</exception>
    public void Close(float shut, in Pose local, in Pose model)
    {
        local.Require(Skeleton);
        model.Require(Skeleton);
        Finite.Require(shut, nameof(shut));
        for (int i = 0; i < joints.Length; i++)
        {
            Joint joint = Skeleton.AllJoints[joints[i]];
            float turn = joint.Limit.SwingX.Clamp(shut * closing[i]);
            local.Rotations[joints[i]] = Rotation.Multiply(joint.LocalRotation, Rotation.FromAxisAngle(Vector3.UnitX, turn));
            Subtree.LocalToModel(Skeleton, joints[i], local, model);
        }
    }
}
