using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>What every joint of a <see cref="Skeleton"/> is proved to be before it becomes part of one.</summary>
internal static class JointProof
{
    /// <summary>Throws unless a joint agrees with itself, with its parent and with those before it.</summary>
    /// <param name="joint">The joint.</param>
    /// <param name="index">Its place in the list.</param>
    /// <param name="parent">Its parent, null for the root.</param>
    /// <param name="names">Names so far; takes its own.</param>
    public static void Require(Joint joint, int index, Joint? parent, HashSet<string> names)
    {
        _ = joint ?? throw new ArgumentException(FormattableString.Invariant($"joint {index} is null; expected a joint"), "joints");
        RequireTree(joint.Name, index, joint.Parent);
        if (!names.Add(joint.Name))
        {
            throw new ArgumentException($"joint name \"{joint.Name}\" is used twice; expected unique names", "joints");
        }

        RequirePlace(joint, "in its parent", joint.LocalPosition, joint.LocalRotation);
        RequirePlace(joint, "in the model", joint.ModelPosition, joint.ModelRotation);
        if (!(Math.Abs(Vec.Length(joint.Along) - 1f) <= Tolerance.UnitLength))
        {
            throw Error(joint, FormattableString.Invariant($"its bone points along {Text(joint.Along)}"), "a unit vector");
        }

        if (!(joint.Length >= 0f && joint.Length <= float.MaxValue))
        {
            throw Error(joint, FormattableString.Invariant($"its length is {joint.Length}"), "a finite number not below 0");
        }

        _ = joint.Limit ?? throw Error(joint, "it has no limit", "JointLimit.Free at least");
        RequireRange(joint, "swing about X", joint.Limit.SwingX);
        RequireRange(joint, "swing about Z", joint.Limit.SwingZ);
        RequireRange(joint, "twist", joint.Limit.Twist);
        RequireAgreement(joint, parent);
    }

    /// <summary>Throws unless a joint has a name and hangs on a joint before it.</summary>
    public static void RequireTree(string name, int index, int parent)
    {
        if (parent >= index || parent < -1 || (parent < 0) != (index == 0))
        {
            throw new ArgumentException(FormattableString.Invariant($"joint {index} ({name}) has parent {parent}; expected a joint before it, or −1 for joint 0 alone"), "joints");
        }

        if (string.IsNullOrEmpty(name))
        {
            throw new ArgumentException(FormattableString.Invariant($"joint {index} has no name; expected unique names"), "joints");
        }

        for (int i = 0; i < name.Length; i++)
        {
            bool pair = char.IsHighSurrogate(name[i]) && i + 1 < name.Length && char.IsLowSurrogate(name[i + 1]);
            if (char.IsControl(name[i]) || (char.IsSurrogate(name[i]) && !pair))
            {
                throw new ArgumentException(FormattableString.Invariant($"joint {index} has U+{(int)name[i]:X4} in its name; expected text without control characters"), "joints");
            }

            i += pair ? 1 : 0;
        }
    }

    /// <summary>The rotation of a placement at unit length.</summary>
    public static Quaternion Unit(JointPlacement placement)
    {
        Quaternion q = placement.Rotation;
        double squared = ((double)q.X * q.X) + ((double)q.Y * q.Y) + ((double)q.Z * q.Z) + ((double)q.W * q.W);
        if (!(squared > 1e-12 && squared < 1e12))
        {
            throw new ArgumentException($"joint {placement.Name}: its rotation is {Text(q)}; expected finite numbers that are not all 0", "placements");
        }

        return Rotation.Normalize(q);
    }

    private static void RequirePlace(Joint joint, string where, Vector3 position, Quaternion rotation)
    {
        if (!Finite.Is(position))
        {
            throw Error(joint, $"its position {where} is {Text(position)}", "finite numbers");
        }

        float squared = (rotation.X * rotation.X) + (rotation.Y * rotation.Y) + (rotation.Z * rotation.Z) + (rotation.W * rotation.W);
        if (!(Math.Abs(squared - 1f) <= 2f * Tolerance.UnitLength))
        {
            throw Error(joint, $"its rotation {where} is {Text(rotation)}", "a unit quaternion");
        }
    }

    private static void RequireRange(Joint joint, string what, AngleRange range)
    {
        if (!(range.Min <= 0f && range.Max >= 0f && Finite.Is(range.Min) && Finite.Is(range.Max)))
        {
            throw Error(joint, $"its {what} is {range} radians", "a finite range that holds 0");
        }
    }

    private static void RequireAgreement(Joint joint, Joint? parent)
    {
        Vector3 position = joint.LocalPosition;
        Quaternion rotation = joint.LocalRotation;
        if (parent != null)
        {
            position = parent.ModelPosition + Rotation.Rotate(parent.ModelRotation, position);
            rotation = Rotation.Multiply(parent.ModelRotation, rotation);
        }

        float missed = Vec.Distance(position, joint.ModelPosition);
        Quaternion apart = Rotation.Multiply(Rotation.Inverse(rotation), joint.ModelRotation);
        float turned = 2f * Vec.Length(new Vector3(apart.X, apart.Y, apart.Z));
        if (!(missed <= Tolerance.RestPose * (1 + Vec.Length(joint.ModelPosition))) || !(turned <= Tolerance.RestPose))
        {
            throw Error(joint, FormattableString.Invariant($"its place in the model is {missed} m and {turned} rad from where its parent puts it"), "the same place");
        }
    }

    private static ArgumentException Error(Joint joint, string found, string expected) => new($"joint {joint.Name}: {found}; expected {expected}", "joints");

    private static string Text(Vector3 v) => FormattableString.Invariant($"({v.X}, {v.Y}, {v.Z})");

    private static string Text(Quaternion q) => FormattableString.Invariant($"({q.X}, {q.Y}, {q.Z}, {q.W})");
}
