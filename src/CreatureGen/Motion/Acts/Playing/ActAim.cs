using System.Numerics;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>What is brought where.</summary>
/// <param name="Tool">What.</param>
/// <param name="Mirrored">Whether the act's side is the right.</param>
/// <param name="Target">World space.</param>
/// <param name="SnoutDown">How far below level the snout points there, radians.</param>
/// <param name="Plan">How the trunk helps.</param>
internal readonly record struct ActAim(ActTool Tool, bool Mirrored, Vector3 Target, float SnoutDown, ReachPlan Plan);
