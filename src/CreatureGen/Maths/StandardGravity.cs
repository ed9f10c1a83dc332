namespace CreatureGen.Maths;

/// <summary>The gravity that creatures are built for, and that is meant where none is given.</summary>
internal static class StandardGravity
{
    /// <summary>Metres per second squared.</summary>
    public const float Acceleration = 9.81f;
}
