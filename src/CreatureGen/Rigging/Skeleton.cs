using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>The joints of a creature, grown or from elsewhere, in rest pose, parents before children. The bind pose is the rest pose.</summary>
/// <remarks>The spans are the same numbers as in <see cref="Joints"/>, one array per field with one entry per joint: the form that per-frame code reads.</remarks>
public sealed class Skeleton
{
    private readonly Joint[] joints;
    private readonly int[] parents;
    private readonly int[] mirrors;
    private readonly int[] last;
    private readonly int[] outwards;
    private readonly Quaternion[] localRotations;
    private readonly Vector3[] localPositions;
    private readonly Quaternion[] modelRotations;
    private readonly Vector3[] modelPositions;

    /// <summary>Takes the joints in order.</summary>
    /// <exception cref="ArgumentNullException">There is no list.</exception>
    /// <exception cref="ArgumentException">
    /// There is no joint, there are several roots, a parent does not precede its child, a name is empty or used twice, a number is not finite, a rotation or a direction is not of unit length,
    /// a length is negative, a range of angles does not hold 0, or the place in the model is not the place that the parent gives.
    /// </exception>
    public Skeleton(IReadOnlyList<Joint> joints)
    {
        this.joints = new List<Joint>(joints ?? throw new ArgumentNullException(nameof(joints))).ToArray();
        if (this.joints.Length == 0)
        {
            throw new ArgumentException("a skeleton of no joints; expected one at least", nameof(joints));
        }

        int count = this.joints.Length;
        parents = new int[count];
        mirrors = new int[count];
        last = new int[count];
        localRotations = new Quaternion[count];
        localPositions = new Vector3[count];
        modelRotations = new Quaternion[count];
        modelPositions = new Vector3[count];
        var names = new HashSet<string>(StringComparer.Ordinal);
        for (int i = 0; i < count; i++)
        {
            Joint joint = this.joints[i];
            JointProof.Require(joint, i, joint.Parent >= 0 && joint.Parent < i ? this.joints[joint.Parent] : null, names);
            parents[i] = joint.Parent;
            mirrors[i] = i;
            last[i] = i;
            localRotations[i] = joint.LocalRotation;
            localPositions[i] = joint.LocalPosition;
            modelRotations[i] = joint.ModelRotation;
            modelPositions[i] = joint.ModelPosition;
        }

        for (int i = count - 1; i > 0; i--)
        {
            last[parents[i]] = Math.Max(last[parents[i]], last[i]);
        }

        outwards = OutwardOrder.Of(parents);
        FindMirrors();
    }

    /// <summary>All joints, parents before children.</summary>
    public IReadOnlyList<Joint> Joints => joints;

    /// <summary>Number of joints.</summary>
    public int Count => parents.Length;

    /// <summary>The parent of each joint; −1 for joint 0.</summary>
    public ReadOnlySpan<int> Parents => parents;

    /// <summary>The joint on the other side of the body: of <c>Leg_L1_Knee</c> it is <c>Leg_R1_Knee</c>. A joint without a counterpart is its own.</summary>
    public ReadOnlySpan<int> Mirrors => mirrors;

    /// <summary>Rest rotations in the parents' space.</summary>
    public ReadOnlySpan<Quaternion> LocalRotations => localRotations;

    /// <summary>Rest positions in the parents' space, metres.</summary>
    public ReadOnlySpan<Vector3> LocalPositions => localPositions;

    /// <summary>Rest rotations in model space.</summary>
    public ReadOnlySpan<Quaternion> ModelRotations => modelRotations;

    /// <summary>Rest positions in model space, metres.</summary>
    public ReadOnlySpan<Vector3> ModelPositions => modelPositions;

    /// <summary>The joints as <see cref="Joints"/> has them, without a call for each.</summary>
    internal ReadOnlySpan<Joint> AllJoints => joints;

    /// <summary>All joints in <see cref="OutwardOrder"/>.</summary>
    internal ReadOnlySpan<int> Outwards => outwards;

    /// <summary>The last joint that hangs on each, itself if none does.</summary>
    internal ReadOnlySpan<int> LastBelow => last;

    /// <summary>
    /// A skeleton from local transforms alone, as other programs give them: places in model space, lengths and directions of bones are worked out, and what joints are that do not say it,
    /// from their names (<see cref="JointNames"/>) and from how they hang on one another.
    /// </summary>
    /// <param name="placements">Parents before children.</param>
    /// <exception cref="ArgumentNullException">There is no list, or no joint in it.</exception>
    /// <exception cref="ArgumentException">They are no tree, a name is empty or used twice, a number is not finite, or a rotation is zero.</exception>
    public static Skeleton Build(IReadOnlyList<JointPlacement> placements)
    {
        int count = (placements ?? throw new ArgumentNullException(nameof(placements))).Count;
        int[] parents = new int[count];
        var localRotations = new Quaternion[count];
        var localPositions = new Vector3[count];
        for (int i = 0; i < count; i++)
        {
            JointPlacement placement = placements[i] ?? throw new ArgumentNullException(FormattableString.Invariant($"placements[{i}]"));
            JointProof.RequireTree(placement.Name, i, placement.Parent);
            parents[i] = placement.Parent;
            localRotations[i] = JointProof.Unit(placement);
            localPositions[i] = placement.Position;
        }

        var modelRotations = new Quaternion[count];
        var modelPositions = new Vector3[count];
        ForwardKinematics.Chain(OutwardOrder.Of(parents), parents, localRotations, localPositions, modelRotations, modelPositions);
        int[] main = MainChildren.Find(parents, modelPositions);
        JointRole[] roles = placements.Select(one => one.Role).ToArray();
        Side[] sides = placements.Select(one => one.Side).ToArray();
        JointRoles.Tell(placements.Select(one => one.Name).ToArray(), parents, modelPositions, roles, sides);
        var joints = new Joint[count];
        for (int i = 0; i < count; i++)
        {
            Vector3 onward = main[i] >= 0 ? localPositions[main[i]] : Rotation.Rotate(Rotation.Inverse(localRotations[i]), localPositions[i]);
            float length = main[i] >= 0 ? Vec.Length(onward) : 0f;
            Vector3 along = Vec.Normalize(onward, Vector3.UnitY);
            JointPlacement placement = placements[i];
            joints[i] = new Joint(placement.Name, roles[i], sides[i], placement.Parent, localPositions[i], localRotations[i], modelPositions[i], modelRotations[i], length, placement.Limit)
            {
                Along = along,
            };
        }

        return new Skeleton(joints);
    }

    /// <summary>The index of the joint with the given name, or −1.</summary>
    public int IndexOf(string name)
    {
        for (int i = 0; i < joints.Length; i++)
        {
            if (string.Equals(joints[i].Name, name, StringComparison.Ordinal))
            {
                return i;
            }
        }

        return -1;
    }

    /// <summary>The first joint that is for something, the nearest to the root of those in a chain; −1 if there is none.</summary>
    public int FirstOf(JointRole role)
    {
        for (int i = 0; i < joints.Length; i++)
        {
            if (joints[i].Role == role)
            {
                return i;
            }
        }

        return -1;
    }

    /// <summary>Names of counterparts differ in the word for the side alone.</summary>
    private void FindMirrors()
    {
        for (int i = 0; i < joints.Length; i++)
        {
            for (int k = i + 1; joints[i].Side == Side.Left && k < joints.Length; k++)
            {
                if (joints[k].Side == Side.Right && SideNames.AreCounterparts(joints[i].Name, joints[k].Name))
                {
                    mirrors[i] = k;
                    mirrors[k] = i;
                    break;
                }
            }
        }
    }
}
