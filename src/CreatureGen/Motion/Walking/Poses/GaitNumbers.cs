namespace CreatureGen.Motion.Walking.Poses;

/// <summary>What of a gait concerns the shape of a step.</summary>
/// <param name="Duty">Part of the cycle that a foot is down.</param>
/// <param name="Lift">Height of swings, a factor.</param>
/// <param name="ForceDip">How far the force of a foot dips in the middle of its stance, 0..1.</param>
/// <param name="Activity">0 stands, 1 walks.</param>
/// <param name="Roll">How far feet roll and fold, 0..1: less in short steps.</param>
/// <param name="Cycle">Seconds of the cycle.</param>
/// <param name="Swing">Seconds of a swing by the tempo that the body keeps: the cycle becomes another at once where a gait does.</param>
/// <param name="Step">Seconds since the last pose.</param>
internal readonly record struct GaitNumbers(float Duty, float Lift, float ForceDip, float Activity, float Roll, float Cycle, float Swing, float Step);
