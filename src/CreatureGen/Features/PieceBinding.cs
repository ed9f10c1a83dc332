using CreatureGen.Anatomy;

namespace CreatureGen.Features;

/// <summary>How a separate piece follows the skeleton. One of the records in it.</summary>
internal abstract record PieceBinding
{
    private PieceBinding()
    {
    }

    /// <summary>Rigid on a joint.</summary>
    /// <param name="Name">Of the joint.</param>
    public sealed record Joint(string Name) : PieceBinding;

    /// <summary>Rigid with the weights of a vertex of the surface.</summary>
    /// <param name="Index">Of the vertex.</param>
    public sealed record SurfaceVertex(int Index) : PieceBinding;

    /// <summary>Each vertex with the weights of a vertex of the surface of its own.</summary>
    /// <param name="Indices">One vertex of the surface per vertex of the piece.</param>
    public sealed record Skin(int[] Indices) : PieceBinding;

    /// <summary>Bending along the joints of an appendage.</summary>
    /// <param name="Appendage">Its index.</param>
    /// <param name="Side">Which of its two sides.</param>
    public sealed record Chain(int Appendage, Side Side) : PieceBinding;
}
