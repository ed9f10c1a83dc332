using System.Numerics;
using CreatureGen.Geometry;

namespace CreatureGen.Features;

/// <summary>How a separate piece follows the skeleton.</summary>
internal enum PieceBinding
{
    /// <summary>Rigid on the joint named in <see cref="Piece.JointName"/>.</summary>
    Joint,

    /// <summary>Rigid with the weights of the surface vertex in <see cref="Piece.SurfaceVertex"/>.</summary>
    Surface,

    /// <summary>Each vertex with the weights of its own surface vertex in <see cref="Piece.SurfaceVertices"/>.</summary>
    Skin,

    /// <summary>Bending along the joints of the appendage in <see cref="Piece.Appendage"/>.</summary>
    Chain,
}

/// <summary>A separate closed mesh that sits on the creature: eye, lid, claw, tooth, horn, antenna.</summary>
internal sealed class Piece
{
    public Vector3[] Positions { get; set; } = System.Array.Empty<Vector3>();

    /// <summary>Unit normals, one per position.</summary>
    public Vector3[] Normals { get; set; } = System.Array.Empty<Vector3>();

    /// <summary>Linear RGB, one per position.</summary>
    public Vector3[] Colours { get; set; } = System.Array.Empty<Vector3>();

    public int[] Triangles { get; set; } = System.Array.Empty<int>();

    public MaterialKind Material { get; set; }

    /// <summary>What it feels like.</summary>
    public SurfaceFinish Finish { get; set; }

    /// <summary>How much larger a viewer takes it for than it is: what is looked at keeps its detail longer.</summary>
    public float SimplificationWeight { get; set; } = 1f;

    public PieceBinding Binding { get; set; }

    public string JointName { get; set; } = "";

    public int SurfaceVertex { get; set; } = -1;

    /// <summary>One vertex of the surface per position.</summary>
    public int[] SurfaceVertices { get; set; } = System.Array.Empty<int>();

    /// <summary>Index of the appendage whose chain it bends along, and on which side.</summary>
    public int Appendage { get; set; } = -1;

    /// <summary>Side of that chain.</summary>
    public Anatomy.Side Side { get; set; } = Anatomy.Side.Left;
}
