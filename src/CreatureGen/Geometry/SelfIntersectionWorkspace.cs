using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>Buffers for <see cref="SelfIntersection"/>, kept from one search to the next. For one thread at a time.</summary>
internal sealed class SelfIntersectionWorkspace
{
    // Pairs of nodes taken down the tree at once; each gives up to sixteen pairs of children.
    private const int Batch = 64;
    private const int Children = TriangleTree.Branching;
    private const int Siblings = Children * (Children - 1) / 2;

    // Bounds of the length of a normal from the sum of its components' magnitudes: 1/√3 of it and all of it, with a margin for rounding.
    private const double ShortestNormal = 0.577;
    private const double LongestNormal = 1.001;
    private const int PlaneSize = 5;

    private readonly TriangleTree tree = new();
    private readonly ulong[]?[] pairsOfLevel = new ulong[]?[TriangleTree.MaxLevels];
    private ulong[] found = new ulong[64];
    private int foundCount;

    // The plane of each triangle in the tree: normal as long as twice the area, product of it with a corner, and the sum of its components' magnitudes; worked out when the first pair of a search needs one.
    private double[] planes = Array.Empty<double>();
    private bool hasPlanes;
    private double tolerance;
    private readonly List<(int First, int Second)> tried = new();

    // The piece of each vertex where pairs of different pieces do not count.
    private int[]? pieces;

    /// <summary>The pairs of the last search that had to be tried in full, since neither triangle is certainly on one side of the other's plane.</summary>
    internal List<(int First, int Second)> Tried => tried;

    /// <summary>Whether two triangles cross, with the tolerance of the last search.</summary>
    internal bool Cross(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> s, ReadOnlySpan<int> t) =>
        TriangleCrossing.Cross(positions[s[0]], positions[s[1]], positions[s[2]], positions[t[0]], positions[t[1]], positions[t[2]], tolerance);

    /// <summary>Finds all crossing pairs; see <see cref="SelfIntersection"/>. The indices are in range.</summary>
    /// <param name="positions">One per vertex.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="pairs">Receives the pairs.</param>
    /// <param name="pieceOf">The piece of each vertex, where only pairs of one piece count.</param>
    /// <param name="still">Which triangles are as they were when others were looked for: pairs of two of these do not count, nor are they looked at. Empty for none.</param>
    internal int Find(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, List<(int First, int Second)> pairs, int[]? pieceOf = null, ReadOnlySpan<bool> still = default)
    {
        pieces = pieceOf;
        foundCount = 0;
        hasPlanes = false;
        tried.Clear();
        tree.Build(positions, triangles, still);
        tolerance = Tolerance.CrossingLengthPerDiagonal * tree.Diagonal;
        for (int level = tree.Levels - 1; level >= 0; level--)
        {
            FollowSiblings(positions, level);
        }

        Array.Sort(found, 0, foundCount);
        pairs.Clear();
        for (int i = 0; i < foundCount; i++)
        {
            pairs.Add((First(found[i]), Second(found[i])));
        }

        return foundCount;
    }

    /// <summary>Follows those pairs of a level's nodes that have the same parent and meet. All other pairs descend from these.</summary>
    private void FollowSiblings(ReadOnlySpan<Vector3> positions, int level)
    {
        ReadOnlySpan<ulong> lows = tree.Low(level);
        ReadOnlySpan<ulong> highs = tree.High(level);
        ulong[] output = PairsOf(level);
        int count = 0;
        for (int first = 0; first < lows.Length; first += Children)
        {
            if (count > output.Length - Siblings - 1)
            {
                Follow(positions, level, count);
                count = 0;
            }

            for (int i = first; i < first + Children; i++)
            {
                for (int j = i + 1; j < first + Children; j++)
                {
                    output[count] = Pair(i, j);
                    count += BoxCode.Overlap(lows[i], highs[i], lows[j], highs[j]);
                }
            }
        }

        Follow(positions, level, count);
    }

