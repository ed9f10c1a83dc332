using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Bodies;
using CreatureGen.Features;
using CreatureGen.Geometry;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Creatures.Forks;

/// <summary>Eyes, teeth, horns and hair of a body that forks into two necks: those in front of the fork go along the left neck, and their mirror images along the right one.</summary>
internal sealed class ForkedPieces
{
    private readonly Surface one;
    private readonly ForkedSurface surface;
    private readonly ForkedRig rig;
    private readonly ForkCourse course;
    private readonly Skeleton skeleton;
    private readonly List<Piece> pieces = new();

    private ForkedPieces(Surface one, ForkedSurface surface, ForkedRig rig, ForkCourse course, Skeleton skeleton)
    {
        this.one = one;
        this.surface = surface;
        this.rig = rig;
        this.course = course;
        this.skeleton = skeleton;
    }

    /// <summary>All pieces of the forked body.</summary>
    /// <param name="pieces">Those of the unforked one.</param>
    /// <param name="one">The unforked surface.</param>
    /// <param name="surface">The forked one.</param>
    /// <param name="rig">The forked rig.</param>
    /// <param name="course">The way of the left neck.</param>
    /// <param name="skeleton">The unforked skeleton.</param>
    public static IReadOnlyList<Piece> Of(IReadOnlyList<Piece> pieces, Surface one, ForkedSurface surface, ForkedRig rig, ForkCourse course, Skeleton skeleton)
    {
        var forked = new ForkedPieces(one, surface, rig, course, skeleton);
        foreach (Piece piece in pieces)
        {
            forked.Add(piece);
        }

        return forked.pieces;
    }

    private void Add(Piece piece)
    {
        switch (piece.Binding)
        {
            case PieceBinding.Joint joint when rig.Second[skeleton.IndexOf(joint.Name)] is >= 0 and int second:
                AddBoth(piece, joint, new PieceBinding.Joint(rig.Rig.Skeleton.Joints[second].Name), null, ForkCourse.Rigid);
                break;
            case PieceBinding.Chain chain when rig.SecondAppendage[chain.Appendage] is >= 0 and int second:
                AddBoth(piece, chain, new PieceBinding.Chain(second, Opposite(chain.Side)), null, ForkCourse.Rigid);
                break;
            case PieceBinding.SurfaceVertex vertex when surface.IsDoubled(vertex.Index):
                AddBoth(piece, new PieceBinding.SurfaceVertex(surface.Left[vertex.Index]), new PieceBinding.SurfaceVertex(surface.Right[vertex.Index]), _ => vertex.Index, 0);
                break;
            case PieceBinding.SurfaceVertex vertex:
                pieces.Add(Moved(piece, new PieceBinding.SurfaceVertex(surface.Left[vertex.Index]), _ => vertex.Index, 0));
                break;
            case PieceBinding.Skin skin:
                AddHair(piece, skin);
                break;
            default:
                pieces.Add(piece);
                break;
        }
    }

    private void AddBoth(Piece piece, PieceBinding left, PieceBinding right, Func<int, int>? anchorOf, double ring)
    {
        Piece moved = Moved(piece, left, anchorOf, ring);
        pieces.Add(moved);
        pieces.Add(PieceMirror.Mirror(moved, right));
    }

    /// <summary>A piece as the left neck has it. Each of its vertices goes with the vertex of the surface that it sits on, or, where there is none, with the section at a ring.</summary>
    private Piece Moved(Piece piece, PieceBinding binding, Func<int, int>? anchorOf, double ring)
    {
        var positions = new Vector3[piece.Positions.Length];
        var normals = new Vector3[positions.Length];
        for (int v = 0; v < positions.Length; v++)
        {
            if (anchorOf == null)
            {
                positions[v] = course.Move(ring, piece.Positions[v]);
                normals[v] = Rotation.Rotate(course.TurnAt(ring), piece.Normals[v]);
                continue;
            }

            int anchor = anchorOf(v);
            bool doubled = surface.IsDoubled(anchor);
            double at = doubled ? one.Addresses[anchor].Ring : course.Ring;
            Vector3 away = piece.Positions[v] - one.Positions[anchor];
            positions[v] = surface.Surface.Positions[surface.Left[anchor]] + (doubled ? Rotation.Rotate(course.TurnAt(at), away * course.SizeAt(at)) : away);
            normals[v] = doubled ? Rotation.Rotate(course.TurnAt(at), piece.Normals[v]) : piece.Normals[v];
        }

        return Like(piece, binding, positions, normals, piece.Colours, piece.Triangles);
    }

