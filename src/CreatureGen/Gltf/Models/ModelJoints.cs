using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Json;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Gltf.Models;

/// <summary>The joints of a document as a skeleton: the nodes that skins and springs name, and all nodes above them, in the order of the tree. Scale is worked into positions, so that joints have none.</summary>
internal sealed class ModelJoints
{
    /// <summary>Most nodes of a document.</summary>
    private const int MaxNodes = 1 << 16;

    private readonly int[] jointOf;

    private ModelJoints(Skeleton skeleton, int[] jointOf, int[] nodes, float[] scales)
    {
        Skeleton = skeleton;
        this.jointOf = jointOf;
        Nodes = nodes;
        Scales = scales;
    }

    /// <summary>In the rest pose of the nodes.</summary>
    public Skeleton Skeleton { get; }

    /// <summary>The node of each joint.</summary>
    public int[] Nodes { get; }

    /// <summary>Scale of each joint's own space in the scene: what its children's translations are multiplied by.</summary>
    public float[] Scales { get; }

    /// <summary>Number of nodes of the document.</summary>
    public int NodeCount => jointOf.Length;

    /// <summary>The joint of a node, −1 if it is none.</summary>
    public int JointOf(int node) => jointOf[node];

    /// <summary>Factor from a translation in the file to the position of a joint in its parent's space.</summary>
    public float LengthOf(int joint)
    {
        int parent = Skeleton.Parents[joint];
        return parent < 0 ? 1f : Scales[parent];
    }

    /// <summary>Finds the joints of all skins.</summary>
    public static ModelJoints Of(ModelDocument document)
    {
        IReadOnlyList<JsonValue> nodes = document.All("nodes");
        if (nodes.Count > MaxNodes)
        {
            throw new ModelFault("nodes", ModelFault.Text(nodes.Count), "at most " + ModelFault.Text(MaxNodes));
        }

        int[] parents = ParentsOf(nodes);
        bool[] used = new bool[nodes.Count];
        int root = -1;
        foreach (JsonValue skin in document.All("skins"))
        {
            foreach (JsonValue joint in ModelDocument.ItemsOf(skin, "joints"))
            {
                int node = ModelDocument.Whole(joint, nodes.Count - 1);
                while (!used[node])
                {
                    used[node] = true;
                    if (parents[node] >= 0)
                    {
                        node = parents[node];
                    }
                    else if (root >= 0)
                    {
                        throw new ModelFault(joint.Path, FormattableString.Invariant($"a joint below node {node}, others below node {root}"), "joints with one root");
                    }
                    else
                    {
                        root = node;
                    }
                }
            }
        }

        foreach (int node in VrmSprings.Nodes(document, nodes.Count))
        {
            MarkBelow(node, parents, used);
        }

        return root < 0 ? throw new ModelFault("skins", "no joint", "a skinned model") : Build(nodes, parents, Order(nodes, parents, used, root));
    }

    /// <summary>Takes a node and those above it in, if they hang on joints.</summary>
    private static void MarkBelow(int node, int[] parents, bool[] used)
    {
        int above = node;
        while (above >= 0 && !used[above])
        {
            above = parents[above];
        }

        for (int i = node; above >= 0 && i != above; i = parents[i])
        {
            used[i] = true;
        }
    }

    private static int[] ParentsOf(IReadOnlyList<JsonValue> nodes)
    {
        int[] parents = new int[nodes.Count];
        Array.Fill(parents, -1);
        for (int i = 0; i < nodes.Count; i++)
        {
            foreach (JsonValue child in ModelDocument.ItemsOf(nodes[i], "children"))
            {
                int node = ModelDocument.Whole(child, nodes.Count - 1);
                parents[node] = parents[node] < 0 ? i : throw ModelFault.At(child, "a node with one parent");
            }
        }

        for (int i = 0; i < nodes.Count; i++)
        {
            int steps = 0;
            for (int node = i; node >= 0; node = parents[node])
            {
                if (++steps > nodes.Count)
                {
                    throw new ModelFault(nodes[i].Path, "a node below itself", "a tree of nodes");
                }
            }
        }

        return parents;
    }

    /// <summary>Parents before children: the order of the document if it is such, otherwise that of the tree.</summary>
    private static List<int> Order(IReadOnlyList<JsonValue> nodes, int[] parents, bool[] used, int root)
    {
        var order = new List<int>();
        bool sorted = true;
        for (int node = 0; node < used.Length; node++)
        {
            if (used[node])
            {
                order.Add(node);
                sorted &= parents[node] < node;
            }
        }

        if (sorted)
        {
            return order;
        }

        order.Clear();
        var open = new Stack<int>();
        open.Push(root);
        while (open.Count > 0)
        {
            int node = open.Pop();
            order.Add(node);
            IReadOnlyList<JsonValue> children = ModelDocument.ItemsOf(nodes[node], "children");
            for (int c = children.Count - 1; c >= 0; c--)
            {
                int child = ModelDocument.Whole(children[c], nodes.Count - 1);
                if (used[child])
                {
                    open.Push(child);
                }
            }
        }

        return order;
    }

    private static ModelJoints Build(IReadOnlyList<JsonValue> nodes, int[] parents, List<int> order)
    {
        int[] jointOf = new int[nodes.Count];
        Array.Fill(jointOf, -1);
        var placements = new JointPlacement[order.Count];
        float[] scales = new float[order.Count];
        var names = new HashSet<string>(StringComparer.Ordinal);
        for (int i = 0; i < scales.Length; i++)
        {
            int node = order[i];
            int parent = i == 0 ? -1 : jointOf[parents[node]];
            NodePlace place = NodePlace.Of(nodes[node]);
            float outer = parent < 0 ? 1f : scales[parent];
            jointOf[node] = i;
            scales[i] = outer * place.Scale;
            string name = NameOf(nodes[node], node, names);
            placements[i] = new JointPlacement(name, parent, place.Rotation, place.Position * outer);
        }

        try
        {
            return new ModelJoints(Skeleton.Build(placements), jointOf, order.ToArray(), scales);
        }
        catch (ArgumentException e)
        {
            throw new ModelFault("nodes", e.Message, "a sound skeleton");
        }
    }

    /// <summary>The node's name; of nodes without one, or with one that is taken, a name with its number.</summary>
    private static string NameOf(JsonValue node, int index, HashSet<string> names)
    {
        string name = ModelDocument.Text(node, "name", string.Empty);
        if (name.Length == 0 || !names.Add(name))
        {
            name = (name.Length == 0 ? "Node" : name) + "_" + ModelFault.Text(index);
            while (!names.Add(name))
            {
                name += "_";
            }
        }

        return name;
    }
}
