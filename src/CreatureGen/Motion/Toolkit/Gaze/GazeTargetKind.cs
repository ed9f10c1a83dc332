namespace CreatureGen.Motion.Toolkit.Gaze;

/// <summary>Kinds of <see cref="GazeTarget"/>.</summary>
internal enum GazeTargetKind
{
    None,
    Point,
    Direction,
}
