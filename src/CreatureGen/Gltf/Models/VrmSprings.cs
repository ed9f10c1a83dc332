using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Json;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf.Models;

/// <summary>Reads the extension <c>VRMC_springBone</c> of a document: chains, their settings, and colliders.</summary>
/// <remarks>Based on: VRM Consortium, "VRMC_springBone-1.0" (2022).</remarks>
internal static class VrmSprings
{
    /// <summary>Frames per second that the numbers of the files are made for.</summary>
    public const float Rate = 60f;

    private const string Extension = "VRMC_springBone";

    /// <summary>Most of a velocity that a frame takes: all of it would be a rate without end.</summary>
    private const float MaxDrag = 0.9999f;

    private const float AnyAngle = 3.1415f;

    /// <summary>The nodes that the extension names; none without it.</summary>
    public static IEnumerable<int> Nodes(ModelDocument document, int count)
    {
        if (Find(document) is not { } springs)
        {
            yield break;
        }

        foreach (JsonValue spring in ModelDocument.ItemsOf(springs, "springs"))
        {
            foreach (JsonValue joint in ModelDocument.ItemsOf(spring, "joints"))
            {
                yield return ModelDocument.Whole(ModelDocument.Need(joint, "node", "a node"), count - 1);
            }
        }

        foreach (JsonValue collider in ModelDocument.ItemsOf(springs, "colliders"))
        {
            yield return ModelDocument.Whole(ModelDocument.Need(collider, "node", "a node"), count - 1);
        }
    }

    /// <summary>All chains, those that others hang on first.</summary>
    public static IReadOnlyList<ModelSpring> Of(ModelDocument document, ModelJoints joints)
    {
        var found = new List<ModelSpring>();
        if (Find(document) is not { } springs)
        {
            return found;
        }

        IReadOnlyList<JsonValue> colliders = ModelDocument.ItemsOf(springs, "colliders");
        IReadOnlyList<JsonValue> groups = ModelDocument.ItemsOf(springs, "colliderGroups");
        foreach (JsonValue spring in ModelDocument.ItemsOf(springs, "springs"))
        {
            if (ModelDocument.ItemsOf(spring, "joints").Count >= 2)
            {
                found.Add(Read(spring, colliders, groups, joints));
            }
        }

        found.Sort((a, b) => a.Rig.Joints[0].CompareTo(b.Rig.Joints[0]));
        return found;
    }

    private static JsonValue? Find(ModelDocument document) => ModelDocument.Find(document.Root, "extensions") is { } extensions ? ModelDocument.Find(extensions, Extension) : null;

    private static ModelSpring Read(JsonValue spring, IReadOnlyList<JsonValue> colliders, IReadOnlyList<JsonValue> groups, ModelJoints joints)
    {
        IReadOnlyList<JsonValue> items = ModelDocument.ItemsOf(spring, "joints");
        var chain = new List<int>();
        var owners = new List<JsonValue>();
        foreach (JsonValue item in items)
        {
            Extend(chain, owners, item, joints);
        }

        SpringRig rig = SpringRig.Along(joints.Skeleton, chain.ToArray());
        int count = rig.Joints.Length;
        float[] places = new float[count];
        float[] frequencies = new float[count];
        float[] drags = new float[count];
        float[] radii = new float[count];
        float[] fractions = new float[count];
        Vector3 gravity = Vector3.Zero;
        for (int i = 0; i < count; i++)
        {
            JsonValue item = owners[i];
            places[i] = rig.Places[i];
            float stiffness = Number(item, "stiffness", 1f);

            // The push towards rest makes the bone longer by this part of it before it is brought back to its length, which takes as much from what goes across.
            float stretch = 1f + (stiffness / (Rate * rig.Bones[i].Length));
            frequencies[i] = MathF.Sqrt(Rate * stiffness / (rig.Bones[i].Length * stretch)) / (float)PortableMath.Tau;
            drags[i] = Rate * (float)PortableMath.Log(stretch / (1 - Math.Min(Number(item, "dragForce", 0.5f), MaxDrag)));
            radii[i] = Number(item, "hitRadius", 0f) * joints.Scales[chain[i]];
            float power = Rate * Number(item, "gravityPower", 0f) / stretch;
            if (power > 0f && gravity == Vector3.Zero)
            {
                gravity = Direction(item) * power;
            }

            fractions[i] = power > 0f ? power / Vec.Length(gravity) : 0f;
        }

        bool centred = ModelDocument.Find(spring, "center") is not null;
        var settings = new SpringSettings(
            ChainCurve.Through(places, frequencies),
            new ChainCurve(0f),
            ChainCurve.Through(places, radii),
            gravity,
            AnyAngle,
            inherit: 1f,
            inertia: centred ? 0f : 1f,
            drag: ChainCurve.Through(places, drags),
            gravityFraction: ChainCurve.Through(places, fractions));
        return new ModelSpring(ModelDocument.Text(spring, "name", string.Empty), rig, settings, Colliders(spring, colliders, groups, joints));
    }

