using System;
using System.Numerics;

namespace CreatureGen.Geometry;

/// <summary>A finished closed surface: every vertex is one point, whatever its texture.</summary>
internal sealed class Surface
{
    private Surface(Vector3[] positions, VertexAddress[] addresses, int[] mirror, Face[] faces, FaceTexcoords[] texcoords, int charts)
    {
        Positions = positions;
        Addresses = addresses;
        Mirror = mirror;
        Faces = faces;
        Texcoords = texcoords;
        Charts = charts;
        Triangles = Triangulate(faces);
    }

    /// <summary>Model space, metres; later stages move the points in place until the creature is finished.</summary>
    public Vector3[] Positions { get; }

    public VertexAddress[] Addresses { get; }

    /// <summary>The vertex on the other side of the sagittal plane; a vertex on the plane is its own.</summary>
    public int[] Mirror { get; }

    public Face[] Faces { get; }

    /// <summary>One per face.</summary>
    public FaceTexcoords[] Texcoords { get; }

    public int Charts { get; }

    /// <summary>Vertex indices, three per triangle, in the order of the faces; a quad splits along its first and third corner.</summary>
    public int[] Triangles { get; }

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
        return new Surface(positions, addresses, mirror, faces, builder.Texcoords.ToArray(), builder.Charts);
    }

    private static int[] Triangulate(Face[] faces)
    {
        int count = 0;
        foreach (Face face in faces)
        {
            count += face.D == face.C ? 3 : 6;
        }

        int[] triangles = new int[count];
        int at = 0;
        foreach (Face face in faces)
        {
            triangles[at++] = face.A;
            triangles[at++] = face.B;
            triangles[at++] = face.C;
            if (face.D != face.C)
            {
                triangles[at++] = face.A;
                triangles[at++] = face.C;
                triangles[at++] = face.D;
            }
        }

        return triangles;
    }
}