    /// <summary>Follows the pairs of nodes in a level's buffer down to pairs of triangles, and tests those.</summary>
    private void Follow(ReadOnlySpan<Vector3> positions, int level, int count)
    {
        ulong[] pairs = PairsOf(level);
        if (level == 0)
        {
            Test(positions, pairs, KeepOfOnePiece(pairs, KeepUnconnected(pairs, count)));
            return;
        }

        ulong[] output = PairsOf(level - 1);
        ReadOnlySpan<ulong> lows = tree.Low(level - 1);
        ReadOnlySpan<ulong> highs = tree.High(level - 1);
        for (int begin = 0; begin < count; begin += Batch)
        {
            int kept = 0;
            int end = Math.Min(begin + Batch, count);
            for (int p = begin; p < end; p++)
            {
                int i = First(pairs[p]) * Children;
                int j = Second(pairs[p]) * Children;
                kept = AddMeeting(lows.Slice(i, Children), highs.Slice(i, Children), lows.Slice(j, Children), highs.Slice(j, Children), Pair(i, j), output, kept);
            }

            Follow(positions, level - 1, kept);
        }
    }

    /// <summary>Adds those of sixteen pairs of boxes that meet: writes every pair, and steps on when it is to stay.</summary>
    private static int AddMeeting(ReadOnlySpan<ulong> lowA, ReadOnlySpan<ulong> highA, ReadOnlySpan<ulong> lowB, ReadOnlySpan<ulong> highB, ulong pair, ulong[] output, int count)
    {
        ulong low0 = lowA[0], low1 = lowA[1], low2 = lowA[2], low3 = lowA[3];
        ulong high0 = highA[0], high1 = highA[1], high2 = highA[2], high3 = highA[3];
        ulong step = Pair(1, 0);
        for (int j = 0; j < Children; j++)
        {
            ulong low = lowB[j];
            ulong high = highB[j];
            output[count] = pair;
            count += BoxCode.Overlap(low0, high0, low, high);
            output[count] = pair + step;
            count += BoxCode.Overlap(low1, high1, low, high);
            output[count] = pair + (2 * step);
            count += BoxCode.Overlap(low2, high2, low, high);
            output[count] = pair + (3 * step);
            count += BoxCode.Overlap(low3, high3, low, high);
            pair++;
        }

        return count;
    }

    /// <summary>Keeps the pairs of triangles that share no vertex.</summary>
    private int KeepUnconnected(ulong[] pairs, int count)
    {
        ReadOnlySpan<ulong> triples = tree.Triples;
        ReadOnlySpan<int> corners = tree.Corners;
        int kept = 0;
        if (tree.TriplesAreExact)
        {
            for (int p = 0; p < count; p++)
            {
                ulong pair = pairs[p];
                pairs[kept] = pair;
                kept += BoxCode.Distinct(triples[First(pair)], triples[Second(pair)]);
            }

            return kept;
        }

        for (int p = 0; p < count; p++)
        {
            ulong pair = pairs[p];
            ReadOnlySpan<int> other = corners.Slice(3 * Second(pair), 3);
            pairs[kept] = pair;
            bool fractions = false;
            foreach (int corner in corners.Slice(3 * First(pair), 3))
            {
                fractions |= corner == other[0] || corner == other[1] || corner == other[2];
            }

            kept += fractions ? 0 : 1;
        }

        return kept;
    }

    /// <summary>Keeps the pairs of triangles of one piece, where that is asked for.</summary>
    private int KeepOfOnePiece(ulong[] pairs, int count)
    {
        if (pieces is null)
        {
            return count;
        }

        ReadOnlySpan<int> corners = tree.Corners;
        int kept = 0;
        for (int p = 0; p < count; p++)
        {
            ulong pair = pairs[p];
            pairs[kept] = pair;
            kept += pieces[corners[3 * First(pair)]] == pieces[corners[3 * Second(pair)]] ? 1 : 0;
        }

        return kept;
    }

