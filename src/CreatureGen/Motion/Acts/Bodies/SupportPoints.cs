using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Acts.Bodies;

/// <summary>The outermost points of the skin of each bone, rigid to it: what can touch the ground. A few hundred stand for all vertices.</summary>
internal sealed class SupportPoints
{
    private readonly (int Joint, Vector3 Point)[] points;

    private SupportPoints((int, Vector3)[] points) => this.points = points;

    /// <summary>Finds them: for each joint the farthest vertex in 26 directions.</summary>
    public static SupportPoints Of(Creature creature)
    {
        Skeleton skeleton = creature.Skeleton;
        Vector3[] directions = Directions();
        int[] farthest = new int[skeleton.Count * directions.Length];
        Array.Fill(farthest, -1);
        ReadOnlySpan<Vector3> positions = creature.Mesh.Positions;
        for (int v = 0; v < positions.Length; v++)
        {
            int row = creature.Mesh.Weights[v].Joint0 * directions.Length;
            for (int d = 0; d < directions.Length; d++)
            {
                int known = farthest[row + d];
                if (known < 0 || Vec.Dot(positions[v], directions[d]) > Vec.Dot(positions[known], directions[d]))
                {
                    farthest[row + d] = v;
                }
            }
        }

        var points = new List<(int, Vector3)>();
        var taken = new HashSet<int>();
        for (int i = 0; i < farthest.Length; i++)
        {
            if (farthest[i] >= 0 && taken.Add(farthest[i]))
            {
                int joint = i / directions.Length;
                points.Add((joint, Rotation.Rotate(Rotation.Inverse(skeleton.ModelRotations[joint]), positions[farthest[i]] - skeleton.ModelPositions[joint])));
            }
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

    private static Vector3[] Directions()
    {
        var all = new List<Vector3>();
        for (int x = -1; x <= 1; x++)
        {
            for (int y = -1; y <= 1; y++)
            {
                for (int z = -1; z <= 1; z++)
                {
                    if (x != 0 || y != 0 || z != 0)
                    {
                        all.Add(new Vector3(x, y, z));
                    }
                }
            }
        }

        return all.ToArray();
    }
}
