using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>A ball of a ragdoll that touches the ground: an end of a capsule.</summary>
/// <param name="Part">The part that carries it.</param>
/// <param name="Place">From the part's centre of mass, in its axes, model metres.</param>
/// <param name="Radius">Model metres.</param>
internal readonly record struct RagdollContact(int Part, Vector3 Place, float Radius);
