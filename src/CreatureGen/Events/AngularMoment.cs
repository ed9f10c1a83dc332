namespace CreatureGen.Events;

/// <summary>A moment found while a motion goes on.</summary>
/// <param name="Joint">Skeleton index of the joint.</param>
/// <param name="Strength">Its angular acceleration, in thresholds.</param>
/// <param name="SecondsAgo">How long before the update it was.</param>
public readonly record struct AngularMoment(int Joint, float Strength, float SecondsAgo);
