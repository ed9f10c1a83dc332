using System;
using System.Collections.Generic;
using CreatureGen.Rigging;

namespace CreatureGen.Events;

/// <summary>The joints of a skeleton that a rule names.</summary>
internal static class RuleJoints
{
    /// <summary>Their numbers, ascending. Roles that a skeleton does not have are passed over.</summary>
    /// <exception cref="ArgumentException">A name fits no joint.</exception>
    public static int[] Of(Skeleton skeleton, AngularRule rule)
    {
        var joints = new SortedSet<int>();
        foreach (string name in rule.Joints)
        {
            int before = joints.Count;
            bool known = false;
            for (int i = 0; i < skeleton.Count; i++)
            {
                if (Fits(skeleton.Joints[i].Name, name))
                {
                    joints.Add(i);
                    known = true;
                }
            }

            if (!known)
            {
                throw new ArgumentException($"rule {rule.Name} names the joint \"{name}\"; expected names of the skeleton's joints, with * for any characters");
            }
        }

        foreach (JointRole role in rule.Roles)
        {
            for (int i = 0; i < skeleton.Count; i++)
            {
                if (skeleton.Joints[i].Role == role)
                {
                    joints.Add(i);
                }
            }
        }

        foreach (string name in rule.Excluded)
        {
            joints.RemoveWhere(i => Fits(skeleton.Joints[i].Name, name));
        }

        int[] found = new int[joints.Count];
        joints.CopyTo(found);
        return found;
    }

    private static bool Fits(string name, string pattern)
    {
        string[] parts = pattern.Split('*');
        if (parts.Length == 1)
        {
            return name == pattern;
        }

        string last = parts[parts.Length - 1];
        if (!name.StartsWith(parts[0], StringComparison.Ordinal) || !name.EndsWith(last, StringComparison.Ordinal) || name.Length < parts[0].Length + last.Length)
        {
            return false;
        }

        int at = parts[0].Length;
        for (int i = 1; i < parts.Length - 1; i++)
        {
            int found = name.IndexOf(parts[i], at, StringComparison.Ordinal);
            if (found < 0)
            {
                return false;
            }

            at = found + parts[i].Length;
        }

        return at <= name.Length - last.Length;
    }
}
