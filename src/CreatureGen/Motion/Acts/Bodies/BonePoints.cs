using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>The outermost points of the skin of each bone: what can touch the ground. A few hundred stand for all vertices. They follow all joints that move their skin, for at a folded hip that is far from where the thigh alone would have it.</summary>
internal sealed class BonePoints
{
    /// <summary>Part of the level distance of the farthest point within which a point is not asked: it lies where the pivot lies.</summary>
    private const float ShortestLever = 0.25f;

    /// <summary>Part of it from which on a point is asked wholly: one that comes from nearer is heard little by little.</summary>
    private const float WholeLever = 0.55f;

    private readonly SkinPoint[] points;

    private BonePoints(SkinPoint[] points) => this.points = points;

    /// <summary>Those of a creature.</summary>
    public static BonePoints Of(MotionSubject subject)
    {
        CreatureMesh mesh = subject.Mesh;
        var points = new List<SkinPoint>();
        foreach (int v in OutermostVertices.Of(mesh.Positions, mesh.Weights, subject.Skeleton.Count))
        {
            points.Add(new SkinPoint(subject.Skeleton, mesh.Positions[v], mesh.Weights[v]));
        }

        return new BonePoints(points.ToArray());
    }

    /// <summary>All points of the skin that some joints move most: where it folds, what is outermost at rest does not stay so.</summary>
    public static BonePoints EveryOf(MotionSubject subject, Predicate<int> joints)
    {
        CreatureMesh mesh = subject.Mesh;
        var points = new List<SkinPoint>();
        for (int v = 0; v < mesh.Positions.Length; v++)
        {
            if (joints(mesh.Weights[v].Joint0))
            {
                points.Add(new SkinPoint(subject.Skeleton, mesh.Positions[v], mesh.Weights[v]));
            }
        }

        return new BonePoints(points.ToArray());
    }

    /// <summary>Those that some joints move most.</summary>
    public BonePoints Of(Predicate<int> joints) => new(Array.FindAll(points, point => joints(point.Joint)));

    /// <summary>The angle about an axis to the left by which what hangs on a joint has to be raised so that nothing of it but what is next to the joint is in the ground, radians; 0 for none.</summary>
    /// <param name="ground">That it may be in.</param>
    /// <param name="pivot">Model space.</param>
    /// <param name="model">Pose in model space.</param>
    public float Raise(in ActGround ground, Vector3 pivot, in Pose model)
    {
        float max = 0f;
        float farthest = 0f;
        foreach (SkinPoint point in points)
        {
            Vector3 place = point.PlaceIn(model);
            farthest = Math.Max(farthest, LevelSquared(place - pivot));
        }

        // What is close to the pivot is hardly raised by any angle: it would ask for all that there is.
        float reach = (float)Math.Sqrt(farthest);
        float shortest = Math.Max(ShortestLever * reach, 1e-4f);
        foreach (SkinPoint point in points)
        {
            Vector3 place = point.PlaceIn(model);
            float height = ground.HeightOf(place);
            float away = (float)Math.Sqrt(LevelSquared(place - pivot));
            if (height < 0f && away > shortest)
            {
                float heard = Scalar.Smooth(Scalar.Clamp((away - shortest) / ((WholeLever - ShortestLever) * reach), 0f, 1f));
                max = Math.Max(max, heard * -height / away);
            }
        }

        return max;
    }

    /// <summary>The angles about an axis to the left by which what hangs down from a joint has to swing ahead, or back instead, so that nothing of it is in the ground, radians; 0 for none.</summary>
    /// <param name="ground">That it may be in.</param>
    /// <param name="pivot">Model space.</param>
    /// <param name="model">Pose in model space.</param>
    public (float Ahead, float Back) Swing(in ActGround ground, Vector3 pivot, in Pose model)
    {
        float ahead = 0f;
        float back = 0f;
        float above = ground.HeightOf(pivot);
        foreach (SkinPoint point in points)
        {
            Vector3 place = point.PlaceIn(model);
            float height = ground.HeightOf(place);
            if (height < 0f)
            {
                float way = place.Z - pivot.Z;
                float down = above - height;
                float level = (float)Math.Sqrt(Math.Max((way * way) + (down * down) - (above * above), 0f));
                double at = PortableMath.Atan2(down, way);
                ahead = Math.Max(ahead, (float)(at - PortableMath.Atan2(above, level)));
                back = Math.Max(back, (float)(PortableMath.Atan2(above, -level) - at));
            }
        }

        return (ahead, back);
    }

    private static float LevelSquared(Vector3 way) => (way.X * way.X) + (way.Z * way.Z);

    /// <summary>Height of the lowest point of a pose above the ground, metres.</summary>
    public float Lowest(in ActGround ground, in Pose model) => Lowest(ground, model, out _);

    /// <summary>The same, and where that point is, model space.</summary>
    public float Lowest(in ActGround ground, in Pose model, out Vector3 at)
    {
        float lowest = float.MaxValue;
        at = default;
        foreach (SkinPoint point in points)
        {
            Vector3 place = point.PlaceIn(model);
            float height = ground.HeightOf(place);
            if (height < lowest)
            {
                (lowest, at) = (height, place);
            }
        }

        return lowest;
    }

    /// <summary>Height of the lowest point of a pose, metres.</summary>
    public float Lowest(in Pose model)
    {
        float lowest = float.MaxValue;
        foreach (SkinPoint point in points)
        {
            lowest = Math.Min(lowest, point.PlaceIn(model).Y);
        }

        return lowest;
    }

    /// <summary>How far along a direction the farthest point of a pose is, metres.</summary>
    public float Farthest(Vector3 direction, in Pose model)
    {
        float farthest = float.MinValue;
        foreach (SkinPoint point in points)
        {
            farthest = Math.Max(farthest, Vec.Dot(point.PlaceIn(model), direction));
        }

        return farthest;
    }

    /// <summary>How far the skin at rest is from the middle of the body on its own side, metres: 0 where it reaches over to the other.</summary>
    /// <param name="skeleton">At rest.</param>
    /// <param name="side">Its side.</param>
    public float FromMiddle(Skeleton skeleton, Side side)
    {
        var rest = new Pose(skeleton.ModelRotations.ToArray(), skeleton.ModelPositions.ToArray());
        float nearest = float.MaxValue;
        foreach (SkinPoint point in points)
        {
            nearest = Math.Min(nearest, point.PlaceIn(rest).X * (side == Side.Left ? 1f : -1f));
        }

        return Math.Max(nearest, 0f);
    }
}
