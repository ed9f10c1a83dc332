using System.Numerics;
using System;
using CreatureGen.Geometry;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>
/// Collects the vertices and triangles of one <see cref="Piece"/>. Shapes append closed shells; several shells can share a piece.
/// </summary>
/// <remarks>One builder can be cleared and used again, so that the buffers are allocated once for all pieces of a creature.</remarks>
internal sealed class PieceBuilder
{
    private const int FewTriangles = 64;

    private Vector3[] positions = new Vector3[512];
    private Vector3[] normals = new Vector3[512];
    private Vector3[] colours = new Vector3[512];
    private int[] triangles = new int[3072];
    private SurfaceFinish finish;

    /// <summary>Number of vertices so far.</summary>
    public int VertexCount { get; private set; }

    /// <summary>Number of indices so far.</summary>
    public int IndexCount { get; private set; }

    /// <summary>Place of a vertex.</summary>
    public Vector3 Position(int vertex) => positions[vertex];

    /// <summary>Normal of a vertex.</summary>
    public Vector3 Normal(int vertex) => normals[vertex];

    /// <summary>Begins another piece: forgets all vertices and triangles, keeps the buffers.</summary>
    /// <param name="finish">What the next piece feels like.</param>
    public void Clear(SurfaceFinish finish = SurfaceFinish.Skin)
    {
        this.finish = finish;
        VertexCount = 0;
        IndexCount = 0;
    }

    /// <summary>Adds a vertex and returns its index; colours are limited to 0..1.</summary>
    public int Vertex(Vector3 position, Vector3 normal, Vector3 colour)
    {
        if (VertexCount == positions.Length)
        {
            Array.Resize(ref positions, 2 * VertexCount);
            Array.Resize(ref normals, 2 * VertexCount);
            Array.Resize(ref colours, 2 * VertexCount);
        }

        positions[VertexCount] = position;
        normals[VertexCount] = normal;
        SetColour(VertexCount, colour);
        return VertexCount++;
    }

    /// <summary>Gives a vertex its normal after its neighbours are known.</summary>
    public void SetNormal(int vertex, Vector3 normal) => normals[vertex] = normal;

    /// <summary>Gives a vertex another colour, limited to 0..1.</summary>
    public void SetColour(int vertex, Vector3 colour) =>
        colours[vertex] = new Vector3(Scalar.Clamp(colour.X, 0f, 1f), Scalar.Clamp(colour.Y, 0f, 1f), Scalar.Clamp(colour.Z, 0f, 1f));

    /// <summary>Adds a triangle, counter-clockwise seen from outside.</summary>
    public void Triangle(int a, int b, int c)
    {
        if (IndexCount + 3 > triangles.Length)
        {
            Array.Resize(ref triangles, 2 * triangles.Length);
        }

        triangles[IndexCount++] = a;
        triangles[IndexCount++] = b;
        triangles[IndexCount++] = c;
    }

    /// <summary>Adds a quad, counter-clockwise seen from outside, split between its first and third corner.</summary>
    public void Quad(int a, int b, int c, int d)
    {
        Triangle(a, b, c);
        Triangle(a, c, d);
    }

    /// <summary>
    /// Joins two closed rings of <paramref name="count"/> consecutive vertices each. Seen from outside, the second ring lies above the first
    /// when the vertices of both run to the right.
    /// </summary>
    public void Band(int ring, int next, int count)
    {
        for (int k = 0; k < count; k++)
        {
            int k2 = k + 1 == count ? 0 : k + 1;
            Quad(ring + k, ring + k2, next + k2, next + k);
        }
    }

    /// <summary>Joins a closed ring to a single vertex above it.</summary>
    public void Fan(int ring, int pole, int count)
    {
        for (int k = 0; k < count; k++)
        {
            Triangle(ring + k, ring + (k + 1 == count ? 0 : k + 1), pole);
        }
    }

    /// <summary>Joins a closed ring to a single vertex below it.</summary>
    public void FanBelow(int ring, int pole, int count)
    {
        for (int k = 0; k < count; k++)
        {
            Triangle(ring + (k + 1 == count ? 0 : k + 1), ring + k, pole);
        }
    }

