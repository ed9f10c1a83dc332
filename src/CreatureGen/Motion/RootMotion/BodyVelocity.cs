using System.Numerics;

namespace CreatureGen.Motion;

/// <summary>How a creature moves, in its own axes: +Z ahead, +X to its left, +Y up.</summary>
/// <param name="Linear">Metres per second.</param>
/// <param name="YawRate">Radians per second about +Y; positive turns left.</param>
public readonly record struct BodyVelocity(Vector3 Linear, float YawRate);
