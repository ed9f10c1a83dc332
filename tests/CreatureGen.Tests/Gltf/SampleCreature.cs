using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Skinning;

namespace CreatureGen.Tests.Gltf;

/// <summary>Small but complete creatures made by hand: a spindle on legs with fins, which has everything that a file can hold.</summary>
internal static class SampleCreature
{
    /// <summary>The creature of a shape; the same each time.</summary>
    public static Creature Build(SampleShape shape)
    {
        float length = 1f + (0.03f * (shape.Number % 40));
        float radius = 0.15f + (0.005f * (shape.Number % 20));
        float height = radius + 0.3f + (0.01f * (shape.Number % 30));
        var draft = new SampleSkeleton();
        var centre = new Vector3(0f, height, 0f);
        int root = draft.Add("Root", JointRole.Root, Side.Median, -1, Vector3.Zero, Vector3.Zero);
        int body = draft.Add("Body", JointRole.Body, Side.Median, root, centre, centre + new Vector3(0f, 0f, 0.45f * length / (shape.Spine + 1)));
        int[] spine = AddChain(draft, "Spine", JointRole.Spine, body, centre, new Vector3(0f, 0f, 0.45f * length), shape.Spine);
        int[] tail = AddChain(draft, "Tail", JointRole.Tail, body, centre, new Vector3(0f, 0f, -0.45f * length), shape.Tail);
        int[] bones = new[] { body }.Concat(spine[..^1]).Concat(tail[..^1]).ToArray();
        var limbs = new List<LimbChain>();
        for (int pair = 1; pair <= shape.LegPairs; pair++)
        {
            limbs.Add(AddLeg(draft, Side.Left, pair, body, shape, height, radius, length));
            limbs.Add(AddLeg(draft, Side.Right, pair, body, shape, height, radius, length));
        }

        Skeleton skeleton = draft.Build();
        CreatureMesh mesh = new SampleSurface(shape, length, radius, height).Build(skeleton, bones);
        float volume = length * radius * radius * 2f;
        return new Creature(
            BlueprintSampler.Sample(ulong.MaxValue - (ulong)shape.Number),
            mesh,
            skeleton,
            limbs,
            AttachmentPoints(skeleton, bones, radius),
            Array.Empty<CreatureSocket>(),
            new CapsuleCollider(root, new Vector3(0f, height, -0.3f * length), new Vector3(0f, height, 0.3f * length), radius),
            bones.Select(b => new CapsuleCollider(b, Vector3.Zero, new Vector3(0f, skeleton.Joints[b].Length, 0f), 0.8f * radius)).ToArray(),
            new MassProperties(1000f * volume, volume, centre, new Vector3(0.4f, 0.5f, 0.3f), new Vector3(0f, -0.02f, 0f)),
            height,
            1.2f);
    }

    /// <summary>A creature whose mesh is replaced, everything else as it was.</summary>
    public static Creature With(Creature creature, Vector3[]? positions = null, Vector3[]? normals = null, Vector2[]? texcoords = null, Vector3[]? colours = null, SkinWeights[]? weights = null, int[]? triangles = null)
    {
        CreatureMesh mesh = creature.Mesh;
        return creature with
        {
            Mesh = new CreatureMesh(
                positions ?? mesh.Positions.ToArray(),
                normals ?? mesh.Normals.ToArray(),
                texcoords ?? mesh.Texcoords.ToArray(),
                colours ?? mesh.Colours.ToArray(),
                weights ?? mesh.Weights.ToArray(),
                triangles ?? mesh.Triangles.ToArray(),
                mesh.Parts),
        };
    }

    private static int[] AddChain(SampleSkeleton draft, string name, JointRole role, int parent, Vector3 start, Vector3 span, int count)
    {
        var chain = new int[count + 1];
        for (int i = 0; i <= count; i++)
        {
            Vector3 at = start + (span * ((i + 1f) / (count + 1f)));
            Vector3 next = i == count ? at : start + (span * ((i + 2f) / (count + 1f)));
            string number = (i + 1).ToString("00", CultureInfo.InvariantCulture);
            parent = draft.Add(i == count ? name + "_End" : name + "_" + number, i == count ? JointRole.End : role, Side.Median, parent, at, next);
            chain[i] = parent;
        }

        return chain;
    }

    private static LimbChain AddLeg(SampleSkeleton draft, Side side, int pair, int parent, SampleShape shape, float height, float radius, float length)
    {
        float x = (side == Side.Left ? 1f : -1f) * 0.8f * radius;
        float z = length * (0.3f - (0.6f * (pair - 0.5f) / shape.LegPairs));
        var places = new[] { new Vector3(x, height, z), new Vector3(x, 0.5f * height, z + 0.05f), new Vector3(x, 0.1f * height, z - 0.02f), new Vector3(x, 0f, z + 0.06f) };
        string[] names = { "Hip", "Knee", "Ankle", "End" };
        JointRole[] roles = { JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.End };
        var joints = new int[places.Length];
        for (int i = 0; i < places.Length; i++)
        {
            string name = string.Create(CultureInfo.InvariantCulture, $"Leg_{(side == Side.Left ? 'L' : 'R')}{pair}_{names[i]}");
            parent = draft.Add(name, roles[i], side, parent, places[i], places[Math.Min(i + 1, places.Length - 1)]);
            joints[i] = parent;
        }

        float[] rests = { Vector3.Distance(places[0], places[1]), Vector3.Distance(places[1], places[2]), Vector3.Distance(places[2], places[3]) };
        return new LimbChain(LimbKind.Leg, side, pair, LimbArchetype.DigitigradeHind, joints, rests, Vector3.UnitZ, places[^1], true);
    }

    private static AttachmentPoint[] AttachmentPoints(Skeleton skeleton, int[] bones, float radius)
    {
        var points = new List<AttachmentPoint>();
        foreach (int bone in bones)
        {
            Joint joint = skeleton.Joints[bone];
            foreach ((string place, Vector3 normal) in new[] { ("Top", Vector3.UnitY), ("Left", Vector3.UnitX), ("Right", -Vector3.UnitX) })
            {
                points.Add(new AttachmentPoint("Socket_" + joint.Name + "_" + place, bone, joint.ModelPosition + (normal * radius), normal, 2f * radius));
            }
        }

        return points.ToArray();
    }
}
