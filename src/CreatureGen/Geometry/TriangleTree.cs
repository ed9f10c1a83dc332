using System;
using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Geometry;

/// <summary>
/// Triangles in an order in which neighbours are near, with the boxes of every four, sixteen, … of them. Buffers grow and are kept.
/// </summary>
/// <remarks>Based on: C. Lauterbach et al. 2009, "Fast BVH construction on GPUs" (linear hierarchy along the Z-order curve).</remarks>
internal sealed class TriangleTree
{
    /// <summary>Nodes of a level that the next one puts in one box.</summary>
    public const int Branching = 4;

    /// <summary>Enough levels for any number of triangles that an array can hold.</summary>
    public const int MaxLevels = 16;

    private const int RadixBits = 10;
    private const ulong NoCell = ulong.MaxValue;

    /// <summary>Lower corner of a box that meets none: no cell in use is that high.</summary>
    private static readonly ulong NoLow = BoxCode.Pack(BoxCode.MaxCoordinate, BoxCode.MaxCoordinate, BoxCode.MaxCoordinate);

    private readonly int[] levelStart = new int[MaxLevels + 1];
    private readonly int[] histogram = new int[3 << RadixBits];
    private ulong[] vertexCode = Array.Empty<ulong>();
    private ulong[] low = Array.Empty<ulong>();
    private ulong[] high = Array.Empty<ulong>();
    private int[] corners = Array.Empty<int>();
    private int[] order = Array.Empty<int>();
    private ulong[] triples = Array.Empty<ulong>();
    private int[] orderSpare = Array.Empty<int>();
    private uint[] curve = Array.Empty<uint>();

    /// <summary>Triangles in the tree: those whose corners are all finite.</summary>
    public int Count { get; private set; }

    /// <summary>Levels, from the triangles themselves (level 0) to the one of four nodes.</summary>
    public int Levels { get; private set; }

    /// <summary>Length of the diagonal of the box of all finite positions.</summary>
    public double Diagonal { get; private set; }

    /// <summary>False when there are so many vertices that different ones may be the same in <see cref="Triples"/>.</summary>
    public bool TriplesAreExact { get; private set; }

    /// <summary>The triangle in each slot.</summary>
    public ReadOnlySpan<int> Order => new(order, 0, Count);

    /// <summary>Three vertices for each slot.</summary>
    public ReadOnlySpan<int> Corners => new(corners, 0, 3 * Count);

    /// <summary>The three vertices of each slot, packed for <see cref="BoxCode.Distinct"/>.</summary>
    public ReadOnlySpan<ulong> Triples => new(triples, 0, Count);

    /// <summary>Lower corners of the boxes of a level; node n of a level holds nodes 4n … 4n+3 of the one below. Each level is filled up to a multiple of four with boxes that meet none.</summary>
    public ReadOnlySpan<ulong> Low(int level) => new(low, levelStart[level], levelStart[level + 1] - levelStart[level]);

    /// <summary>Upper corners of the boxes of a level, guarded.</summary>
    public ReadOnlySpan<ulong> High(int level) => new(high, levelStart[level], levelStart[level + 1] - levelStart[level]);

