using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>The outermost points of the skin of each bone, rigid to it: what can touch the ground. A few hundred stand for all vertices.</summary>
internal sealed class SupportPoints
{
    private readonly (int Joint, Vector3 Point)[] points;

    private SupportPoints((int, Vector3)[] points) => this.points = points;

    /// <summary>Those of a creature.</summary>
    public static SupportPoints Of(MotionSubject subject)
    {
        Skeleton skeleton = subject.Skeleton;
        CreatureMesh mesh = subject.Mesh;
        var points = new List<(int, Vector3)>();
        foreach (int v in OutermostVertices.Of(mesh.Positions, mesh.Weights, skeleton.Count))
        {
            int joint = mesh.Weights[v].Joint0;
            points.Add((joint, Rotation.Rotate(Rotation.Inverse(skeleton.ModelRotations[joint]), mesh.Positions[v] - skeleton.ModelPositions[joint])));
        }

        return new SupportPoints(points.ToArray());
    }

    /// <summary>Those of some joints.</summary>
    public SupportPoints Of(Predicate<int> joints) => new(Array.FindAll(points, point => joints(point.Joint)));

    /// <summary>The angle about an axis to the left by which what hangs on a joint has to be raised so that nothing of it is in level ground at height 0, radians; 0 for none.</summary>
    /// <param name="pivot">Model space.</param>
    /// <param name="model">Pose in model space.</param>
    public float Raise(Vector3 pivot, in Pose model)
    {
        float most = 0f;
        foreach ((int joint, Vector3 point) in points)
        {
            Vector3 place = model.Positions[joint] + Rotation.Rotate(model.Rotations[joint], point);
            if (place.Y < 0f)
            {
                float x = place.X - pivot.X;
                float z = place.Z - pivot.Z;
                most = Math.Max(most, -place.Y / (float)Math.Sqrt(Math.Max((x * x) + (z * z), 1e-8f)));
            }
        }

        return most;
    }

    /// <summary>Height of the lowest point of a pose, metres.</summary>
    public float Lowest(in Pose model)
    {
        float lowest = float.MaxValue;
        foreach ((int joint, Vector3 point) in points)
        {
            lowest = Math.Min(lowest, model.Positions[joint].Y + Rotation.Rotate(model.Rotations[joint], point).Y);
        }

        return lowest;
    }
}
