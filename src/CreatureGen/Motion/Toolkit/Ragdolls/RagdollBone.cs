using System.Numerics;

namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>What of a part touches other parts: its thickest capsule.</summary>
/// <param name="Start">From the part's centre of mass, in its axes, model metres.</param>
/// <param name="End">The other end.</param>
/// <param name="Radius">Model metres; 0 for a part that touches none.</param>
internal readonly record struct RagdollBone(Vector3 Start, Vector3 End, float Radius);
