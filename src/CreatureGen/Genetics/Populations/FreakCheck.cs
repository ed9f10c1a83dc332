using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Species;

namespace CreatureGen.Genetics.Populations;

/// <summary>Finds creatures that keep all promises and still are wrong to look at. They have no children.</summary>
public static class FreakCheck
{
    /// <summary>Radius of a head over that of the trunk.</summary>
    private const float LargestHead = 1.4f;

    /// <summary>Pairs of triangles of the skin that may cut one another: what folds hide.</summary>
    private const int MaxCuts = 20;

    /// <summary>How deep legs below their knees may be in one another, part of the thinner one's radius.</summary>
    private const float DeepestLeg = 0.9f;

    /// <summary>What does not fit together in a sound creature; empty for most.</summary>
    /// <exception cref="ArgumentNullException">There is no creature.</exception>
    public static IReadOnlyList<string> FaultsOf(Creature creature)
    {
        _ = creature ?? throw new ArgumentNullException(nameof(creature));
        var faults = new List<string>();
        CheckHead(creature, faults);
        CheckShell(creature.Blueprint, faults);
        CheckLegs(creature, faults);
        int cuts = CreatureInspection.CountSelfIntersections(creature);
        if (cuts > MaxCuts)
        {
            faults.Add(FormattableString.Invariant($"its skin cuts itself in {cuts} places"));
        }

        return faults;
    }

    private static void CheckHead(Creature creature, List<string> faults)
    {
        float head = 0, trunk = 0;
        foreach (CapsuleCollider capsule in creature.Bones)
        {
            JointRole role = creature.Skeleton.Joints[capsule.Joint].Role;
            head = role == JointRole.Head ? Math.Max(head, capsule.Radius) : head;
            trunk = role is JointRole.Pelvis or JointRole.Spine or JointRole.Chest or JointRole.Body or JointRole.Tail ? Math.Max(trunk, capsule.Radius) : trunk;
        }

        if (trunk > 0 && head > LargestHead * trunk)
        {
            faults.Add(FormattableString.Invariant($"its head is {head / trunk:0.0} times as thick as its trunk"));
        }
    }

    /// <summary>Cases for wings belong to insects.</summary>
    private static void CheckShell(CreatureBlueprint blueprint, List<string> faults)
    {
        if (blueprint.Body.Shell.Style == ShellStyle.Elytra && SpeciesCatalogue.Find(blueprint.Body.Blend.First).Class != AnimalClass.Arthropod)
        {
            faults.Add("it has the wing cases of a beetle and not its body");
        }
    }

    /// <summary>Legs on one side stand free of one another.</summary>
    private static void CheckLegs(Creature creature, List<string> faults)
    {
        List<(int Leg, Vector3 Start, Vector3 End, float Radius)> shins = ShinsOf(creature);
        float deepest = 0;
        for (int i = 0; i < shins.Count; i++)
        {
            for (int k = 0; k < i; k++)
            {
                if (shins[i].Leg != shins[k].Leg)
                {
                    float apart = (float)Math.Sqrt(SegmentDistance.Squared(shins[i].Start, shins[i].End, shins[k].Start, shins[k].End));
                    deepest = Math.Max(deepest, (shins[i].Radius + shins[k].Radius - apart) / Math.Min(shins[i].Radius, shins[k].Radius));
                }
            }
        }

        if (deepest > DeepestLeg)
        {
            faults.Add(FormattableString.Invariant($"its legs are {deepest:0.0} of a radius in one another"));
        }
    }

    /// <summary>The capsules of standing legs below their knees, in model space.</summary>
    private static List<(int Leg, Vector3 Start, Vector3 End, float Radius)> ShinsOf(Creature creature)
    {
        var shins = new List<(int, Vector3, Vector3, float)>();
        for (int leg = 0; leg < creature.Limbs.Count; leg++)
        {
            LimbChain limb = creature.Limbs[leg];
            foreach (CapsuleCollider capsule in creature.Bones)
            {
                if (limb.Kind == LimbKind.Leg && limb.Stands && (capsule.Joint == limb.Joints[2] || capsule.Joint == limb.Joints[3]))
                {
                    Joint joint = creature.Skeleton.Joints[capsule.Joint];
                    shins.Add((leg, Model(joint, capsule.Start), Model(joint, capsule.End), capsule.Radius));
                }
            }
        }

        return shins;
    }

    private static Vector3 Model(Joint joint, Vector3 local) => joint.ModelPosition + Rotation.Rotate(joint.ModelRotation, local);
}
