using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Chains;

/// <summary>The bones of the body's axis from the nose to the tip of the tail, wherever in it the skeleton has its root.</summary>
/// <remarks>
/// A motion says how every bone lies (a turn in the body's axes, the identity at rest); the chain writes the joints, and says where the body then is, so that the motion can put it
/// where it belongs: swimmers hang on their centre of mass, snakes on their track.
/// </remarks>
internal sealed class AxialChain
{
    private readonly AxialBone[] bones;
    private readonly int[] order;

    private AxialChain(AxialBone[] bones, int[] order, int body, Vector3 bodyPivot)
    {
        this.bones = bones;
        this.order = order;
        Body = body;
        BodyPivot = bodyPivot;
        Vector3 centre = Vector3.Zero;
        foreach (AxialBone bone in bones)
        {
            centre += bone.Middle * (float)bone.Mass;
        }

        Centre = centre;
        Nose = bones[0].Front;
        TailTip = bones[bones.Length - 1].Rear;
        Length = Nose.Z - TailTip.Z;
    }

    /// <summary>Nose to tail.</summary>
    public ReadOnlySpan<AxialBone> Bones => bones;

    public int Count => bones.Length;

    /// <summary>The joint of the body's root.</summary>
    public int Body { get; }

    /// <summary>The bone just before the body's root.</summary>
    public int BeforeRoot => order[0];

    /// <summary>The bone just behind it; the same where the root carries one bone only.</summary>
    public int BehindRoot => order[0] + 1 < bones.Length && bones[order[0] + 1].Parent < 0 ? order[0] + 1 : order[0];

    /// <summary>Where that is at rest.</summary>
    public Vector3 BodyPivot { get; }

    /// <summary>Centre of the axis' mass at rest.</summary>
    public Vector3 Centre { get; }

    public Vector3 Nose { get; }

    public Vector3 TailTip { get; }

    /// <summary>From the nose to the tip of the tail, metres.</summary>
    public double Length { get; }

    /// <summary>Finds the axis of a body.</summary>
    /// <param name="skeleton">With a body, a head and a tail.</param>
    /// <param name="capsules">Around its bones: they tell its masses.</param>
    /// <exception cref="ArgumentException">The skeleton has no body, head or tail.</exception>
    public static AxialChain Of(Skeleton skeleton, IReadOnlyList<CapsuleCollider> capsules)
    {
        int body = Require(skeleton, JointRole.Body);
        int head = Require(skeleton, JointRole.Head);
        int nose = EndOf(skeleton, role => role == JointRole.Head);
        int tail = EndOf(skeleton, role => role is JointRole.Tail or JointRole.Pelvis or JointRole.Spine);
        if (nose < 0 || tail < 0)
        {
            throw new ArgumentException("no end joint hangs on the head, or none on the tail or the trunk; expected both ends of the body", nameof(skeleton));
        }

        var joints = new List<int>();
        for (int j = head; j != body; j = skeleton.Parents[j])
        {
            joints.Add(j);
        }

        int forward = joints.Count;
        var behind = new List<int>();
        for (int j = skeleton.Parents[tail]; j != body && !joints.Contains(j); j = skeleton.Parents[j])
        {
            behind.Add(j);
        }

        behind.Reverse();
        joints.AddRange(behind);

        // The places where bones meet: in front of the root a bone begins at its own pivot, behind it it ends there.
        var points = new Vector3[joints.Count + 1];
        points[0] = skeleton.ModelPositions[nose];
        for (int b = 1; b < joints.Count; b++)
        {
            points[b] = skeleton.ModelPositions[joints[b < forward ? b - 1 : b]];
        }

        points[joints.Count] = skeleton.ModelPositions[tail];
        double[] masses = Masses(capsules, joints);
        var bones = new AxialBone[joints.Count];
        for (int b = 0; b < bones.Length; b++)
        {
            int joint = joints[b];
            bones[b] = new AxialBone(new JointRotation(skeleton, joint), joints.IndexOf(skeleton.Parents[joint]), skeleton.ModelPositions[joint], points[b], points[b + 1], masses[b]);
        }

        int[] order = new int[bones.Length];
        for (int k = 0; k < order.Length; k++)
        {
            order[k] = k < forward ? forward - 1 - k : k;
        }

        return new AxialChain(bones, order, body, skeleton.ModelPositions[body]);
    }

