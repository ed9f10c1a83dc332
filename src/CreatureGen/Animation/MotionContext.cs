namespace CreatureGen.Animation;

/// <summary>What every part of a creature's motion is told in an update, checked and smoothed by the animator.</summary>
/// <param name="Step">Seconds since the last update, 0..0.25.</param>
/// <param name="Input">What was asked, finite.</param>
/// <param name="Speed">Metres per second ahead at present.</param>
/// <param name="Sideways">Metres per second to the left at present.</param>
/// <param name="TurnRate">Radians per second to the left at present.</param>
/// <param name="Height">Metres from the ground up to the root; 0 on the ground.</param>
internal readonly record struct MotionContext(float Step, MotionInput Input, float Speed, float Sideways, float TurnRate, float Height);
