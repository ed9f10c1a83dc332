using System.Numerics;

namespace CreatureGen.Animation.Strokes.Slithering;

/// <summary>What a crawler is to do, and where its root is.</summary>
/// <param name="Mode">How it crawls; a change passes down the body as it moves on.</param>
/// <param name="Speed">Metres per second on its way, not negative; less counts as 0.</param>
/// <param name="YawRate">Radians per second by which the head turns its way; positive turns left. A crawler that does not move cannot turn, and none turns tighter than its body bends.</param>
/// <param name="RootPosition">Where its root is, world space, metres.</param>
/// <param name="RootYaw">Which way the root faces: turn about +Y from +Z towards +X, radians.</param>
public readonly record struct SlitherInput(SlitherMode Mode, float Speed, float YawRate, Vector3 RootPosition, float RootYaw);

/// <summary>Where the root of a crawler goes in one step: the middle of its body, on the ground.</summary>
/// <param name="Position">World space, metres.</param>
/// <param name="Yaw">Turn about +Y from +Z towards +X, radians.</param>
public readonly record struct RootPlace(Vector3 Position, float Yaw);
