using System.Numerics;

namespace CreatureGen.Motion;

/// <summary>A moment of an act, told in the update in which it falls.</summary>
/// <param name="Act">Which.</param>
/// <param name="Mark">What.</param>
/// <param name="Joint">Skeleton index of what strikes or sounds; −1 for none.</param>
/// <param name="Position">Where that is at the end of the update, world space, metres; the creature's root for none.</param>
/// <param name="SecondsAgo">How long before the end of the update it happened.</param>
public readonly record struct ActEvent(Act Act, ActMark Mark, int Joint, Vector3 Position, float SecondsAgo);