    private void Test(ReadOnlySpan<Vector3> positions, ulong[] pairs, int count)
    {
        if (count > 0 && !hasPlanes)
        {
            FindPlanes(positions);
        }

        ReadOnlySpan<float> coordinates = MemoryMarshal.Cast<Vector3, float>(positions);
        ReadOnlySpan<int> corners = tree.Corners;
        int kept = 0;
        for (int p = 0; p < count; p++)
        {
            ulong pair = pairs[p];
            pairs[kept] = pair;
            kept += MayStraddle(coordinates, planes.AsSpan(PlaneSize * First(pair), PlaneSize), corners.Slice(3 * Second(pair), 3), tolerance);
        }

        for (int p = 0; p < kept; p++)
        {
            ReadOnlySpan<int> s = corners.Slice(3 * First(pairs[p]), 3);
            ReadOnlySpan<int> t = corners.Slice(3 * Second(pairs[p]), 3);
            if (MayStraddle(coordinates, planes.AsSpan(PlaneSize * Second(pairs[p]), PlaneSize), s, tolerance) == 1)
            {
                int first = tree.Order[First(pairs[p])], second = tree.Order[Second(pairs[p])];
                tried.Add((first, second));
                if (Cross(positions, s, t))
                {
                    Add(first, second);
                }
            }
        }
    }

    private void FindPlanes(ReadOnlySpan<Vector3> positions)
    {
        hasPlanes = true;
        ReadOnlySpan<int> corners = tree.Corners;
        if (planes.Length < PlaneSize * tree.Count)
        {
            planes = new double[PlaneSize * tree.Count];
        }

        for (int s = 0; s < tree.Count; s++)
        {
            Vector3 a = positions[corners[3 * s]], b = positions[corners[(3 * s) + 1]], c = positions[corners[(3 * s) + 2]];
            double ax = a.X, ay = a.Y, az = a.Z;
            double ux = b.X - ax, uy = b.Y - ay, uz = b.Z - az;
            double vx = c.X - ax, vy = c.Y - ay, vz = c.Z - az;
            double nx = (uy * vz) - (uz * vy), ny = (uz * vx) - (ux * vz), nz = (ux * vy) - (uy * vx);
            Span<double> plane = planes.AsSpan(PlaneSize * s, PlaneSize);
            plane[0] = nx;
            plane[1] = ny;
            plane[2] = nz;
            plane[3] = (ax * nx) + (ay * ny) + (az * nz);
            plane[4] = Math.Abs(nx) + Math.Abs(ny) + Math.Abs(nz);
        }
    }

    /// <summary>
    /// Zero when all corners of a triangle are certainly on one side of a plane, as <see cref="TriangleCrossing"/> sees it, otherwise one.
    /// Does without the normal's length, whose root and quotients cost most of that test.
    /// </summary>
    private static int MayStraddle(ReadOnlySpan<float> coordinates, ReadOnlySpan<double> plane, ReadOnlySpan<int> triangle, double tolerance)
    {
        ReadOnlySpan<float> p = coordinates.Slice(3 * triangle[0], 3);
        ReadOnlySpan<float> q = coordinates.Slice(3 * triangle[1], 3);
        ReadOnlySpan<float> r = coordinates.Slice(3 * triangle[2], 3);
        double nx = plane[0], ny = plane[1], nz = plane[2], start = plane[3];
        double dp = (p[0] * nx) + (p[1] * ny) + (p[2] * nz) - start;
        double dq = (q[0] * nx) + (q[1] * ny) + (q[2] * nz) - start;
        double dr = (r[0] * nx) + (r[1] * ny) + (r[2] * nz) - start;
        double margin = tolerance * plane[4];
        double front = -ShortestNormal * margin;
        double behind = -LongestNormal * margin;
        return ((dp >= front) & (dq >= front) & (dr >= front)) | ((dp < behind) & (dq < behind) & (dr < behind)) ? 0 : 1;
    }

    private void Add(int one, int other)
    {
        if (foundCount == found.Length)
        {
            Array.Resize(ref found, 2 * foundCount);
        }

        found[foundCount++] = Pair(Math.Min(one, other), Math.Max(one, other));
    }

    private ulong[] PairsOf(int level) => pairsOfLevel[level] ??= new ulong[(Batch * Children * Children) + 1];

    private static ulong Pair(int first, int second) => ((ulong)(uint)first << 32) | (uint)second;

    private static int First(ulong pair) => (int)(pair >> 32);

    private static int Second(ulong pair) => (int)(uint)pair;
}