    /// <summary>Adds a joint to a chain, with those between it and the last, which are like that one.</summary>
    private static void Extend(List<int> chain, List<JsonValue> owners, JsonValue item, ModelJoints joints)
    {
        JsonValue node = ModelDocument.Need(item, "node", "a node");
        int joint = JointOf(node, joints);
        int at = chain.Count;
        int last = at > 0 ? chain[at - 1] : joints.Skeleton.Parents[joint];
        JsonValue owner = at > 0 ? owners[at - 1] : item;
        for (int i = joint; i != last; i = joints.Skeleton.Parents[i])
        {
            if (i < 0)
            {
                throw ModelFault.At(node, "a node below that of the joint before it");
            }

            chain.Insert(at, i);
            owners.Insert(at, i == joint ? item : owner);
        }

        if (chain.Count == at)
        {
            throw ModelFault.At(node, "a node below that of the joint before it");
        }
    }

    private static IReadOnlyList<SpringCollider> Colliders(JsonValue spring, IReadOnlyList<JsonValue> colliders, IReadOnlyList<JsonValue> groups, ModelJoints joints)
    {
        var found = new List<SpringCollider>();
        foreach (JsonValue number in ModelDocument.ItemsOf(spring, "colliderGroups"))
        {
            JsonValue group = One(groups, number, "collider groups");
            foreach (JsonValue index in ModelDocument.ItemsOf(group, "colliders"))
            {
                JsonValue collider = One(colliders, index, "colliders");
                int joint = JointOf(ModelDocument.Need(collider, "node", "a node"), joints);
                JsonValue shape = ModelDocument.Need(collider, "shape", "a sphere or a capsule");
                JsonValue? sphere = ModelDocument.Find(shape, "sphere");
                JsonValue form = sphere ?? ModelDocument.Need(shape, "capsule", "a sphere or a capsule");
                float scale = joints.Scales[joint];
                Vector3 start = Place(form, "offset") * scale;
                Vector3 end = sphere is null ? Place(form, "tail") * scale : start;
                found.Add(SpringCollider.Capsule(joint, start, end, Number(form, "radius", 0f) * scale));
            }
        }

        return found;
    }

    private static JsonValue One(IReadOnlyList<JsonValue> all, JsonValue index, string what)
    {
        int i = ModelDocument.Whole(index, int.MaxValue);
        return i < all.Count ? all[i] : throw ModelFault.At(index, "one of the " + ModelFault.Text(all.Count) + " " + what);
    }

    private static int JointOf(JsonValue node, ModelJoints joints)
    {
        int joint = joints.JointOf(ModelDocument.Whole(node, joints.NodeCount - 1));
        return joint >= 0 ? joint : throw ModelFault.At(node, "a node of the tree that the skin is in");
    }

    private static Vector3 Place(JsonValue form, string name)
    {
        Span<float> numbers = stackalloc float[3];
        return ModelDocument.TryNumbers(form, name, numbers) ? new Vector3(numbers[0], numbers[1], numbers[2]) : Vector3.Zero;
    }

    private static Vector3 Direction(JsonValue item)
    {
        Span<float> numbers = stackalloc float[3];
        return ModelDocument.TryNumbers(item, "gravityDir", numbers) ? Vec.Normalize(new Vector3(numbers[0], numbers[1], numbers[2]), -Vector3.UnitY) : -Vector3.UnitY;
    }

    private static float Number(JsonValue parent, string name, float fallback)
    {
        if (ModelDocument.Find(parent, name) is not { } value)
        {
            return fallback;
        }

        return value.Kind == JsonKind.Number && value.Number >= 0 && value.Number <= 1e6 ? (float)value.Number : throw ModelFault.At(value, "a number of 0 to 1000000");
    }
}
