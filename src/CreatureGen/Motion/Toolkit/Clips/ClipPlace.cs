using System.Numerics;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Where a clip has carried its creature over the ground, seen from where it began.</summary>
/// <param name="Position">Metres in the creature's axes at the beginning; +Z is ahead, +X to its left.</param>
/// <param name="Heading">Radians about +Y; positive is to the left.</param>
public readonly record struct ClipPlace(Vector3 Position, float Heading);
