using System;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>A finished closed surface: every vertex is one point, whatever its texture.</summary>
/// <remarks>Its two longest lists lie in memory borrowed from the pool, as arrays of their own they would be a quarter of what brings about full collections of garbage. Who knows that nobody asks for them any more disposes of it.</remarks>
internal sealed class Surface : IDisposable
{
    private readonly PooledList<FaceTexcoords> texcoords;
    private readonly PooledList<int> triangles;

    private Surface(Vector3[] positions, VertexAddress[] addresses, int[] mirror, Face[] faces, ReadOnlySpan<FaceTexcoords> texcoords, int charts)
    {
        Positions = positions;
        Addresses = addresses;
        Mirror = mirror;
        Faces = faces;
        this.texcoords = new PooledList<FaceTexcoords>(texcoords.Length);
        this.texcoords.AddRange(texcoords);
        Charts = charts;
        triangles = Triangulate(faces);
    }

    /// <summary>Model space, metres; later stages move the points in place until the creature is finished.</summary>
    public Vector3[] Positions { get; }

    public VertexAddress[] Addresses { get; }

    /// <summary>The vertex on the other side of the sagittal plane; a vertex on the plane is its own.</summary>
    public int[] Mirror { get; }

    public Face[] Faces { get; }

    /// <summary>One per face.</summary>
    public ReadOnlySpan<FaceTexcoords> Texcoords => texcoords.Items;

    public int Charts { get; }

    /// <summary>Vertex indices, three per triangle, in the order of the faces; a quad splits along its first and third corner.</summary>
    public ReadOnlySpan<int> Triangles => triangles.Items;

    /// <summary>Takes the vertices that faces use, in their order, and gives for each old vertex its new index or −1.</summary>
    public static Surface From(SurfaceBuilder builder, out int[] newIndex)
    {
        ReadOnlySpan<Vector3> oldPositions = builder.Positions.Items;
        ReadOnlySpan<VertexAddress> oldAddresses = builder.Addresses.Items;
        ReadOnlySpan<int> oldMirror = builder.Mirror.Items;
        ReadOnlySpan<Face> oldFaces = builder.Faces.Items;
        int[] index = new int[oldPositions.Length];
        foreach (ref readonly Face face in oldFaces)
        {
            index[face.A] = index[face.B] = index[face.C] = index[face.D] = 1;
        }

        int count = 0;
        for (int i = 0; i < index.Length; i++)
        {
            index[i] = index[i] == 1 ? count++ : -1;
        }

        var positions = new Vector3[count];
        var addresses = new VertexAddress[count];
        int[] mirror = new int[count];
        for (int i = 0; i < index.Length; i++)
        {
            int at = index[i];
            if (at >= 0)
            {
                positions[at] = oldPositions[i];
                addresses[at] = oldAddresses[i];
                mirror[at] = index[oldMirror[i]];
            }
        }

        var faces = new Face[oldFaces.Length];
        for (int f = 0; f < faces.Length; f++)
        {
            ref readonly Face face = ref oldFaces[f];
            faces[f] = new Face(index[face.A], index[face.B], index[face.C], index[face.D], face.Chart);
        }

        newIndex = index;
        return new Surface(positions, addresses, mirror, faces, builder.Texcoords.Items, builder.Charts);
    }

    /// <inheritdoc/>
    public void Dispose()
    {
        texcoords.Dispose();
        triangles.Dispose();
    }

    private static PooledList<int> Triangulate(Face[] faces)
    {
        var triangles = new PooledList<int>(6 * faces.Length);
        foreach (Face face in faces)
        {
            triangles.Add(face.A);
            triangles.Add(face.B);
            triangles.Add(face.C);
            if (face.D != face.C)
            {
                triangles.Add(face.A);
                triangles.Add(face.C);
                triangles.Add(face.D);
            }
        }

        return triangles;
    }
}
