using System.Numerics;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>
/// What the rig needs to know of something that grew out of the body. Paired appendages are described on the left side; their right side is the mirror image. Immutable.
/// </summary>
internal sealed record Appendage
{
    /// <summary>What it is.</summary>
    public LimbKind Kind { get; init; }

    /// <summary>Number within its kind, from the front, starting at 1.</summary>
    public int Pair { get; init; }

    /// <summary>Whether it has a mirror image on the right; false for fins on the midline.</summary>
    public bool Paired { get; init; }

    /// <summary>Built form of a leg or arm.</summary>
    public LimbArchetype? Archetype { get; init; }

    /// <summary>Ring of the socket's centre.</summary>
    public double RootRing { get; init; }

    /// <summary>
    /// Points of the joints from root to end, model space, metres at scale 1, at least 2. Legs and arms: hip, knee, ankle, ball, end (5).
    /// Wings: shoulder, elbow, wrist, hand, tip (5). Fins, ears, antennae: root, middle, tip (3).
    /// </summary>
    public Vector3[] Joints { get; init; } = System.Array.Empty<Vector3>();

    /// <summary>The <see cref="Geometry.VertexAddress.Along"/> of each joint on the surface, ascending; one per joint.</summary>
    public float[] JointsAlong { get; init; } = System.Array.Empty<float>();

    /// <summary>Direction in which the middle joint points at rest, unit, model space.</summary>
    public Vector3 Pole { get; init; } = Vector3.UnitZ;

    /// <summary>Point of the sole under the ball of the foot, or the tip.</summary>
    public Vector3 Contact { get; init; }

    /// <summary>Whether its foot is on the ground.</summary>
    public bool Stands { get; init; }

    /// <summary>Whether the flank holds its rear edge near the root, as it does that of a membrane.</summary>
    public bool HeldByFlank { get; init; }

    /// <summary>Whether it is a wing of what goes on its legs alone, which carries it raised and does not fold it as fliers do.</summary>
    public bool IsCarried { get; init; }
}
