using System.Numerics;
using CreatureGen.Geometry;

namespace CreatureGen.Features;

/// <summary>A separate closed mesh that sits on the creature: eye, lid, claw, tooth, horn, antenna. Immutable.</summary>
internal sealed class Piece
{
    public Piece(PieceBinding binding) => Binding = binding;

    public Vector3[] Positions { get; init; } = System.Array.Empty<Vector3>();

    /// <summary>Unit normals, one per position.</summary>
    public Vector3[] Normals { get; init; } = System.Array.Empty<Vector3>();

    /// <summary>Linear RGB, one per position.</summary>
    public Vector3[] Colours { get; init; } = System.Array.Empty<Vector3>();

    public int[] Triangles { get; init; } = System.Array.Empty<int>();

    public MaterialKind Material { get; init; }

    /// <summary>What it feels like.</summary>
    public SurfaceFinish Finish { get; init; }

    /// <summary>How much larger a viewer takes it for than it is: what is looked at keeps its detail longer.</summary>
    public float SimplificationWeight { get; init; } = 1f;

    /// <summary>What it moves with.</summary>
    public PieceBinding Binding { get; }
}