    /// <summary>Adds hair: locks in front of the fork grow on both necks, those that reach behind it where they did.</summary>
    private void AddHair(Piece piece, PieceBinding.Skin skin)
    {
        int count = piece.Positions.Length;
        int[] parents = new int[count];
        var locks = new DisjointSets(parents);
        for (int i = 0; i < piece.Triangles.Length; i += 3)
        {
            locks.Join(piece.Triangles[i], piece.Triangles[i + 1]);
            locks.Join(piece.Triangles[i], piece.Triangles[i + 2]);
        }

        bool[] reaches = new bool[count];
        for (int v = 0; v < count; v++)
        {
            reaches[locks.Root(v)] |= !surface.IsDoubled(skin.Indices[v]);
        }

        bool[] chosen = new bool[count];
        for (int v = 0; v < count; v++)
        {
            chosen[v] = !reaches[locks.Root(v)];
        }

        if (Part(piece, skin, chosen, true) is (Piece ahead, int[] growing))
        {
            AddBoth(ahead, Bound(growing, surface.Left), Bound(growing, surface.Right), v => growing[v], 0);
        }

        if (Part(piece, skin, chosen, false) is (Piece behind, int[] staying))
        {
            int[] roots = Array.ConvertAll(staying, surface.Behind);
            pieces.Add(Moved(behind, Bound(roots, surface.Left), v => roots[v], 0));
        }
    }

    private static PieceBinding Bound(int[] indices, int[] now) => new PieceBinding.Skin(Array.ConvertAll(indices, v => now[v]));

    /// <summary>The locks of a piece that are chosen, or those that are not, with the vertices of the unforked surface that they grow on; null for none.</summary>
    private static (Piece Piece, int[] Indices)? Part(Piece piece, PieceBinding.Skin skin, bool[] chosen, bool which)
    {
        var vertices = new List<int>();
        int[] index = new int[chosen.Length];
        for (int v = 0; v < chosen.Length; v++)
        {
            if (chosen[v] == which)
            {
                index[v] = vertices.Count;
                vertices.Add(v);
            }
        }

        if (vertices.Count == 0)
        {
            return null;
        }

        var triangles = new List<int>();
        for (int i = 0; i < piece.Triangles.Length; i++)
        {
            if (chosen[piece.Triangles[i]] == which)
            {
                triangles.Add(index[piece.Triangles[i]]);
            }
        }

        int[] kept = vertices.ToArray();
        Piece part = Like(
            piece,
            skin,
            Array.ConvertAll(kept, v => piece.Positions[v]),
            Array.ConvertAll(kept, v => piece.Normals[v]),
            Array.ConvertAll(kept, v => piece.Colours[v]),
            triangles.ToArray());
        return (part, Array.ConvertAll(kept, v => skin.Indices[v]));
    }

    private static Piece Like(Piece piece, PieceBinding binding, Vector3[] positions, Vector3[] normals, Vector3[] colours, int[] triangles) => new(binding)
    {
        Positions = positions,
        Normals = normals,
        Colours = colours,
        Triangles = triangles,
        Material = piece.Material,
        Finish = piece.Finish,
        SimplificationWeight = piece.SimplificationWeight,
    };

    private static Anatomy.Side Opposite(Anatomy.Side side) => side == Anatomy.Side.Left ? Anatomy.Side.Right : Anatomy.Side.Left;
}
