using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Inspection;

/// <summary>Whether the skin follows the right joints.</summary>
internal static class WeightChecks
{
    /// <summary>Weights below this show nowhere.</summary>
    private const float Visible = 0.05f;

    public static void Check(Creature creature, ViolationList found)
    {
        CreatureMesh mesh = creature.Mesh;
        int[] limbs = LimbsOf(creature);
        for (int v = 0; v < mesh.Weights.Length; v++)
        {
            SkinWeights w = mesh.Weights[v];
            Vector4 p = w.Weights;
            int count = creature.Skeleton.Count;
            bool known = (uint)w.Joint0 < (uint)count && (uint)w.Joint1 < (uint)count && (uint)w.Joint2 < (uint)count && (uint)w.Joint3 < (uint)count;
            bool ordered = p.X >= p.Y && p.Y >= p.Z && p.Z >= p.W && p.W >= 0f;
            if (!known || !ordered || !(Math.Abs(p.X + p.Y + p.Z + p.W - 1f) <= Tolerance.WeightSum))
            {
                found.Add(CreatureInspection.Weights, $"vertex {v} has joints {w.Joint0}, {w.Joint1}, {w.Joint2}, {w.Joint3} with weights {p}; expected joints below {count} and descending weights that add up to one");
                return;
            }

            CheckReach(creature, limbs, v, w, found);
        }
    }

    /// <summary>Skin that belongs to one limb follows no joint of another.</summary>
    private static void CheckReach(Creature creature, int[] limbs, int vertex, SkinWeights w, ViolationList found)
    {
        int own = limbs[w.Joint0];
        if (own == 0 || w.Weights.X < 0.5f)
        {
            return;
        }

        Foreign(w.Joint1, w.Weights.Y);
        Foreign(w.Joint2, w.Weights.Z);
        Foreign(w.Joint3, w.Weights.W);

        void Foreign(int joint, float weight)
        {
            int other = limbs[joint];
            if (weight >= Visible && other != 0 && other != own && !IsRooted(creature, own, other))
            {
                IReadOnlyList<Joint> joints = creature.Skeleton.Joints;
                found.Add(CreatureInspection.WeightReach, $"vertex {vertex} at {creature.Mesh.Positions[vertex]} follows {joints[w.Joint0].Name} and with weight {weight} {joints[joint].Name}; expected joints of one limb");
            }
        }
    }

    /// <summary>Whether one is the half of a disc on which the other grows: there the disc is the body.</summary>
    private static bool IsRooted(Creature creature, int first, int second)
    {
        (int limb, int disc) = (Math.Min(first, second), Math.Max(first, second));
        return limb <= creature.Limbs.Count && creature.Limbs[limb - 1].Side != Side.Median && disc == DiscOf(creature, creature.Limbs[limb - 1].Side);
    }

    /// <summary>The number of a half of a disc, whose rows move one skin: beyond those of limbs.</summary>
    private static int DiscOf(Creature creature, Side side) => creature.Limbs.Count + (side == Side.Left ? 1 : 2);

    /// <summary>For each joint the limb whose free part it moves, counted from 1, or 0. Girdles belong to the body.</summary>
    private static int[] LimbsOf(Creature creature)
    {
        var limbs = new int[creature.Skeleton.Count];
        for (int i = 0; i < creature.Limbs.Count; i++)
        {
            LimbChain limb = creature.Limbs[i];
            int number = limb.Kind != LimbKind.Disc ? i + 1 : DiscOf(creature, limb.Side);
            foreach (int joint in limb.Joints)
            {
                if (creature.Skeleton.Joints[joint].Role != JointRole.Girdle)
                {
                    limbs[joint] = number;
                }
            }
        }

        return limbs;
    }
}
