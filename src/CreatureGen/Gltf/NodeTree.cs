using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Json;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf;

/// <summary>
/// The nodes of a file: the skinned mesh, then the joints in the order of the skeleton, then the attachment points as leaves of their joints,
/// then one for each coarser level of detail.
/// </summary>
internal static class NodeTree
{
    /// <summary>Name of the node that carries the skinned mesh, and of the mesh.</summary>
    public const string MeshName = "Creature";

    /// <summary>Number of the node that carries the skinned mesh; it is a root of the scene, because a skinned mesh ignores where its node is.</summary>
    public const int MeshNode = 0;

    /// <summary>Number of the node of joint 0, the other root of the scene.</summary>
    public const int FirstJointNode = 1;

    /// <summary>The extension that ties the levels of detail together.</summary>
    public const string LevelExtension = "MSFT_lod";

    /// <summary>Part of the screen's area down to which each level is drawn: until then it typically strays about two pixels of 1920 × 1080 from the finest. The last is drawn however small it is.</summary>
    private static readonly double[] screenCoverage = { 0.1, 0.03, 0.006, 0 };

    /// <summary>Name of the node and of the mesh of a level.</summary>
    public static string NameOfLevel(int level) => level == 0 ? MeshName : FormattableString.Invariant($"{MeshName}_LOD{level}");

    /// <summary>Writes the array of nodes.</summary>
    /// <param name="json">Receives it.</param>
    /// <param name="creature">Whose.</param>
    /// <param name="levels">Number of levels of detail.</param>
    /// <param name="more">Writes more members into the extras of the root joint.</param>
    public static void Write(JsonWriter json, Creature creature, int levels, Action more)
    {
        IReadOnlyList<Joint> joints = creature.Skeleton.Joints;
        json.BeginArray();
        WriteLevel(json, 0, levels, FirstJointNode + joints.Count + creature.AttachmentPoints.Count);
        List<int>[] children = Children(creature);
        for (int i = 0; i < joints.Count; i++)
        {
            WriteJoint(json, creature, i, children[i], more);
        }

        foreach (AttachmentPoint point in creature.AttachmentPoints)
        {
            WriteAttachmentPoint(json, point, joints[point.Joint]);
        }

        for (int level = 1; level < levels; level++)
        {
            WriteLevel(json, level, 0, 0);
        }

        json.EndArray();
    }

    /// <summary>Writes the node of a skinned mesh; the finest of several levels names the nodes of the others.</summary>
    private static void WriteLevel(JsonWriter json, int level, int levels, int firstOther)
    {
        json.BeginObject().Name("name").Text(NameOfLevel(level)).Name("mesh").Number(level).Name("skin").Number(0);
        if (levels > 1)
        {
            json.Name("extensions").BeginObject().Name(LevelExtension).BeginObject().Name("ids").BeginArray();
            for (int i = 1; i < levels; i++)
            {
                json.Number(firstOther + i - 1);
            }

            json.EndArray().EndObject().EndObject();
            json.Name("extras").BeginObject().Name("MSFT_screencoverage").BeginArray();
            for (int i = 0; i < levels; i++)
            {
                json.Number(screenCoverage[i]);
            }

            json.EndArray().EndObject();
        }

        json.EndObject();
    }

    private static void WriteJoint(JsonWriter json, Creature creature, int index, List<int> children, Action more)
    {
        Joint joint = creature.Skeleton.Joints[index];
        json.BeginObject();
        json.Name("name").Text(joint.Name);
        if (children.Count > 0)
        {
            json.Name("children").BeginArray();
            foreach (int child in children)
            {
                json.Number(child);
            }

            json.EndArray();
        }

        WritePose(json, joint.LocalPosition, joint.LocalRotation);
        CreatureExtras.WriteJoint(json, creature, index, more);
        json.EndObject();
    }

    private static void WriteAttachmentPoint(JsonWriter json, AttachmentPoint point, Joint joint)
    {
        json.BeginObject();
        json.Name("name").Text(point.Name);
        WritePose(json, JointFrame.InModel(joint).PointToLocal(point.Position), Upright(point.Normal, joint.ModelRotation));
        CreatureExtras.WriteAttachmentPoint(json, point);
        json.EndObject();
    }

    /// <summary>Writes translation and rotation but for what is identity.</summary>
    private static void WritePose(JsonWriter json, Vector3 position, Quaternion rotation)
    {
        if (position.X != 0f || position.Y != 0f || position.Z != 0f)
        {
            json.Name("translation").Vector(position);
        }

        if (rotation.X != 0f || rotation.Y != 0f || rotation.Z != 0f)
        {
            // A rounding error beyond unit length can make a component exceed one, which validators refuse.
            json.Name("rotation").Vector(Rotation.Normalize(rotation));
        }
    }

    /// <summary>
    /// The rotation, in the space of a joint, whose +Y is <paramref name="normalModel"/>: the smallest turn from up in model space,
    /// which leaves the front of what stands on the back or on a flank to the front of the creature.
    /// </summary>
    private static Quaternion Upright(Vector3 normalModel, Quaternion jointModel) =>
        Rotation.Multiply(Rotation.Inverse(jointModel), Rotation.FromTo(Vector3.UnitY, normalModel));

    /// <summary>The nodes below each joint: its child joints, then its attachment points, each in their order.</summary>
    private static List<int>[] Children(Creature creature)
    {
        IReadOnlyList<Joint> joints = creature.Skeleton.Joints;
        var children = new List<int>[joints.Count];
        for (int i = 0; i < joints.Count; i++)
        {
            children[i] = new List<int>();
            if (i > 0)
            {
                children[joints[i].Parent].Add(FirstJointNode + i);
            }
        }

        for (int i = 0; i < creature.AttachmentPoints.Count; i++)
        {
            children[creature.AttachmentPoints[i].Joint].Add(FirstJointNode + joints.Count + i);
        }

        return children;
    }
}