    /// <summary>Fills a closed ring from below with triangles among its own vertices.</summary>
    public void FillBelow(int ring, int count)
    {
        // A strip from both sides of the first vertex, so that a mirrored ring is filled in mirror image wherever the count allows it.
        int low = 0;
        int high = count - 1;
        bool advanceLow = true;
        while (high - low > 1)
        {
            if (advanceLow)
            {
                Triangle(ring + low, ring + high, ring + low + 1);
                low++;
            }
            else
            {
                Triangle(ring + low, ring + high, ring + high - 1);
                high--;
            }

            advanceLow = !advanceLow;
        }
    }

    /// <summary>
    /// Adds the mirror image (x → −x) of everything that was added since the given vertex and index, with the winding reversed.
    /// </summary>
    public void AppendMirrored(int firstVertex, int firstIndex)
    {
        int vertexEnd = VertexCount;
        int indexEnd = IndexCount;
        int offset = vertexEnd - firstVertex;
        for (int v = firstVertex; v < vertexEnd; v++)
        {
            Vertex(Vec.Mirror(positions[v]), Vec.Mirror(normals[v]), colours[v]);
        }

        for (int i = firstIndex; i < indexEnd; i += 3)
        {
            Triangle(triangles[i] + offset, triangles[i + 2] + offset, triangles[i + 1] + offset);
        }
    }

    /// <summary>Makes what was added since the given vertex its own mirror image to the last bit, where it is so but for rounding.</summary>
    /// <param name="firstVertex">The first of the vertices.</param>
    /// <param name="tolerance">How far a vertex may be from the mirror image of another, metres; less than half the distance between neighbours.</param>
    public void Symmetrise(int firstVertex, float tolerance)
    {
        for (int v = firstVertex; v < VertexCount; v++)
        {
            if (Math.Abs(positions[v].X) <= tolerance)
            {
                positions[v].X = 0f;
            }
        }

        for (int v = firstVertex; v < VertexCount; v++)
        {
            for (int u = firstVertex; u < VertexCount && positions[v].X > 0f; u++)
            {
                Vector3 image = Vec.Mirror(positions[v]);
                if (positions[u].X < 0f && Vec.Distance(positions[u], image) <= tolerance)
                {
                    positions[u] = image;
                }
            }
        }
    }

    /// <summary>A piece with copies of the collected arrays; the builder keeps its content.</summary>
    /// <param name="material">What it is made of.</param>
    /// <param name="binding">What it moves with.</param>
    /// <param name="simplificationWeight">How much larger a viewer takes it for than it is.</param>
    /// <exception cref="InvalidOperationException">A position or normal is not a finite number.</exception>
    public Piece ToPiece(MaterialKind material, PieceBinding binding, float simplificationWeight = 1f)
    {
        for (int v = 0; v < VertexCount; v++)
        {
            float sum = Vec.LengthSquared(positions[v]) + Vec.LengthSquared(normals[v]);
            if (float.IsNaN(sum) || float.IsInfinity(sum))
            {
                throw new InvalidOperationException(FormattableString.Invariant(
                    $"vertex {v} of a piece is at {positions[v]} with normal {normals[v]}; expected finite numbers (is a length or radius of its feature zero?)"));
            }
        }

        return new Piece(binding)
        {
            Positions = positions.AsSpan(0, VertexCount).ToArray(),
            Normals = normals.AsSpan(0, VertexCount).ToArray(),
            Colours = colours.AsSpan(0, VertexCount).ToArray(),
            Triangles = QuickToDraw(),
            Finish = finish,
            Material = material,
            SimplificationWeight = simplificationWeight,
        };
    }

    /// <summary>The triangles in an order in which a graphics card finds most vertices still transformed. Locks of hair, and claws and other pieces as small, are so narrow that they are in one already.</summary>
    private int[] QuickToDraw()
    {
        ReadOnlySpan<int> added = triangles.AsSpan(0, IndexCount);
        if (finish == SurfaceFinish.Hair || IndexCount < 3 * FewTriangles)
        {
            return added.ToArray();
        }

        int[] ordered = new int[IndexCount];
        VertexCacheOrder.Triangles(VertexCount, added, ordered);
        return ordered;
    }
}
