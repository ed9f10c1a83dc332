using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>What a chain of joints is.</summary>
public enum LimbKind
{
    /// <summary>Leg.</summary>
    Leg,

    /// <summary>Arm.</summary>
    Arm,

    /// <summary>Stitched wing.</summary>
    Wing,

    /// <summary>Thin wing of an insect.</summary>
    InsectWing,

    /// <summary>Paired fin.</summary>
    Pectoral,

    /// <summary>Fin on the back.</summary>
    Dorsal,

    /// <summary>Fin on the belly.</summary>
    Ventral,

    /// <summary>Ear.</summary>
    Ear,

    /// <summary>Feeler.</summary>
    Antenna,

    /// <summary>Further tail; its joints swing as those of feelers do.</summary>
    Tail,

    /// <summary>Row of a disc's halves (rays): its joints go from the trunk out to the edge.</summary>
    Disc,
}

/// <summary>A limb as a chain of joints of the skeleton.</summary>
/// <param name="Kind">What it is.</param>
/// <param name="Side">Left, right, or on the midline.</param>
/// <param name="Pair">Number of the pair within its kind, from the front, starting at 1.</param>
/// <param name="Archetype">Built form of a leg or arm; null for other limbs.</param>
/// <param name="Joints">Indices into the skeleton from root to end: girdle, hip, knee, ankle, ball, end for legs and arms; root to end for others.</param>
/// <param name="RestLengths">Length of each bone between consecutive joints, metres; one fewer than the joints.</param>
/// <param name="Pole">Unit direction in model space in which the middle joint (knee, elbow) points at rest.</param>
/// <param name="Contact">Point on the sole under the ball of the foot in rest pose, model space; the tip for limbs without a foot.</param>
/// <param name="Stands">Whether the foot is on the ground in rest pose.</param>
public sealed record LimbChain(
    LimbKind Kind,
    Side Side,
    int Pair,
    LimbArchetype? Archetype,
    IReadOnlyList<int> Joints,
    IReadOnlyList<float> RestLengths,
    Vector3 Pole,
    Vector3 Contact,
    bool Stands);

/// <summary>A place on the skin where something can be attached, on a spine bone (top, left or right).</summary>
/// <param name="Name">Unique ASCII name.</param>
/// <param name="Joint">Index of the joint that carries it.</param>
/// <param name="Position">Model space, rest pose, metres.</param>
/// <param name="Normal">Unit outward direction of the skin, model space.</param>
/// <param name="Width">Width of the body here from left to right, metres (the hip width of this bone).</param>
public sealed record AttachmentPoint(string Name, int Joint, Vector3 Position, Vector3 Normal, float Width);

/// <summary>A capsule in a joint's space.</summary>
/// <param name="Joint">Index of the joint.</param>
/// <param name="Start">Centre of the first half sphere, metres, joint space.</param>
/// <param name="End">Centre of the second half sphere, metres, joint space.</param>
/// <param name="Radius">Metres.</param>
public sealed record CapsuleCollider(int Joint, Vector3 Start, Vector3 End, float Radius);
