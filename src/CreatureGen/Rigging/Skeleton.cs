using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>The joints of a creature in rest pose, parents before children. The bind pose is the rest pose.</summary>
/// <remarks>The spans are the same numbers as in <see cref="Joints"/>, one array per field with one entry per joint: the form that per-frame code reads.</remarks>
public sealed class Skeleton
{
    private readonly Joint[] joints;
    private readonly int[] parents;
    private readonly int[] mirrors;
    private readonly int[] last;
    private readonly Quaternion[] localRotations;
    private readonly Vector3[] localPositions;
    private readonly Quaternion[] modelRotations;
    private readonly Vector3[] modelPositions;

    /// <summary>Takes the joints in order.</summary>
    /// <exception cref="ArgumentException">A parent does not precede its child, a name is empty, not plain ASCII or used twice, or there are several roots.</exception>
    public Skeleton(IReadOnlyList<Joint> joints)
    {
        this.joints = new List<Joint>(joints).ToArray();
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
            Prove(joint, i, names);
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

        FindMirrors();
    }

    /// <summary>All joints, parents before children.</summary>
    public IReadOnlyList<Joint> Joints => joints;

    /// <summary>Number of joints.</summary>
    public int Count => joints.Length;

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

    /// <summary>The last joint that hangs on each, itself if none does.</summary>
    internal ReadOnlySpan<int> LastBelow => last;

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

    private static void Prove(Joint joint, int index, HashSet<string> names)
    {
        if (joint.Parent >= index || (joint.Parent < 0) != (index == 0))
        {
            throw new ArgumentException(FormattableString.Invariant($"joint {index} ({joint.Name}) has parent {joint.Parent}; expected a joint before it, or −1 for joint 0 alone"), "joints");
        }

        foreach (char c in joint.Name)
        {
            if (!(c is (>= 'A' and <= 'Z') or (>= 'a' and <= 'z') or (>= '0' and <= '9') or '_'))
            {
                throw new ArgumentException($"joint name \"{joint.Name}\"; expected letters, digits and underscores", "joints");
            }
        }

        if (joint.Name.Length == 0 || !names.Add(joint.Name))
        {
            throw new ArgumentException($"joint name \"{joint.Name}\" is empty or used twice; expected unique names", "joints");
        }
    }

    /// <summary>Left and right names differ in one letter.</summary>
    private void FindMirrors()
    {
        for (int i = 0; i < joints.Length; i++)
        {
            for (int k = i + 1; joints[i].Side == Side.Left && k < joints.Length; k++)
            {
                if (joints[k].Side == Side.Right && AreCounterparts(joints[i].Name, joints[k].Name))
                {
                    mirrors[i] = k;
                    mirrors[k] = i;
                    break;
                }
            }
        }
    }

    private static bool AreCounterparts(string left, string right)
    {
        if (left.Length != right.Length)
        {
            return false;
        }

        int different = 0;
        for (int c = 0; c < left.Length; c++)
        {
            if (left[c] != right[c])
            {
                different++;
                if (left[c] != 'L' || right[c] != 'R')
                {
                    return false;
                }
            }
        }

        return different == 1;
    }
}
