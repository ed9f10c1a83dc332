using CreatureGen.Geometry;

namespace CreatureGen.Creatures;

/// <summary>The pieces of what is reduced: where their triangles are, and which have been lost.</summary>
internal sealed class ReductionPieces
{
    private readonly ReductionSubject subject;
    private readonly int[] first;
    private readonly int[] end;

    /// <summary>Finds the triangles of each piece.</summary>
    public ReductionPieces(ReductionSubject subject)
    {
        this.subject = subject;
        Lost = new bool[subject.Pieces.PieceOf.Length];
        first = new int[Lost.Length];
        end = new int[Lost.Length];
        for (int c = 0; c < subject.Corners.Length; c += 3)
        {
            int piece = subject.PieceOf[subject.Corners[c]];
            first[piece] = end[piece] == 0 ? c / 3 : first[piece];
            end[piece] = (c / 3) + 1;
        }
    }

    /// <summary>Which pieces have been lost.</summary>
    public bool[] Lost { get; }

    /// <summary>How many triangles of the mesh one of a piece stands for.</summary>
    public int SidesOf(int piece) => subject.Half.IsHalved[piece] ? 2 : 1;

    /// <summary>What it costs to lose a piece together with its mirror image, m⁴; infinite for the largest, for those of no triangle, and for images.</summary>
    public float LossOf(int piece, ReductionCost cost)
    {
        if (end[piece] == 0 || piece > ImageOf(piece) || piece == subject.Pieces.Largest || ImageOf(piece) == subject.Pieces.Largest)
        {
            return float.PositiveInfinity;
        }

        return cost.OfLoss(subject.Corners[3 * first[piece]], (float)subject.Pieces.AreaOf(piece), subject.Pieces.DiagonalOf(piece));
    }

    /// <summary>Removes what is left of a piece and of its mirror image, and gives the number of triangles of the mesh that go.</summary>
    public int Lose(int piece, CollapsingMesh surface)
    {
        int left = LeftOf(piece, surface);
        Remove(piece, surface);
        Remove(ImageOf(piece), surface);
        return left;
    }

    /// <summary>How many triangles of the mesh are left of a piece and of its mirror image.</summary>
    public int LeftOf(int piece, CollapsingMesh surface)
    {
        int image = ImageOf(piece);
        return Left(piece, surface) + (image == piece ? 0 : Left(image, surface));
    }

    private int ImageOf(int piece) => subject.PieceOf[subject.Twin[subject.Corners[3 * first[piece]]]];

    private int Left(int piece, CollapsingMesh surface)
    {
        int left = 0;
        for (int t = first[piece]; t < end[piece]; t++)
        {
            left += IsLeft(t, piece, surface) ? SidesOf(piece) : 0;
        }

        return left;
    }

    private void Remove(int piece, CollapsingMesh surface)
    {
        Lost[piece] = true;
        for (int t = first[piece]; t < end[piece]; t++)
        {
            if (IsLeft(t, piece, surface))
            {
                surface.Remove(t);
            }
        }
    }

    private bool IsLeft(int triangle, int piece, CollapsingMesh surface) => !surface.IsGone(triangle) && subject.PieceOf[subject.Corners[3 * triangle]] == piece;
}
