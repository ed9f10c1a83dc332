using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Events;

/// <summary>The line of a limb, from a joint to its end.</summary>
/// <param name="From">Joint that it begins at.</param>
/// <param name="To">Joint that it ends at; the same for the bone of a joint alone.</param>
internal readonly record struct SweepLine(int From, int To)
{
    /// <summary>The lines that a rule looks at.</summary>
    /// <param name="skeleton">In rest pose.</param>
    /// <param name="joints">Of the rule.</param>
    /// <param name="sweep">Of the rule.</param>
    public static SweepLine[] All(Skeleton skeleton, int[] joints, AngularSweep sweep)
    {
        float lowest = float.MaxValue;
        float highest = float.MinValue;
        foreach (Joint joint in skeleton.Joints)
        {
            lowest = Math.Min(lowest, joint.ModelPosition.Y);
            highest = Math.Max(highest, joint.ModelPosition.Y);
        }

        float max = lowest + (sweep.LowestPart * (highest - lowest));
        var lines = new List<SweepLine>();
        foreach (int joint in joints)
        {
            if (Of(skeleton, joint, sweep) is { } line && (sweep.LowestPart >= 1f || skeleton.Joints[line.To].ModelPosition.Y <= max))
            {
                lines.Add(line);
            }
        }

        return lines.ToArray();
    }

    /// <summary>The line of one joint; null for a joint that only goes on a chain, or begins one that goes over into something else.</summary>
    private static SweepLine? Of(Skeleton skeleton, int joint, AngularSweep sweep)
    {
        foreach (JointRole end in sweep.Ends)
        {
            if (end == JointRole.End)
            {
                int tip = Continues(skeleton, joint) ? joint : ChainEnd(skeleton, joint);
                return tip != joint && IsLast(skeleton, tip) ? new SweepLine(joint, tip) : null;
            }

            for (int i = joint + 1; i < skeleton.Count; i++)
            {
                if (skeleton.Joints[i].Role == end && HangsOn(skeleton, i, joint))
                {
                    return new SweepLine(joint, i);
                }
            }
        }

        return new SweepLine(joint, joint);
    }

    /// <summary>Where the line ends. A limb that folds comes nearer: a foot on the ground goes back evenly all the same.</summary>
    public SweepEnd End(Skeleton skeleton, in Pose model)
    {
        if (From == To)
        {
            Vector3 along = Rotation.Rotate(model.Rotations[From], skeleton.Joints[From].Along);
            return new SweepEnd(along, along);
        }

        float length = Math.Max(Vec.Distance(skeleton.ModelPositions[To], skeleton.ModelPositions[From]), Tolerance.DirectionLength);
        return new SweepEnd((model.Positions[To] - model.Positions[From]) / length, model.Positions[To] / length);
    }

    private static bool IsLast(Skeleton skeleton, int joint)
    {
        for (int i = joint + 1; i < skeleton.Count; i++)
        {
            if (skeleton.Parents[i] == joint)
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>Whether a joint goes on a chain of its role.</summary>
    private static bool Continues(Skeleton skeleton, int joint)
    {
        int parent = skeleton.Parents[joint];
        return parent >= 0 && skeleton.Joints[parent].Role == skeleton.Joints[joint].Role;
    }

    /// <summary>The end of the chain of joints of one role that begins with a joint: a joint of the role <see cref="JointRole.End"/>, or the last of them.</summary>
    private static int ChainEnd(Skeleton skeleton, int joint)
    {
        JointRole role = skeleton.Joints[joint].Role;
        int at = joint;
        for (int i = joint + 1; i < skeleton.Count; i++)
        {
            JointRole next = skeleton.Joints[i].Role;
            if (skeleton.Parents[i] == at && (next == role || next == JointRole.End))
            {
                at = i;
            }
        }

        return at;
    }

    private static bool HangsOn(Skeleton skeleton, int joint, int ancestor)
    {
        while (joint > ancestor)
        {
            joint = skeleton.Parents[joint];
        }

        return joint == ancestor;
    }
}
