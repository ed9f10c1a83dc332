using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Falling;

/// <summary>Places of the skin that a creature can lie on: the outermost vertices of each joint. Immutable.</summary>
internal sealed class SupportPoints
{
    /// <summary>How far above and below a point the ground is looked for, parts of the creature's size.</summary>
    private const float Lookout = 2f;

    private readonly SupportPoint[] points;
    private readonly Vector3[] bindPositions;
    private readonly Quaternion[] bindRotations;
    private readonly float size;

    private SupportPoints(SupportPoint[] points, Skeleton skeleton, float size)
    {
        this.points = points;
        this.size = size;
        bindPositions = skeleton.ModelPositions.ToArray();
        bindRotations = skeleton.ModelRotations.ToArray();
    }

    /// <summary>Number of points.</summary>
    public int Count => points.Length;

    /// <summary>The points of a creature.</summary>
    public static SupportPoints Of(MotionSubject subject)
    {
        Skeleton skeleton = subject.Skeleton;
        CreatureMesh mesh = subject.Mesh;
        Vector3 min = new(float.MaxValue);
        Vector3 max = new(float.MinValue);
        foreach (Vector3 position in mesh.Positions)
        {
            min = Vec.Min(min, position);
            max = Vec.Max(max, position);
        }

        var chosen = new List<SupportPoint>();
        foreach (int v in OutermostVertices.Of(mesh.Positions, mesh.Weights, skeleton.Count))
        {
            BodyPart part = PartOf(skeleton, mesh.Weights[v].Joint0, out int root);
            chosen.Add(new SupportPoint(mesh.Positions[v], mesh.Weights[v], part, root));
        }

        Vector3 extent = max - min;
        return new SupportPoints(chosen.ToArray(), skeleton, Math.Max(extent.X, Math.Max(extent.Y, extent.Z)));
    }

    /// <summary>Height of the lowest point above the ground below it, metres of the model; negative in the ground.</summary>
    /// <param name="root">Where the creature is.</param>
    /// <param name="model">Its pose.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it is on. Where there is none a point is as high as the creature is large.</param>
    public float Lowest(in RootPlace root, in Pose model, Vector3 up, IGround ground) => Lowest(BodyPart.All, root, model, up, ground, out _);

    /// <summary>The same of some parts.</summary>
    /// <param name="parts">Which.</param>
    /// <param name="root">Where the creature is.</param>
    /// <param name="model">Its pose.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it is on.</param>
    /// <param name="place">Receives where that point is, model space.</param>
    public float Lowest(BodyPart parts, in RootPlace root, in Pose model, Vector3 up, IGround ground, out Vector3 place)
    {
        float lowest = size;
        place = Vector3.Zero;
        foreach (ref readonly SupportPoint point in points.AsSpan())
        {
            if ((point.Part & parts) != 0)
            {
                Lower(point, root, model, up, ground, ref lowest, ref place);
            }
        }

        return lowest;
    }

    /// <summary>The same of a single limb.</summary>
    /// <param name="root">The joint at its root.</param>
    /// <param name="at">Where the creature is.</param>
    /// <param name="model">Its pose.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">What it is on.</param>
    /// <param name="place">Receives where that point is, model space.</param>
    public float LowestOfLimb(int root, in RootPlace at, in Pose model, Vector3 up, IGround ground, out Vector3 place)
    {
        float lowest = size;
        place = Vector3.Zero;
        foreach (ref readonly SupportPoint point in points.AsSpan())
        {
            if (point.Root == root)
            {
                Lower(point, at, model, up, ground, ref lowest, ref place);
            }
        }

        return lowest;
    }

    /// <summary>Height of the lowest point in model space, metres.</summary>
    public float Lowest(in Pose model)
    {
        float lowest = float.MaxValue;
        foreach (ref readonly SupportPoint point in points.AsSpan())
        {
            lowest = Math.Min(lowest, At(point, model).Y);
        }

        return lowest;
    }

    /// <summary>What the nearest joint with a part of its own says.</summary>
    private static BodyPart PartOf(Skeleton skeleton, int joint, out int root)
    {
        for (int j = joint; j >= 0; j = skeleton.Parents[j])
        {
            root = j;
            switch (skeleton.Joints[j].Role)
            {
                case JointRole.Hip:
                    return BodyPart.Limb;
                case JointRole.Neck or JointRole.Head:
                    return BodyPart.Head;
                case JointRole.Tail:
                    return BodyPart.Tail;
                case JointRole.Wing:
                    while (skeleton.Joints[skeleton.Parents[root]].Role == JointRole.Wing)
                    {
                        root = skeleton.Parents[root];
                    }

                    return BodyPart.Wing;
                case JointRole.Pelvis or JointRole.Spine or JointRole.Chest:
                    return BodyPart.Torso;
            }
        }

        root = -1;
        return BodyPart.Torso;
    }

    /// <summary>Takes a point that is lower than all before.</summary>
    private void Lower(in SupportPoint point, in RootPlace root, in Pose model, Vector3 up, IGround ground, ref float lowest, ref Vector3 place)
    {
        Vector3 at = At(point, model);
        Vector3 world = root.ToWorld(at);
        float reach = Lookout * size * root.Scale;
        if (ground.Cast(world + (up * reach), -up, 2f * reach, out GroundHit hit) && Vec.Dot(world - hit.Point, up) is float height && height / root.Scale < lowest)
        {
            lowest = height / root.Scale;
            place = at;
        }
    }

    /// <summary>Where the pose takes a point, model space.</summary>
    private Vector3 At(in SupportPoint point, in Pose model)
    {
        SkinWeights w = point.Weights;
        Vector3 sum = Moved(w.Joint0, point.Rest, model) * w.Weights.X;
        sum += w.Weights.Y > 0f ? Moved(w.Joint1, point.Rest, model) * w.Weights.Y : Vector3.Zero;
        sum += w.Weights.Z > 0f ? Moved(w.Joint2, point.Rest, model) * w.Weights.Z : Vector3.Zero;
        return sum + (w.Weights.W > 0f ? Moved(w.Joint3, point.Rest, model) * w.Weights.W : Vector3.Zero);
    }

    private Vector3 Moved(int joint, Vector3 rest, in Pose model) =>
        model.Positions[joint] + Rotation.Rotate(model.Rotations[joint], Rotation.Rotate(Rotation.Inverse(bindRotations[joint]), rest - bindPositions[joint]));

    /// <summary>A vertex.</summary>
    /// <param name="Rest">At rest, model space.</param>
    /// <param name="Weights">The joints that move it.</param>
    /// <param name="Part">What it is of.</param>
    /// <param name="Root">The joint that says so: of a limb its hip, of a wing its first.</param>
    private readonly record struct SupportPoint(Vector3 Rest, SkinWeights Weights, BodyPart Part, int Root);
}

/// <summary>What parts of a body do about the ground.</summary>
[Flags]
internal enum BodyPart
{
    /// <summary>The trunk without its wings: it lies on it.</summary>
    Torso = 1,

    /// <summary>Neck, head and what is on it: they are lifted out of the ground.</summary>
    Head = 2,

    /// <summary>The tail: it is too.</summary>
    Tail = 4,

    /// <summary>Legs and arms: they are as well.</summary>
    Limb = 8,

    /// <summary>Wings: a body rolls over them, and they give way to the ground as limbs do.</summary>
    Wing = 16,

    /// <summary>The trunk and its wings.</summary>
    Trunk = Torso | Wing,

    /// <summary>All of it.</summary>
    All = Trunk | Head | Tail | Limb,
}
