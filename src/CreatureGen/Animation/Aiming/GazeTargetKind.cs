namespace CreatureGen.Animation.Aiming;

/// <summary>Kinds of <see cref="GazeTarget"/>.</summary>
internal enum GazeTargetKind
{
    None,
    Point,
    Direction,
}
