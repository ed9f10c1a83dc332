using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Appearance;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Rigging;
using CreatureGen.Skinning;

namespace CreatureGen.Creatures;

/// <summary>Turns the welded surface and the pieces set on it into vertex buffers: splits vertices where texture charts part, and groups triangles by material.</summary>
internal static class MeshAssembler
{
    /// <summary>Builds the buffers, larger by a factor than what they are built from. Normals, colours and weights have one entry per vertex of the surface.</summary>
    public static CreatureMesh Assemble(Surface surface, Vector3[] normals, Vector3[] colours, SkinWeights[] weights, IReadOnlyList<Piece> pieces, Rig rig, float scale)
    {
        using var sources = new PooledList<int>(surface.Positions.Length * 3 / 2);
        using var splitTexcoords = new PooledList<Vector2>(surface.Positions.Length * 3 / 2);
        int vertices = 0;
        int skinIndices = surface.Triangles.Length;
        int membraneIndices = 0;
        foreach (Piece piece in pieces)
        {
            vertices += piece.Positions.Length;
            membraneIndices += piece.Material == MaterialKind.Membrane ? piece.Triangles.Length : 0;
            skinIndices += piece.Material == MaterialKind.Membrane ? 0 : piece.Triangles.Length;
        }

        int[] triangles = new int[skinIndices + membraneIndices];
        Split(surface, sources, splitTexcoords, triangles);
        vertices += sources.Count;
        var buffers = new Buffers(vertices);
        ReadOnlySpan<int> copied = sources.Items;
        splitTexcoords.Items.CopyTo(buffers.Texcoords);
        for (int v = 0; v < copied.Length; v++)
        {
            int source = copied[v];
            buffers.Positions[v] = surface.Positions[source] * scale;
            buffers.Normals[v] = normals[source];
            buffers.Colours[v] = colours[source];
            buffers.Weights[v] = weights[source];
        }

        int first = sources.Count;
        buffers.SimplificationWeight.AsSpan(0, first).Fill(1f);
        int nextSkin = surface.Triangles.Length;
        int nextMembrane = skinIndices;
        foreach (Piece piece in pieces)
        {
            SkinWeights[] followed = Follow(piece, weights, rig);
            buffers.SimplificationWeight.AsSpan(first, piece.Positions.Length).Fill(piece.SimplificationWeight);
            buffers.Texcoords.AsSpan(first, piece.Positions.Length).Fill(ChartPacking.Swatch((int)piece.Finish));
            for (int v = 0; v < piece.Positions.Length; v++)
            {
                buffers.Positions[first + v] = piece.Positions[v] * scale;
                buffers.Normals[first + v] = piece.Normals[v];
                buffers.Colours[first + v] = piece.Colours[v];
                buffers.Weights[first + v] = followed[followed.Length == 1 ? 0 : v];
            }

            ref int next = ref nextSkin;
            if (piece.Material == MaterialKind.Membrane)
            {
                next = ref nextMembrane;
            }

            foreach (int index in piece.Triangles)
            {
                triangles[next++] = first + index;
            }

            first += piece.Positions.Length;
        }

        var parts = new List<MeshPart> { new(MaterialKind.Skin, 0, skinIndices) };
        if (membraneIndices > 0)
        {
            parts.Add(new MeshPart(MaterialKind.Membrane, skinIndices, membraneIndices));
        }

        return new CreatureMesh(buffers.Positions, buffers.Normals, buffers.Texcoords, buffers.Colours, buffers.Weights, triangles, parts) { SimplificationWeight = buffers.SimplificationWeight };
    }

    /// <summary>The weights of a piece: one for each of its vertices, or a single one for all.</summary>
    private static SkinWeights[] Follow(Piece piece, SkinWeights[] surface, Rig rig)
    {
        switch (piece.Binding)
        {
            case PieceBinding.SurfaceVertex vertex:
                return new[] { surface[vertex.Index] };
            case PieceBinding.Skin skin:
                return Array.ConvertAll(skin.Indices, vertex => surface[vertex]);
            case PieceBinding.Chain chain:
                AppendageJoints joints = rig.Appendages[chain.Appendage];
                return ChainWeights.Solve(rig.Skeleton, chain.Side == Side.Right ? joints.Right : joints.Left, piece.Positions);
            case PieceBinding.Joint joint:
                return new[] { new SkinWeights(IndexOf(rig.Skeleton, joint.Name), 0, 0, 0, Vector4.UnitX) };
            default:
                throw new InvalidOperationException($"a piece is bound by {piece.Binding}; expected a joint, a vertex or vertices of the surface, or a chain");
        }
    }

    private static int IndexOf(Skeleton skeleton, string joint)
    {
        int index = skeleton.IndexOf(joint);
        return index >= 0 ? index : throw new InvalidOperationException($"a piece is bound to joint \"{joint}\", which the skeleton does not have");
    }

    /// <summary>Gives each vertex as many copies as it has places in the texture: adds what each copy is a copy of and its place, and writes the triangles.</summary>
    private static void Split(Surface surface, PooledList<int> sources, PooledList<Vector2> texcoords, int[] triangles)
    {
        ChartPacking packing = ChartPacking.Pack(surface);
        int[] firstCopy = new int[surface.Positions.Length];
        Array.Fill(firstCopy, -1);
        using var nextCopy = new PooledList<int>(surface.Positions.Length * 3 / 2);
        int at = 0;
        for (int f = 0; f < surface.Faces.Length; f++)
        {
            Face face = surface.Faces[f];
            FaceTexcoords t = surface.Texcoords[f];
            int a = Copy(face.A, t.A);
            int b = Copy(face.B, t.B);
            int c = Copy(face.C, t.C);
            triangles[at++] = a;
            triangles[at++] = b;
            triangles[at++] = c;
            if (face.D != face.C)
            {
                triangles[at++] = a;
                triangles[at++] = c;
                triangles[at++] = Copy(face.D, t.D);
            }

            int Copy(int vertex, Vector2 texcoord)
            {
                Vector2 uv = packing.Map(face.Chart, texcoord);
                int copy = firstCopy[vertex];
                while (copy >= 0 && texcoords[copy] != uv)
                {
                    copy = nextCopy[copy];
                }

                if (copy < 0)
                {
                    copy = sources.Count;
                    sources.Add(vertex);
                    texcoords.Add(uv);
                    nextCopy.Add(firstCopy[vertex]);
                    firstCopy[vertex] = copy;
                }

                return copy;
            }
        }
    }

    private sealed class Buffers
    {
        public Buffers(int vertices)
        {
            Positions = new Vector3[vertices];
            Normals = new Vector3[vertices];
            Texcoords = new Vector2[vertices];
            Colours = new Vector3[vertices];
            Weights = new SkinWeights[vertices];
            SimplificationWeight = new float[vertices];
        }

        public Vector3[] Positions { get; }

        public Vector3[] Normals { get; }

        public Vector2[] Texcoords { get; }

        public Vector3[] Colours { get; }

        public SkinWeights[] Weights { get; }

        public float[] SimplificationWeight { get; }
    }
}
