using System;
using System.Collections.Generic;
using CreatureGen.Geometry;

namespace CreatureGen.Creatures;

/// <summary>Which points and drawn vertices stand for those that have gone in a reduction.</summary>
internal sealed class ReductionRemap : IDisposable
{
    private readonly ReductionSubject subject;
    private readonly int[] points;
    private readonly int[] vertices;
    private readonly SavedArrays saved;

    /// <summary>Every point and every vertex stands for itself.</summary>
    public ReductionRemap(ReductionSubject subject)
    {
        this.subject = subject;
        points = Identity(subject.Points);
        vertices = Identity(subject.PointOf.Length);
        saved = new SavedArrays(points, vertices);
    }

    /// <summary>Whether a point has gone.</summary>
    public bool HasGone(int point) => points[point] != point;

    /// <summary>The point that stands for one now.</summary>
    public int PointFor(int point) => End(point, points);

    /// <summary>Lets a point stand for another one, and its vertices for those of the other.</summary>
    public void Take(int from, int to, List<(int From, int To)> matched)
    {
        points[from] = to;
        foreach ((int vertex, int other) in matched)
        {
            vertices[vertex] = other;
        }
    }

    /// <summary>For each vertex of the mesh the one that stands for it, −1 when its piece is lost.</summary>
    public int[] Final(CollapsingMesh surface, ReductionPieces pieces, StepChoice choice)
    {
        bool[] used = new bool[vertices.Length];
        for (int c = 0; c < subject.Vertices.Length; c++)
        {
            used[subject.Vertices[c]] |= !surface.IsGone(c / 3);
        }

        int[] final = Identity(vertices.Length);
        for (int v = 0; v < final.Length; v++)
        {
            if (subject.PointOf[v] >= 0)
            {
                int point = End(subject.PointOf[v], points);
                points[subject.PointOf[v]] = point;

                // The last triangle of a vertex may have gone while its point stayed with others.
                int at = End(v, vertices);
                vertices[v] = at;
                final[v] = pieces.Lost[subject.PieceOf[point]] ? -1 : used[at] ? at : choice.MaxAlike(v, point);
            }
        }

        int[] images = subject.Half.Image;
        for (int v = 0; v < final.Length; v++)
        {
            if (images[v] >= 0 && images[v] != v)
            {
                final[images[v]] = final[v] < 0 ? -1 : images[final[v]];
            }
        }

        return final;
    }

    /// <summary>Keeps what stands for what.</summary>
    public void Save() => saved.Save();

    /// <summary>Puts that back to what it was when it was kept.</summary>
    public void Restore() => saved.Restore();

    /// <inheritdoc/>
    public void Dispose() => saved.Dispose();

    private static int[] Identity(int count)
    {
        int[] identity = new int[count];
        for (int i = 0; i < count; i++)
        {
            identity[i] = i;
        }

        return identity;
    }

    private static int End(int at, int[] chain)
    {
        while (chain[at] != at)
        {
            at = chain[at];
        }

        return at;
    }
}
