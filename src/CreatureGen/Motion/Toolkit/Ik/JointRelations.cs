using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>What solvers ask of a skeleton.</summary>
internal static class JointRelations
{
    /// <summary>Throws unless one joint lies below another.</summary>
    public static void Require(Skeleton skeleton, int above, int below)
    {
        ReadOnlySpan<int> parents = skeleton.Parents;
        if ((uint)above < (uint)parents.Length && (uint)below < (uint)parents.Length)
        {
            int joint = parents[below];
            while (joint > above)
            {
                joint = parents[joint];
            }

            if (joint == above)
            {
                return;
            }
        }

        throw new ArgumentException(FormattableString.Invariant($"joint {below} does not hang on joint {above}; expected joints of one limb, root first"));
    }

    /// <summary>Where the chains of a role begin, for example both ears: every joint of the role whose parent has another role, in the skeleton's order.</summary>
    public static int[] RootsOf(Skeleton skeleton, JointRole role)
    {
        var roots = new List<int>();
        for (int i = 0; i < skeleton.Count; i++)
        {
            int parent = skeleton.Parents[i];
            if (skeleton.Joints[i].Role == role && (parent < 0 || skeleton.Joints[parent].Role != role))
            {
                roots.Add(i);
            }
        }

        return roots.ToArray();
    }

    /// <summary>What takes model space to the space of a joint's parent.</summary>
    public static Quaternion ParentInverse(Skeleton skeleton, int joint, in Pose model)
    {
        int parent = skeleton.Parents[joint];
        return parent < 0 ? Quaternion.Identity : Rotation.Inverse(model.Rotations[parent]);
    }
}
