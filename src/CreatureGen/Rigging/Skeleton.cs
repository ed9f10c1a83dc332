using System;
using System.Collections.Generic;

namespace CreatureGen.Rigging;

/// <summary>The joints of a creature in rest pose, parents before children. The bind pose is the rest pose.</summary>
public sealed class Skeleton
{
    private readonly Joint[] joints;

    /// <summary>Takes the joints in order.</summary>
    /// <exception cref="ArgumentException">A parent does not precede its child, a name is empty, not plain ASCII or used twice, or there is no single root.</exception>
    public Skeleton(IReadOnlyList<Joint> joints)
    {
        this.joints = new List<Joint>(joints).ToArray();
        var names = new HashSet<string>(StringComparer.Ordinal);
        for (int i = 0; i < this.joints.Length; i++)
        {
            Joint joint = this.joints[i];
            if (joint.Parent >= i || (joint.Parent < 0) != (i == 0))
            {
                throw new ArgumentException($"joint {FormattableString.Invariant($"{i}")} ({joint.Name}) has parent {FormattableString.Invariant($"{joint.Parent}")}; expected a joint before it, or −1 for joint 0 alone", nameof(joints));
            }

            foreach (char c in joint.Name)
            {
                if (!(c is (>= 'A' and <= 'Z') or (>= 'a' and <= 'z') or (>= '0' and <= '9') or '_'))
                {
                    throw new ArgumentException($"joint name \"{joint.Name}\"; expected letters, digits and underscores", nameof(joints));
                }
            }

            if (joint.Name.Length == 0 || !names.Add(joint.Name))
            {
                throw new ArgumentException($"joint name \"{joint.Name}\" is empty or used twice; expected unique names", nameof(joints));
            }
        }
    }

    /// <summary>All joints, parents before children.</summary>
    public IReadOnlyList<Joint> Joints => joints;

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
}
