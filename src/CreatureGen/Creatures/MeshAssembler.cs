using System;
using System.Collections.Generic;
using System.Numerics;
using System.Runtime.CompilerServices;
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
    /// <summary>Builds the buffers, larger by a factor than what they are built from.</summary>
    public static CreatureMesh Assemble(Body body, float scale)
    {
        (Surface surface, Vector3[] normals, Vector3[] colours, SkinWeights[] weights, IReadOnlyList<Piece> pieces, Rig rig) = body;
        using var copies = new PooledList<SkinCopy>(surface.Positions.Length * 3 / 2);
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
        Split(surface, copies, triangles);
        vertices += copies.Count;
        var buffers = new Buffers(vertices);
        ReadOnlySpan<SkinCopy> copied = copies.Items;
        for (int v = 0; v < copied.Length; v++)
        {
            int source = copied[v].Source;
            buffers.Positions[v] = surface.Positions[source] * scale;
            buffers.Normals[v] = normals[source];
            buffers.Texcoords[v] = copied[v].Texcoord;
            buffers.Colours[v] = colours[source];
            buffers.Weights[v] = weights[source];
        }

        int first = copies.Count;
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

    /// <summary>Gives each vertex as many copies as it has places in the texture, and writes the triangles.</summary>
    private static void Split(Surface surface, PooledList<SkinCopy> copies, int[] triangles)
    {
        ChartPacking packing = ChartPacking.Pack(surface);
        int[] lastCopy = new int[surface.Positions.Length];
        Array.Fill(lastCopy, -1);
        int at = 0;
        ReadOnlySpan<FaceTexcoords> texcoords = surface.Texcoords;
        for (int f = 0; f < surface.Faces.Length; f++)
        {
            Face face = surface.Faces[f];
            FaceTexcoords t = texcoords[f];
            int a = CopyAt(copies, lastCopy, face.A, packing.Map(face.Chart, t.A));
            int b = CopyAt(copies, lastCopy, face.B, packing.Map(face.Chart, t.B));
            int c = CopyAt(copies, lastCopy, face.C, packing.Map(face.Chart, t.C));
            triangles[at++] = a;
            triangles[at++] = b;
            triangles[at++] = c;
            if (face.D != face.C)
            {
                triangles[at++] = a;
                triangles[at++] = c;
                triangles[at++] = CopyAt(copies, lastCopy, face.D, packing.Map(face.Chart, t.D));
            }
        }
    }

    /// <summary>The copy of a vertex at a place in the texture; a new one where there is none.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static int CopyAt(PooledList<SkinCopy> copies, int[] lastCopy, int vertex, Vector2 texcoord)
    {
        ReadOnlySpan<SkinCopy> known = copies.Items;
        int copy = lastCopy[vertex];
        while (copy >= 0 && known[copy].Texcoord != texcoord)
        {
            copy = known[copy].Before;
        }

        if (copy < 0)
        {
            copy = copies.Count;
            copies.Add(new SkinCopy(vertex, lastCopy[vertex], texcoord));
            lastCopy[vertex] = copy;
        }

        return copy;
    }

    /// <summary>A vertex of the surface at one of its places in the texture. What is known of a copy lies together, for it is asked together, four times a face.</summary>
    private readonly struct SkinCopy
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public SkinCopy(int source, int before, Vector2 texcoord)
        {
            Source = source;
            Before = before;
            Texcoord = texcoord;
        }

        public int Source { get; }

        /// <summary>The copy of the same vertex that was made before this one, −1 for the first.</summary>
        public int Before { get; }

        public Vector2 Texcoord { get; }
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
