using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Motion.Metrics;

/// <summary>The vertices of a foot near the ground, moved by a pose.</summary>
internal sealed class FootSkin
{
    /// <summary>Weight from which on a vertex goes with one joint.</summary>
    private const float Firm = 0.9f;

    /// <summary>Weight from which on it goes mostly with one.</summary>
    private const float Shared = 0.49f;

    private readonly CreatureMesh mesh;
    private readonly int[] vertices;
    private readonly int soleCount;
    private readonly float firm = Firm;

    /// <summary>Takes the vertices that ankle, ball and toes move and that are low at rest.</summary>
    /// <param name="subject">The creature.</param>
    /// <param name="ankle">Skeleton index.</param>
    /// <param name="ball">Skeleton index.</param>
    /// <param name="length">Of the leg, metres.</param>
    public FootSkin(MotionSubject subject, int ankle, int ball, float length)
    {
        mesh = subject.Mesh;
        var sole = new List<int>();
        var rest = new List<int>();
        float lowest = Lowest(ankle, ball);
        firm = Shared;
        float shared = Lowest(ankle, ball);
        if (shared < lowest - (0.003f * length))
        {
            // A foot that stands on skin between its joints.
            lowest = shared;
        }
        else
        {
            firm = Firm;
        }

        for (int v = 0; v < mesh.Positions.Length; v++)
        {
            if (IsFoot(v, ankle, ball) && mesh.Positions[v].Y < 0.06f * length)
            {
                // The drift of a foot is that of what the ball moves: toes of digitigrades, the ball of soles.
                (mesh.Positions[v].Y < lowest + (0.02f * length) ? sole : rest).Add(v);
            }
        }

        soleCount = sole.Count;
        sole.AddRange(rest);
        vertices = sole.ToArray();
        IsEmpty = vertices.Length == 0;
    }

    /// <summary>Whether there are none.</summary>
    public bool IsEmpty { get; }

    /// <summary>Number of vertices.</summary>
    public int Count => vertices.Length;

    /// <summary>Moves a vertex, model space.</summary>
    public Vector3 At(int index, ReadOnlySpan<Matrix4x4> matrices)
    {
        int v = vertices[index];
        SkinWeights w = mesh.Weights[v];
        Vector3 p = mesh.Positions[v];
        return (Moved(matrices[w.Joint0], p) * w.Weights.X) + (Moved(matrices[w.Joint1], p) * w.Weights.Y) + (Moved(matrices[w.Joint2], p) * w.Weights.Z) + (Moved(matrices[w.Joint3], p) * w.Weights.W);
    }

    /// <summary>Middle of the sole, model space.</summary>
    public Vector3 Middle(ReadOnlySpan<Matrix4x4> matrices)
    {
        Vector3 sum = Vector3.Zero;
        for (int i = 0; i < soleCount; i++)
        {
            sum += At(i, matrices);
        }

        return sum / Math.Max(soleCount, 1);
    }

    private float Lowest(int ankle, int ball)
    {
        float lowest = float.MaxValue;
        for (int v = 0; v < mesh.Positions.Length; v++)
        {
            if (IsFoot(v, ankle, ball))
            {
                lowest = Math.Min(lowest, mesh.Positions[v].Y);
            }
        }

        return lowest;
    }

    private bool IsFoot(int vertex, int ankle, int ball)
    {
        SkinWeights w = mesh.Weights[vertex];
        return (w.Joint0 == ankle || w.Joint0 == ball) && w.Weights.X > firm;
    }

    private static Vector3 Moved(in Matrix4x4 m, Vector3 p) => new(
        (p.X * m.M11) + (p.Y * m.M21) + (p.Z * m.M31) + m.M41,
        (p.X * m.M12) + (p.Y * m.M22) + (p.Z * m.M32) + m.M42,
        (p.X * m.M13) + (p.Y * m.M23) + (p.Z * m.M33) + m.M43);
}
