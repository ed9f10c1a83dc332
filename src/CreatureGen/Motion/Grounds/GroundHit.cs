using System.Numerics;

namespace CreatureGen.Motion;

/// <summary>Where a ray met the ground.</summary>
/// <param name="Point">World space, metres.</param>
/// <param name="Normal">Unit, out of the ground, world space.</param>
/// <param name="Surface">What the ground is made of, as the game numbers it; handed on with footsteps.</param>
/// <param name="Platform">The moving thing that was hit, as <see cref="IMovingGround"/> numbers it; 0 for ground that stands still.</param>
public readonly record struct GroundHit(Vector3 Point, Vector3 Normal, int Surface = 0, int Platform = 0);