    /// <summary>Encloses the triangles, in their own order where that is good enough, otherwise sorted along the curve. Indices are in range.</summary>
    /// <param name="positions">One per vertex.</param>
    /// <param name="triangles">Vertex indices, three per triangle.</param>
    /// <param name="still">Which triangles are still, of which no two count as meeting; empty for none.</param>
    public void Build(ReadOnlySpan<Vector3> positions, ReadOnlySpan<int> triangles, ReadOnlySpan<bool> still = default)
    {
        Grow(positions.Length, triangles.Length / 3);
        TriplesAreExact = positions.Length <= BoxCode.MaxCoordinate + 1;
        Quantise(positions);
        Count = 0;
        for (int t = 0; t < triangles.Length / 3; t++)
        {
            if ((vertexCode[triangles[3 * t]] | vertexCode[triangles[(3 * t) + 1]] | vertexCode[triangles[(3 * t) + 2]]) != NoCell)
            {
                order[Count++] = t;
            }
        }

        Enclose(triangles, still);
        if (!IsCoherent())
        {
            Sort();
            Enclose(triangles, still);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong Pack(int i, int j, int k) => BoxCode.Pack(i & BoxCode.MaxCoordinate, j & BoxCode.MaxCoordinate, k & BoxCode.MaxCoordinate);

    private void Grow(int vertices, int triangles)
    {
        if (vertexCode.Length < vertices)
        {
            vertexCode = new ulong[vertices];
        }

        if (order.Length < triangles)
        {
            order = new int[triangles];
            orderSpare = new int[triangles];
            curve = new uint[triangles];
            corners = new int[3 * triangles];
            triples = new ulong[triangles];
            int nodes = 0;
            int level = triangles;
            do
            {
                level = (level + Branching - 1) / Branching;
                nodes += level * Branching;
            }
            while (level > 1);

            low = new ulong[nodes];
            high = new ulong[nodes];
        }
    }

    /// <summary>Cells of the positions. The grid keeps the order of coordinates, so that boxes that meet in space meet in cells.</summary>
    private void Quantise(ReadOnlySpan<Vector3> positions)
    {
        PointBounds box = PointBounds.Of(positions);
        Diagonal = box.Diagonal;
        double size = Math.Max(box.SizeX, Math.Max(box.SizeY, box.SizeZ));
        double scale = size > 0 ? (BoxCode.MaxCoordinate - 1) / size : 0;
        double x = box.Min.X, y = box.Min.Y, z = box.Min.Z;
        for (int v = 0; v < positions.Length; v++)
        {
            Vector3 p = positions[v];
            vertexCode[v] = TriangleList.IsFinite(p)
                ? BoxCode.Pack((int)((p.X - x) * scale), (int)((p.Y - y) * scale), (int)((p.Z - z) * scale))
                : NoCell;
        }
    }

    /// <summary>True when the boxes of 64 consecutive triangles are hardly larger than those of a compact patch, eight triangles wide.</summary>
    private bool IsCoherent()
    {
        const int Level = 3;
        const double WidthOfPatch = 8;
        const double Slack = 1.5;
        if (Levels <= Level)
        {
            return true;
        }

        return MeanExtent(Level) <= Slack * WidthOfPatch * MeanExtent(0);
    }

    private double MeanExtent(int level)
    {
        int boxes = Count;
        for (int l = 0; l < level; l++)
        {
            boxes = (boxes + Branching - 1) / Branching;
        }

        long sum = 0;
        for (int n = levelStart[level]; n < levelStart[level] + boxes; n++)
        {
            sum += BoxCode.Extent(low[n], high[n]);
        }

        return (double)sum / boxes;
    }

    /// <summary>Radix sort by the place of the boxes on the curve; equal places keep the order of the triangles.</summary>
    private void Sort()
    {
        const int Mask = (1 << RadixBits) - 1;
        Span<int> counts = histogram;
        counts.Clear();
        for (int s = 0; s < Count; s++)
        {
            uint code = BoxCode.Morton(low[s], high[s]);
            curve[order[s]] = code;
            counts[(int)(code & Mask)]++;
            counts[(1 << RadixBits) + (int)((code >> RadixBits) & Mask)]++;
            counts[(2 << RadixBits) + (int)(code >> (2 * RadixBits))]++;
        }

        for (int pass = 0; pass < 3; pass++)
        {
            Span<int> next = counts.Slice(pass << RadixBits, 1 << RadixBits);
            int sum = 0;
            for (int i = 0; i < next.Length; i++)
            {
                int n = next[i];
                next[i] = sum;
                sum += n;
            }

            int shift = pass * RadixBits;
            for (int s = 0; s < Count; s++)
            {
                int t = order[s];
                orderSpare[next[(int)((curve[t] >> shift) & Mask)]++] = t;
            }

            (order, orderSpare) = (orderSpare, order);
        }
    }

    private void Enclose(ReadOnlySpan<int> triangles, ReadOnlySpan<bool> still)
    {
        for (int s = 0; s < Count; s++)
        {
            int t = 3 * order[s];
            int i = triangles[t], j = triangles[t + 1], k = triangles[t + 2];
            corners[3 * s] = i;
            corners[(3 * s) + 1] = j;
            corners[(3 * s) + 2] = k;
            ulong a = vertexCode[i], b = vertexCode[j], c = vertexCode[k];
            low[s] = BoxCode.Min(a, BoxCode.Min(b, c));
            high[s] = BoxCode.Mark(BoxCode.Max(a, BoxCode.Max(b, c)), !still.IsEmpty && still[order[s]]);
            triples[s] = Pack(i, j, k);
        }

        Levels = 1;
        int begin = 0;
        int end = Pad(Count);
        levelStart[1] = end;
        while (end - begin > Branching)
        {
            int at = end;
            for (int first = begin; first < end; first += Branching)
            {
                low[at] = BoxCode.Min(BoxCode.Min(low[first], low[first + 1]), BoxCode.Min(low[first + 2], low[first + 3]));
                ulong box = BoxCode.Max(BoxCode.Max(high[first], high[first + 1]), BoxCode.Max(high[first + 2], high[first + 3]));
                high[at++] = BoxCode.MarkAsAll(box, high[first], high[first + 1], high[first + 2], high[first + 3]);
            }

            begin = end;
            end = Pad(at);
            levelStart[++Levels] = end;
        }

        for (int n = 0; n < end; n++)
        {
            high[n] = BoxCode.Guard(high[n]);
        }
    }

    /// <summary>Fills a level up to a multiple of four nodes with boxes beyond the last cell in use, and gives its new end.</summary>
    private int Pad(int end)
    {
        while (end % Branching != 0)
        {
            low[end] = NoLow;
            high[end++] = BoxCode.Mark(0, true);
        }

        return end;
    }
}
