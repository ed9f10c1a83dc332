namespace CreatureGen.Motion.Toolkit.Ragdolls;

/// <summary>Two parts of a ragdoll that may meet.</summary>
/// <param name="First">Number of a part.</param>
/// <param name="Second">Number of the other, greater.</param>
/// <param name="Apart">How far apart the lines in the middle of their bones stay, model metres.</param>
/// <param name="Bound">How far apart their centres of mass are at most when their bones are no farther apart than that.</param>
internal readonly record struct RagdollPair(int First, int Second, float Apart, float Bound);
