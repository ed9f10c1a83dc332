using System.Numerics;
using System.Runtime.CompilerServices;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>What hip and knee of a leg are solved for.</summary>
/// <param name="Chord">From the hip to where the end of its shank has to be, model space, metres.</param>
/// <param name="Heading">Of the foot.</param>
/// <param name="Lean">How far the plane of a leg out to the side lies over about the chord, radians, the knee ahead.</param>
/// <param name="Slack">0..1: how early the reach is eased.</param>
/// <param name="Tolerance">How far hip and knee may stay beyond their limits, about half the angle in radians.</param>
/// <param name="Over">Direction away from the ground, as long as a foot that the leg does not reach down to stays over its place, 0..1.</param>
[method: MethodImpl(MethodImplOptions.AggressiveInlining)]
internal readonly record struct LegGoal(Vector3 Chord, Quaternion Heading, float Lean, float Slack, float Tolerance, Vector3 Over);
