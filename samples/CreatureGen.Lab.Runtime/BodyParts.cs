using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Rigging;

namespace CreatureGen.Lab.Runtime;

/// <summary>Which part of the body a finger is on, as the page calls it.</summary>
internal static class BodyParts
{
    /// <summary>One word for each joint, as a list of JSON.</summary>
    public static string Of(Creature creature)
    {
        Skeleton skeleton = creature.Skeleton;
        var arms = new HashSet<int>(creature.Limbs.Where(limb => limb.Archetype is LimbArchetype.Arm or LimbArchetype.Raptorial).SelectMany(limb => limb.Joints));
        string[] parts = new string[skeleton.Count];
        for (int joint = 0; joint < parts.Length; joint++)
        {
            int parent = skeleton.Parents[joint];
            parts[joint] = arms.Contains(joint) ? "arm" : NameOf(skeleton.Joints[joint].Role) ?? (parent >= 0 ? parts[parent] : "trunk");
        }

        return "[" + string.Join(',', parts.Select(part => "\"" + part + "\"")) + "]";
    }

    private static string? NameOf(JointRole role) => role switch
    {
        JointRole.Neck => "neck",
        JointRole.Head => "head",
        JointRole.Jaw => "snout",
        JointRole.Eye or JointRole.Lid => "eye",
        JointRole.Tail => "tail",
        JointRole.Hip or JointRole.Knee or JointRole.Ankle or JointRole.Ball => "leg",
        JointRole.Wing or JointRole.Fin => "wing",
        JointRole.Ear or JointRole.Antenna => "ear",
        JointRole.End or JointRole.Other => null,
        _ => "trunk",
    };
}