    /// <summary>Writes the joints of the axis and finds where its bones come to lie, seen from the body's root.</summary>
    /// <param name="local">Receives the rotations.</param>
    /// <param name="turns">How each bone lies in the body's axes; limits of joints may change them, and what is left is put back.</param>
    /// <param name="pivots">Receives where each bone's joint is, from the body's root, in the body's axes; one per bone.</param>
    public void Write(in Pose local, Span<Quaternion> turns, Span<Vector3> pivots)
    {
        foreach (int b in order)
        {
            ref readonly AxialBone bone = ref bones[b];
            if (bone.Parent < 0)
            {
                turns[b] = bone.Turn.Write(local, turns[b]);
                pivots[b] = bone.Pivot - BodyPivot;
                continue;
            }

            Quaternion parent = turns[bone.Parent];
            Quaternion own = bone.Turn.Write(local, Rotation.Multiply(Rotation.Inverse(parent), turns[b]));
            turns[b] = UnitRotation.Renormalize(Rotation.Multiply(parent, own));
            pivots[b] = pivots[bone.Parent] + Rotation.Rotate(parent, bone.Pivot - bones[bone.Parent].Pivot);
        }
    }

    /// <summary>The bone of a joint, −1 when it is none of the axis.</summary>
    public int IndexOf(int joint) => Array.FindIndex(bones, bone => bone.Turn.Joint == joint);

    /// <summary>The bone at a place along the body at rest: model space z, metres.</summary>
    public int BoneAt(float z)
    {
        int b = 0;
        while (b + 1 < bones.Length && bones[b].Rear.Z > z)
        {
            b++;
        }

        return b;
    }

    /// <summary>Where a point of the rest pose that moves with a bone comes to lie, from the body's root, in the body's axes.</summary>
    public Vector3 Carry(int bone, Vector3 rest, ReadOnlySpan<Quaternion> turns, ReadOnlySpan<Vector3> pivots) =>
        pivots[bone] + Rotation.Rotate(turns[bone], rest - bones[bone].Pivot);

    /// <summary>Where the centre of the axis' mass comes to lie, from the body's root, in the body's axes.</summary>
    public Vector3 CentreOf(ReadOnlySpan<Quaternion> turns, ReadOnlySpan<Vector3> pivots)
    {
        Vector3 sum = Vector3.Zero;
        for (int b = 0; b < bones.Length; b++)
        {
            sum += Carry(b, bones[b].Middle, turns, pivots) * (float)bones[b].Mass;
        }

        return sum;
    }

    /// <summary>Mass is taken as the volume of the capsules around the bones.</summary>
    private static double[] Masses(IReadOnlyList<CapsuleCollider> capsules, List<int> joints)
    {
        double[] masses = new double[joints.Count];
        double sum = 0;
        for (int b = 0; b < masses.Length; b++)
        {
            foreach (CapsuleCollider capsule in capsules)
            {
                if (capsule.Joint == joints[b])
                {
                    double r = capsule.Radius;
                    masses[b] += r * r * (Vec.Distance(capsule.Start, capsule.End) + (4.0 / 3.0 * r));
                }
            }

            sum += masses[b];
        }

        for (int b = 0; b < masses.Length; b++)
        {
            masses[b] = sum > 0 ? masses[b] / sum : 1.0 / masses.Length;
        }

        return masses;
    }

    /// <summary>The end, on the midline, of a chain whose last joint has one of some roles; −1 if there is none.</summary>
    private static int EndOf(Skeleton skeleton, Predicate<JointRole> carries)
    {
        for (int j = 1; j < skeleton.Count; j++)
        {
            if (skeleton.Joints[j].Role == JointRole.End && skeleton.Joints[j].Side == Side.Median && carries(skeleton.Joints[skeleton.Parents[j]].Role))
            {
                return j;
            }
        }

        return -1;
    }

    private static int Require(Skeleton skeleton, JointRole role)
    {
        int joint = skeleton.FirstOf(role);
        return joint >= 0 ? joint : throw new ArgumentException($"the skeleton has no joint of role {role}", nameof(skeleton));
    }
}
