using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>The pieces of a surface that have no edge in common, and their sizes. A piece is known by the lowest of its points.</summary>
internal sealed class SurfacePieces
{
    private readonly double[] areas;
    private readonly Vector3[] min;
    private readonly Vector3[] max;

    /// <summary>Finds the pieces.</summary>
    /// <param name="positions">Place of each point.</param>
    /// <param name="corners">Points, three per triangle.</param>
    public SurfacePieces(Vector3[] positions, int[] corners)
    {
        PieceOf = new int[positions.Length];
        areas = new double[positions.Length];
        min = (Vector3[])positions.Clone();
        max = (Vector3[])positions.Clone();
        var sets = new DisjointSets(PieceOf);
        for (int c = 0; c < corners.Length; c += 3)
        {
            sets.Join(corners[c], corners[c + 1]);
            sets.Join(corners[c], corners[c + 2]);
        }

        for (int p = 0; p < positions.Length; p++)
        {
            int piece = sets.Root(p);
            PieceOf[p] = piece;
            Vector3 at = positions[p];
            Vector3 low = min[piece];
            Vector3 high = max[piece];
            min[piece] = new Vector3(Math.Min(low.X, at.X), Math.Min(low.Y, at.Y), Math.Min(low.Z, at.Z));
            max[piece] = new Vector3(Math.Max(high.X, at.X), Math.Max(high.Y, at.Y), Math.Max(high.Z, at.Z));
        }

        for (int c = 0; c < corners.Length; c += 3)
        {
            Vector3 a = positions[corners[c]];
            int piece = PieceOf[corners[c]];
            areas[piece] += Vec.Length(Vec.Cross(positions[corners[c + 1]] - a, positions[corners[c + 2]] - a)) / 2.0;
            Largest = areas[piece] > areas[Largest] ? piece : Largest;
        }
    }

    /// <summary>The piece of each point.</summary>
    public int[] PieceOf { get; }

    /// <summary>The piece with the largest area.</summary>
    public int Largest { get; }

    /// <summary>Area of a piece, square metres.</summary>
    public double AreaOf(int piece) => areas[piece];

    /// <summary>Diagonal of the box around a piece, metres.</summary>
    public float DiagonalOf(int piece) => Vec.Distance(min[piece], max[piece]);
}
