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
        ChartPacking packing = ChartPacking.Pack(surface);
        int capacity = surface.Positions.Length * 5 / 4;
        foreach (Piece piece in pieces)
        {
            capacity += piece.Positions.Length;
        }

        var buffers = new Buffers(capacity);
        int[] skin = Split(surface, packing, normals, colours, weights, buffers);
        var triangles = new List<int>(skin.Length * 5 / 4);
        triangles.AddRange(skin);
        var membranes = new List<int>();
        foreach (Piece piece in pieces)
        {
            int first = buffers.Positions.Count;
            SkinWeights[] followed = Follow(piece, weights, rig);
            for (int v = 0; v < piece.Positions.Length; v++)
            {
                buffers.Add(piece.Positions[v], piece.Normals[v], Vector2.Zero, piece.Colours[v], followed[followed.Length == 1 ? 0 : v]);
            }

            List<int> target = piece.Material == MaterialKind.Membrane ? membranes : triangles;
            foreach (int index in piece.Triangles)
            {
                target.Add(first + index);
            }
        }

        var parts = new List<MeshPart> { new(MaterialKind.Skin, 0, triangles.Count) };
        if (membranes.Count > 0)
        {
            parts.Add(new MeshPart(MaterialKind.Membrane, triangles.Count, membranes.Count));
            triangles.AddRange(membranes);
        }

        Vector3[] positions = buffers.Positions.ToArray();
        for (int v = 0; v < positions.Length; v++)
        {
            positions[v] *= scale;
        }

        return new CreatureMesh(
            positions,
            buffers.Normals.ToArray(),
            buffers.Texcoords.ToArray(),
            buffers.Colours.ToArray(),
            buffers.Weights.ToArray(),
            triangles.ToArray(),
            parts);
    }

    /// <summary>The weights of a piece: one for each of its vertices, or a single one for all.</summary>
    private static SkinWeights[] Follow(Piece piece, SkinWeights[] surface, Rig rig)
    {
        switch (piece.Binding)
        {
            case PieceBinding.Surface:
                return new[] { surface[piece.SurfaceVertex] };
            case PieceBinding.Chain:
                AppendageJoints joints = rig.Appendages[piece.Appendage];
                return ChainWeights.Solve(rig.Skeleton, piece.Side == Side.Right ? joints.Right : joints.Left, piece.Positions);
            default:
                return new[] { new SkinWeights(IndexOf(rig.Skeleton, piece.JointName), 0, 0, 0, Vector4.UnitX) };
        }
    }

    private static int IndexOf(Skeleton skeleton, string joint)
    {
        int index = skeleton.IndexOf(joint);
        return index >= 0 ? index : throw new InvalidOperationException($"a piece is bound to joint \"{joint}\", which the skeleton does not have");
    }

    private static int[] Split(Surface surface, ChartPacking packing, Vector3[] normals, Vector3[] colours, SkinWeights[] weights, Buffers buffers)
    {
        int[] firstCopy = new int[surface.Positions.Length];
        Array.Fill(firstCopy, -1);
        var nextCopy = new List<int>(surface.Positions.Length * 5 / 4);
        int[] triangles = new int[surface.Triangles.Length];
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
                while (copy >= 0 && buffers.Texcoords[copy] != uv)
                {
                    copy = nextCopy[copy];
                }

                if (copy < 0)
                {
                    copy = buffers.Positions.Count;
                    buffers.Add(surface.Positions[vertex], normals[vertex], uv, colours[vertex], weights[vertex]);
                    nextCopy.Add(firstCopy[vertex]);
                    firstCopy[vertex] = copy;
                }

                return copy;
            }
        }

        return triangles;
    }

    private sealed class Buffers
    {
        public Buffers(int capacity)
        {
            Positions = new List<Vector3>(capacity);
            Normals = new List<Vector3>(capacity);
            Texcoords = new List<Vector2>(capacity);
            Colours = new List<Vector3>(capacity);
            Weights = new List<SkinWeights>(capacity);
        }

        public List<Vector3> Positions { get; }

        public List<Vector3> Normals { get; }

        public List<Vector2> Texcoords { get; }

        public List<Vector3> Colours { get; }

        public List<SkinWeights> Weights { get; }

        public void Add(Vector3 position, Vector3 normal, Vector2 texcoord, Vector3 colour, SkinWeights weights)
        {
            Positions.Add(position);
            Normals.Add(normal);
            Texcoords.Add(texcoord);
            Colours.Add(colour);
            Weights.Add(weights);
        }
    }
}
