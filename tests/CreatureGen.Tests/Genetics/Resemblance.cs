using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Inspection.Variety;
using CreatureGen.Rigging;

namespace CreatureGen.Tests.Genetics;

/// <summary>How alike two grown creatures are part by part, measured on surfaces, colours and skeletons alone: 0 for nothing in common, 1 for the same.</summary>
internal sealed class Resemblance
{
    private static readonly HashSet<JointRole> head = [JointRole.Head, JointRole.Jaw, JointRole.Eye, JointRole.Lid, JointRole.Ear, JointRole.Antenna];
    private static readonly HashSet<JointRole> trunk = [JointRole.Body, JointRole.Pelvis, JointRole.Spine, JointRole.Chest];
    private static readonly HashSet<JointRole> tail = [JointRole.Tail];

    private readonly Outline headOutline;
    private readonly Outline tailOutline;
    private readonly Outline wholeOutline;
    private readonly Vector3 colour;
    private readonly string[] limbs;

    public Resemblance(Creature creature)
    {
        headOutline = OutlineOf(creature, head);
        tailOutline = OutlineOf(creature, tail);
        wholeOutline = Outline.FromSide(creature.Mesh.Positions, creature.Mesh.Triangles);
        colour = MeanColour(creature);
        limbs = creature.Limbs.Where(limb => limb.Side == Side.Left && limb.Kind is not LimbKind.Ear and not LimbKind.Antenna).Select(limb => $"{limb.Kind} {limb.Archetype} {limb.Stands} {limb.Pair}").ToArray();
    }

    /// <summary>The parts that are compared.</summary>
    public static IReadOnlyList<(string Name, Func<Resemblance, Resemblance, double> Likeness)> Parts { get; } =
    [
        ("head", (a, b) => a.headOutline.Likeness(b.headOutline)),
        ("colour", (a, b) => Math.Max(0, 1 - (Vector3.Distance(a.colour, b.colour) / 0.4f))),
        ("limbs", (a, b) => a.limbs.Union(b.limbs).Any() ? a.limbs.Intersect(b.limbs).Count() / (double)a.limbs.Union(b.limbs).Count() : 1),
        ("tail", (a, b) => a.tailOutline.Likeness(b.tailOutline)),
        ("whole outline", (a, b) => a.wholeOutline.Likeness(b.wholeOutline)),
    ];

    private static Outline OutlineOf(Creature creature, HashSet<JointRole> roles)
    {
        ReadOnlySpan<int> all = creature.Mesh.Triangles;
        var triangles = new List<int>();
        var used = new List<Vector3>();
        for (int i = 0; i < all.Length; i += 3)
        {
            if (roles.Contains(creature.Skeleton.Joints[creature.Mesh.Weights[all[i]].Joint0].Role))
            {
                for (int k = 0; k < 3; k++)
                {
                    triangles.Add(used.Count);
                    used.Add(creature.Mesh.Positions[all[i + k]]);
                }
            }
        }

        return used.Count == 0 ? new Outline() : Outline.FromSide(used.ToArray(), triangles.ToArray());
    }

    /// <summary>The mean colour of the trunk in Oklab. Source: B. Ottosson, "A perceptual color space for image processing" (2020).</summary>
    private static Vector3 MeanColour(Creature creature)
    {
        Vector3 sum = Vector3.Zero;
        int count = 0;
        for (int v = 0; v < creature.Mesh.Positions.Length; v++)
        {
            if (trunk.Contains(creature.Skeleton.Joints[creature.Mesh.Weights[v].Joint0].Role))
            {
                sum += creature.Mesh.Colours[v];
                count++;
            }
        }

        Vector3 rgb = sum / Math.Max(1, count);
        float l = MathF.Cbrt((0.4122214708f * rgb.X) + (0.5363325363f * rgb.Y) + (0.0514459929f * rgb.Z));
        float m = MathF.Cbrt((0.2119034982f * rgb.X) + (0.6806995451f * rgb.Y) + (0.1073969566f * rgb.Z));
        float s = MathF.Cbrt((0.0883024619f * rgb.X) + (0.2817188376f * rgb.Y) + (0.6299787005f * rgb.Z));
        return new Vector3(
            (0.2104542553f * l) + (0.7936177850f * m) - (0.0040720468f * s),
            (1.9779984951f * l) - (2.4285922050f * m) + (0.4505937099f * s),
            (0.0259040371f * l) + (0.7827717662f * m) - (0.8086757660f * s));
    }
}
