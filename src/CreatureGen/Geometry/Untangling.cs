using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>What <see cref="Untangling"/> did.</summary>
internal readonly struct UntanglingReport
{
    public UntanglingReport(int rounds, int pairsBefore, int pairsLeft)
    {
        Rounds = rounds;
        PairsBefore = pairsBefore;
        PairsLeft = pairsLeft;
    }

    /// <summary>Rounds of smoothing that were tried.</summary>
    public int Rounds { get; }

    /// <summary>Crossing pairs of triangles at the start.</summary>
    public int PairsBefore { get; }

    /// <summary>Crossing pairs of triangles in the positions that were left; never more than at the start.</summary>
    public int PairsLeft { get; }
}

/// <summary>
/// Local repair of a surface that cuts through itself: smooths the vertices of crossing triangles and one ring around them, and looks again.
/// </summary>
/// <remarks>A backstop for what the shaping rules could not keep apart: a surface without crossings is not touched.</remarks>
internal static class Untangling
{
    /// <summary>Most rounds of smoothing.</summary>
    public const int MaxRounds = 6;

    private const float Strength = 0.55f;
    private const int FirstIterations = 3;

    /// <summary>Moves positions in place until no triangles cross, or leaves the best positions that were seen: the first with the fewest crossing pairs.</summary>
    /// <param name="positions">One per vertex.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="mirror">For each vertex its mirror image in the plane x = 0, itself on the plane; empty for a mesh without symmetry. Of two images the one of lower index is computed and the other copied, so they stay exact; a vertex on the plane keeps its x. The image of each triangle is a triangle.</param>
    /// <param name="held">Vertices that may not move; a vertex is held with its mirror image. Empty for none.</param>
    /// <param name="grounded">Vertices that keep their height, as the soles do; empty for none.</param>
    /// <param name="crossings">The search, and its buffers.</param>
    /// <exception cref="ArgumentException">An index is out of range, a position is not finite, or a span has not one entry per vertex.</exception>
    public static UntanglingReport Repair(
        Span<Vector3> positions,
        ReadOnlySpan<int> triangles,
        ReadOnlySpan<int> mirror,
        ReadOnlySpan<bool> held,
        ReadOnlySpan<bool> grounded,
        CrossingPairs crossings)
    {
        RequireLength(mirror.Length, positions.Length, nameof(mirror));
        RequireLength(held.Length, positions.Length, nameof(held));
        RequireLength(grounded.Length, positions.Length, nameof(grounded));
        TriangleList.RequireFinite(positions);
        RequireImages(mirror);
        TriangleList.Count(positions.Length, triangles);
        int before = crossings.Find(positions, triangles, mirror);
        if (before == 0)
        {
            return new UntanglingReport(0, 0, 0);
        }

        using var neighbours = new VertexNeighbours(positions.Length, triangles);
        Vector3[] best = positions.ToArray();
        bool[] moved = new bool[positions.Length];
        int fewest = before;
        int rounds = 0;
        for (; rounds < MaxRounds && fewest > 0; rounds++)
        {
            List<int> region = Region(crossings.Pairs, triangles, neighbours, mirror, held);
            Smooth(positions, region, neighbours, mirror, grounded, FirstIterations + rounds);
            Mark(moved, region, mirror);
            int count = crossings.FindAgain(positions, triangles, mirror, moved);
            if (count < fewest)
            {
                fewest = count;
                positions.CopyTo(best);
            }
        }

        best.CopyTo(positions);
        return new UntanglingReport(rounds, before, fewest);
    }

    private static void Mark(bool[] moved, List<int> region, ReadOnlySpan<int> mirror)
    {
        Array.Clear(moved, 0, moved.Length);
        foreach (int v in region)
        {
            moved[v] = true;
            moved[mirror.IsEmpty ? v : mirror[v]] = true;
        }
    }

    /// <summary>The vertices to compute, ascending: those of crossing triangles and their neighbours, one of each two mirror images, without the held ones.</summary>
    private static List<int> Region(List<(int First, int Second)> pairs, ReadOnlySpan<int> triangles, VertexNeighbours neighbours, ReadOnlySpan<int> mirror, ReadOnlySpan<bool> held)
    {
        var region = new List<int>();
        Span<bool> taken = new bool[neighbours.Count];
        foreach ((int first, int second) in pairs)
        {
            for (int k = 0; k < 3; k++)
            {
                Take(taken, neighbours, triangles[(3 * first) + k]);
                Take(taken, neighbours, triangles[(3 * second) + k]);
            }
        }

        for (int v = 0; v < taken.Length; v++)
        {
            int image = mirror.IsEmpty ? v : mirror[v];
            bool isHeld = !held.IsEmpty && (held[v] || held[image]);
            if (v <= image && (taken[v] || taken[image]) && !isHeld && neighbours.Of(v).Length > 0)
            {
                region.Add(v);
            }
        }

        return region;
    }

    private static void Take(Span<bool> taken, VertexNeighbours neighbours, int vertex)
    {
        taken[vertex] = true;
        foreach (int n in neighbours.Of(vertex))
        {
            taken[n] = true;
        }
    }

    private static void Smooth(Span<Vector3> positions, List<int> region, VertexNeighbours neighbours, ReadOnlySpan<int> mirror, ReadOnlySpan<bool> grounded, int iterations)
    {
        var moved = new Vector3[region.Count];
        for (int iteration = 0; iteration < iterations; iteration++)
        {
            for (int i = 0; i < moved.Length; i++)
            {
                int v = region[i];
                ReadOnlySpan<int> around = neighbours.Of(v);
                Vector3 sum = Vector3.Zero;
                foreach (int n in around)
                {
                    sum += positions[n];
                }

                moved[i] = Vec.Lerp(positions[v], sum / around.Length, Strength);
            }

            for (int i = 0; i < moved.Length; i++)
            {
                int v = region[i];
                int image = mirror.IsEmpty ? v : mirror[v];
                Vector3 p = moved[i];
                if (!grounded.IsEmpty && (grounded[v] || grounded[image]))
                {
                    p.Y = positions[v].Y;
                }

                if (mirror.IsEmpty)
                {
                    positions[v] = p;
                }
                else if (image == v)
                {
                    p.X = positions[v].X;
                    positions[v] = p;
                }
                else
                {
                    positions[v] = p;
                    positions[image] = Vec.Mirror(p);
                }
            }
        }
    }

    private static void RequireImages(ReadOnlySpan<int> mirror)
    {
        for (int v = 0; v < mirror.Length; v++)
        {
            if ((uint)mirror[v] >= (uint)mirror.Length || mirror[mirror[v]] != v)
            {
                throw new ArgumentException(FormattableString.Invariant($"mirror[{v}] = {mirror[v]}; expected a vertex whose mirror image is {v}"), nameof(mirror));
            }
        }
    }

    private static void RequireLength(int length, int vertices, string name)
    {
        if (length != 0 && length != vertices)
        {
            throw new ArgumentException(FormattableString.Invariant($"{length} entries; expected {vertices}, one per vertex, or none"), name);
        }
    }
}
