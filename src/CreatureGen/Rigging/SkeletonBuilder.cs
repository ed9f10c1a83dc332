using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Rigging;

/// <summary>A joint in model space, before it knows its place relative to its parent.</summary>
internal readonly struct JointDefinition
{
    public JointDefinition(string name, JointRole role, Vector3 position, Quaternion rotation, float length, JointLimit limit)
    {
        Name = name;
        Role = role;
        Position = position;
        Rotation = rotation;
        Length = length;
        Limit = limit;
    }

    public string Name { get; }

    public JointRole Role { get; }

    public Vector3 Position { get; }

    public Quaternion Rotation { get; }

    /// <summary>Distance to the main child.</summary>
    public float Length { get; }

    public JointLimit Limit { get; }
}

/// <summary>Collects joints in model space, parents first, and relates each to its parent.</summary>
internal sealed class SkeletonBuilder
{
    private readonly List<JointDefinition> definitions = new(96);
    private readonly List<int> parents = new(96);
    private readonly List<Side> sides = new(96);

    /// <summary>Number of joints so far.</summary>
    public int Count => definitions.Count;

    /// <summary>A joint added before.</summary>
    public JointDefinition this[int joint] => definitions[joint];

    /// <summary>Adds a joint and gives its index.</summary>
    public int Add(int parent, Side side, in JointDefinition definition)
    {
        definitions.Add(definition);
        parents.Add(parent);
        sides.Add(side);
        return definitions.Count - 1;
    }

    /// <summary>Adds the joint at the end of a chain: it has the orientation of its parent and moves nothing.</summary>
    public int AddEnd(int parent, Side side, string name, Vector3 position) =>
        Add(parent, side, new JointDefinition(name, JointRole.End, position, definitions[parent].Rotation, 0f, JointLimit.Fixed));

    /// <summary>Adds the joints of a left chain, each the child of the one before and the first the child of <paramref name="parent"/>, then their mirror images.</summary>
    /// <param name="parent">Joint in the sagittal plane.</param>
    /// <param name="left">The left joints.</param>
    /// <param name="rightNames">Names of the right joints, one per left joint.</param>
    /// <returns>Indices of the left joints followed by those of the right.</returns>
    public int[] AddPair(int parent, IReadOnlyList<JointDefinition> left, IReadOnlyList<string> rightNames)
    {
        int count = left.Count;
        int[] joints = new int[2 * count];
        for (int k = 0; k < count; k++)
        {
            joints[k] = Add(k == 0 ? parent : joints[k - 1], Side.Left, left[k]);
        }

        for (int k = 0; k < count; k++)
        {
            JointDefinition definition = left[k];
            var mirrored = new JointDefinition(rightNames[k], definition.Role, Vec.Mirror(definition.Position), Rotation.Mirror(definition.Rotation), definition.Length, definition.Limit.Mirrored());
            joints[count + k] = Add(k == 0 ? parent : joints[count + k - 1], Side.Right, mirrored);
        }

        return joints;
    }

    /// <summary>
    /// The skeleton. Model transforms are chained from the local ones exactly as a pose is, so that the rest pose reproduces the bind pose to the bit.
    /// </summary>
    public Skeleton Build()
    {
        int count = definitions.Count;
        var localRotations = new Quaternion[count];
        var localPositions = new Vector3[count];
        for (int i = 0; i < count; i++)
        {
            JointDefinition definition = definitions[i];
            if (i == 0)
            {
                localRotations[i] = definition.Rotation;
                localPositions[i] = definition.Position;
                continue;
            }

            JointDefinition parent = definitions[parents[i]];
            Quaternion inverse = Rotation.Inverse(parent.Rotation);
            localRotations[i] = Rotation.Normalize(Rotation.Multiply(inverse, definition.Rotation));
            localPositions[i] = Rotation.Rotate(inverse, definition.Position - parent.Position);
        }

        return Chain(localRotations, localPositions, 1f);
    }

    /// <summary>A skeleton of the same joints at another size.</summary>
    public static Skeleton Scale(Skeleton skeleton, float factor)
    {
        var builder = new SkeletonBuilder();
        foreach (Joint joint in skeleton.Joints)
        {
            builder.Add(joint.Parent, joint.Side, new JointDefinition(joint.Name, joint.Role, joint.ModelPosition, joint.ModelRotation, joint.Length, joint.Limit));
        }

        return builder.Chain(skeleton.LocalRotations.ToArray(), skeleton.LocalPositions.ToArray(), factor);
    }

    private Skeleton Chain(Quaternion[] localRotations, Vector3[] localPositions, float factor)
    {
        int count = definitions.Count;
        for (int i = 0; i < count; i++)
        {
            localPositions[i] *= factor;
        }

        var modelRotations = new Quaternion[count];
        var modelPositions = new Vector3[count];
        int[] tree = parents.ToArray();
        ForwardKinematics.Chain(OutwardOrder.Of(tree), tree, localRotations, localPositions, modelRotations, modelPositions);
        var joints = new Joint[count];
        for (int i = 0; i < count; i++)
        {
            JointDefinition definition = definitions[i];
            RequireFinite(definition.Name, modelPositions[i], modelRotations[i]);
            joints[i] = new Joint(definition.Name, definition.Role, sides[i], parents[i], localPositions[i], localRotations[i], modelPositions[i], modelRotations[i], definition.Length * factor, definition.Limit);
        }

        return new Skeleton(joints);
    }

    private static void RequireFinite(string joint, Vector3 p, Quaternion q)
    {
        if (!float.IsFinite(p.X + p.Y + p.Z) || !float.IsFinite(q.X + q.Y + q.Z + q.W))
        {
            throw new InvalidOperationException($"joint \"{joint}\" has a place or an orientation that is not finite; expected numbers");
        }
    }
}
