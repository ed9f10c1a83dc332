using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>What a vertex of the surface belongs to.</summary>
internal enum SurfaceRegion : byte
{
    Body,
    Nose,
    Lip,
    Mouth,
    Leg,
    Toe,
    Hoof,
    Wing,
    Fin,
    Ear,
    EarInside,
}

/// <summary>Where a vertex of the surface lies, in anatomy instead of in space.</summary>
internal struct VertexAddress
{
    /// <summary>What it belongs to.</summary>
    public SurfaceRegion Region;

    /// <summary>Index of its appendage, −1 for the body. The mirrored vertex has the same appendage and a negative <see cref="Sign"/>.</summary>
    public short Appendage;

    /// <summary>+1 on the left (+X) and on the midline, −1 on the right.</summary>
    public sbyte Sign;

    /// <summary>0..1 along the appendage from its socket (path length), or along the body from nose to tail (arc length).</summary>
    public float Along;

    /// <summary>Radians around the appendage (0 front, π/2 towards larger segments), or around the body (0 dorsal, π/2 left).</summary>
    public float Around;

    /// <summary>Ring of the body grid; of an appendage's vertex, the ring of the socket's border that it grew from.</summary>
    public float Ring;

    /// <summary>Segment of the body grid; of an appendage's vertex, the segment of the socket's border that it grew from.</summary>
    public float Segment;
}

/// <summary>A face of the surface: four vertices counter-clockwise seen from outside; a triangle repeats its third.</summary>
internal readonly struct Face
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Face(int a, int b, int c, int d, int chart)
    {
        A = a;
        B = b;
        C = c;
        D = d;
        Chart = chart;
    }

    public int A { get; }

    public int B { get; }

    public int C { get; }

    public int D { get; }

    /// <summary>The texture chart it is drawn in.</summary>
    public int Chart { get; }
}

/// <summary>The texture coordinates of a face's corners within its chart: u around, v along, metres.</summary>
internal readonly struct FaceTexcoords
{
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FaceTexcoords(Vector2 a, Vector2 b, Vector2 c, Vector2 d)
    {
        A = a;
        B = b;
        C = c;
        D = d;
    }

    public Vector2 A { get; }

    public Vector2 B { get; }

    public Vector2 C { get; }

    public Vector2 D { get; }
}

/// <summary>A closed surface under construction: points, their addresses, their mirror images, and faces. Disposing gives its memory back to the pool.</summary>
internal sealed class SurfaceBuilder : IDisposable
{
    // What most creatures need; larger ones grow.
    private const int Capacity = 8192;

    /// <summary>Model space, metres at scale 1.</summary>
    public PooledList<Vector3> Positions { get; } = new(Capacity);

    /// <summary>One per position.</summary>
    public PooledList<VertexAddress> Addresses { get; } = new(Capacity);

    /// <summary>The vertex on the other side of the sagittal plane; a vertex on the plane is its own.</summary>
    public PooledList<int> Mirror { get; } = new(Capacity);

    /// <summary>All faces.</summary>
    public PooledList<Face> Faces { get; } = new(Capacity);

    /// <summary>One per face.</summary>
    public PooledList<FaceTexcoords> Texcoords { get; } = new(Capacity);

    /// <summary>Number of texture charts handed out.</summary>
    public int Charts { get; private set; }

    /// <summary>A new texture chart.</summary>
    public int NewChart() => Charts++;

    /// <summary>Adds a vertex that is its own mirror image until told otherwise.</summary>
    public int Add(Vector3 position, in VertexAddress address)
    {
        Positions.Add(position);
        Addresses.Add(address);
        Mirror.Add(Positions.Count - 1);
        return Positions.Count - 1;
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        Positions.Dispose();
        Addresses.Dispose();
        Mirror.Dispose();
        Faces.Dispose();
        Texcoords.Dispose();
    }

    /// <summary>Makes two vertices mirror images of one another.</summary>
    public void Pair(int left, int right)
    {
        Mirror[left] = right;
        Mirror[right] = left;
    }

    /// <summary>Adds a face of four vertices.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Quad(int a, int b, int c, int d, int chart, FaceTexcoords texcoords)
    {
        Faces.Add(new Face(a, b, c, d, chart));
        Texcoords.Add(texcoords);
    }

    /// <summary>
    /// Adds the mirror image of everything that was added since the given counts. Vertices that were there before stand for their own mirror images.
    /// The faces keep their chart: left and right share their texture.
    /// </summary>
    public void MirrorSince(int vertexCount, int faceCount)
    {
        int lastVertex = Positions.Count;
        for (int v = vertexCount; v < lastVertex; v++)
        {
            VertexAddress address = Addresses[v];
            address.Sign = (sbyte)-address.Sign;
            Pair(v, Add(Vec.Mirror(Positions[v]), address));
        }

        int lastFace = Faces.Count;
        for (int f = faceCount; f < lastFace; f++)
        {
            Face face = Faces[f];
            FaceTexcoords t = Texcoords[f];

            // Reversed, and turned by one corner so that both halves split along mirrored diagonals.
            Quad(Mirror[face.A], Mirror[face.D], Mirror[face.C], Mirror[face.B], face.Chart, new FaceTexcoords(t.A, t.D, t.C, t.B));
        }
    }
}
