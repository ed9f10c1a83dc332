using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Features;
using CreatureGen.Geometry;
using Xunit;

namespace CreatureGen.Tests.Features;

/// <summary>What every piece must be, whatever it stands for.</summary>
internal static class PieceChecks
{
    /// <summary>For pieces whose binding does not matter.</summary>
    public static PieceBinding Anywhere { get; } = new PieceBinding.Joint("Head");

    /// <summary>Closed, oriented, without degenerate triangles, each shell of positive volume, unit normals, colours in range.</summary>
    public static void IsSound(Piece piece)
    {
        Assert.Equal(piece.Positions.Length, piece.Normals.Length);
        Assert.Equal(piece.Positions.Length, piece.Colours.Length);
        Assert.NotEmpty(piece.Triangles);
        foreach (Vector3 n in piece.Normals)
        {
            Assert.InRange(n.Length(), 0.999f, 1.001f);
        }

        foreach (Vector3 c in piece.Colours)
        {
            Assert.InRange(Math.Min(c.X, Math.Min(c.Y, c.Z)), 0f, 1f);
            Assert.InRange(Math.Max(c.X, Math.Max(c.Y, c.Z)), 0f, 1f);
        }

        int[] weld = Weld(piece.Positions, out int count);
        var edges = new HashSet<(int, int)>();
        int[] shell = new int[count];
        for (int i = 0; i < count; i++)
        {
            shell[i] = i;
        }

        for (int t = 0; t < piece.Triangles.Length; t += 3)
        {
            int a = weld[piece.Triangles[t]];
            int b = weld[piece.Triangles[t + 1]];
            int c = weld[piece.Triangles[t + 2]];
            Assert.True(a != b && b != c && c != a, FormattableString.Invariant($"triangle {t / 3} has two equal corners"));
            Assert.True(edges.Add((a, b)) && edges.Add((b, c)) && edges.Add((c, a)), FormattableString.Invariant($"triangle {t / 3} repeats a directed edge"));
            Join(shell, a, b);
            Join(shell, b, c);
        }

        foreach ((int a, int b) in edges)
        {
            Assert.True(edges.Contains((b, a)), FormattableString.Invariant($"the edge at {piece.Positions[Array.IndexOf(weld, a)]} is open"));
        }

        var volumes = new Dictionary<int, double>();
        double smallest = 1e-12 * DiagonalSquared(piece.Positions);
        for (int t = 0; t < piece.Triangles.Length; t += 3)
        {
            Vector3 a = piece.Positions[piece.Triangles[t]];
            Vector3 b = piece.Positions[piece.Triangles[t + 1]];
            Vector3 c = piece.Positions[piece.Triangles[t + 2]];
            Vector3 origin = piece.Positions[piece.Triangles[0]];
            Assert.True(Vector3.Cross(b - a, c - a).Length() * 0.5 > smallest, FormattableString.Invariant($"triangle {t / 3} has no area"));
            int root = Root(shell, weld[piece.Triangles[t]]);
            volumes.TryGetValue(root, out double v);
            volumes[root] = v + (Vector3.Dot(a - origin, Vector3.Cross(b - origin, c - origin)) / 6.0);
        }

        foreach (double v in volumes.Values)
        {
            Assert.True(v > 0, FormattableString.Invariant($"a shell has volume {v}"));
        }
    }

    /// <summary>No two triangles that share no corner cut one another.</summary>
    public static void DoesNotCrossItself(Piece piece)
    {
        int[] weld = Weld(piece.Positions, out int count);
        var positions = new Vector3[count];
        for (int v = 0; v < weld.Length; v++)
        {
            positions[weld[v]] = piece.Positions[v];
        }

        var pairs = new List<(int First, int Second)>();
        SelfIntersection.Find(positions, Array.ConvertAll(piece.Triangles, v => weld[v]), pairs);
        Assert.True(pairs.Count == 0, FormattableString.Invariant($"{pairs.Count} pairs of triangles cross, the first {(pairs.Count > 0 ? pairs[0] : default)}"));
    }

    /// <summary>The vertices are their own mirror images, exactly, and so are their normals.</summary>
    public static void IsSymmetric(Piece piece)
    {
        var vertices = new HashSet<(Vector3, Vector3)>();
        for (int v = 0; v < piece.Positions.Length; v++)
        {
            vertices.Add((Clean(piece.Positions[v]), Clean(piece.Normals[v])));
        }

        foreach ((Vector3 p, Vector3 n) in vertices)
        {
            Assert.Contains((Clean(new Vector3(-p.X, p.Y, p.Z)), Clean(new Vector3(-n.X, n.Y, n.Z))), vertices);
        }
    }

    /// <summary>The vertex normals of nearly all triangles lie on the side that the triangle faces.</summary>
    public static void NormalsFollowFaces(Piece piece, double share)
    {
        int good = 0;
        for (int t = 0; t < piece.Triangles.Length; t += 3)
        {
            Vector3 a = piece.Positions[piece.Triangles[t]];
            Vector3 face = Vector3.Cross(piece.Positions[piece.Triangles[t + 1]] - a, piece.Positions[piece.Triangles[t + 2]] - a);
            Vector3 mean = piece.Normals[piece.Triangles[t]] + piece.Normals[piece.Triangles[t + 1]] + piece.Normals[piece.Triangles[t + 2]];
            good += Vector3.Dot(face, mean) > 0 ? 1 : 0;
        }

        Assert.InRange((double)good / (piece.Triangles.Length / 3), share, 1.0);
    }

    public static int TriangleCount(Piece piece) => piece.Triangles.Length / 3;

    private static Vector3 Clean(Vector3 v) => new(v.X + 0f, v.Y + 0f, v.Z + 0f);

    private static double DiagonalSquared(Vector3[] positions)
    {
        var low = new Vector3(float.MaxValue);
        var high = new Vector3(float.MinValue);
        foreach (Vector3 p in positions)
        {
            low = Vector3.Min(low, p);
            high = Vector3.Max(high, p);
        }

        return (high - low).LengthSquared();
    }

    private static int[] Weld(Vector3[] positions, out int count)
    {
        var index = new Dictionary<Vector3, int>();
        int[] weld = new int[positions.Length];
        for (int v = 0; v < positions.Length; v++)
        {
            Vector3 key = Clean(positions[v]);
            if (!index.TryGetValue(key, out weld[v]))
            {
                weld[v] = index.Count;
                index.Add(key, weld[v]);
            }
        }

        count = index.Count;
        return weld;
    }

    private static int Root(int[] shell, int v)
    {
        while (shell[v] != v)
        {
            v = shell[v] = shell[shell[v]];
        }

        return v;
    }

    private static void Join(int[] shell, int a, int b) => shell[Root(shell, a)] = Root(shell, b);
}
