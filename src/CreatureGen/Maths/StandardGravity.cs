namespace CreatureGen.Maths;

/// <summary>The gravity that creatures are built for, and that is meant where none is given.</summary>
internal static class StandardGravity
{
    /// <summary>Metres per second squared, for what is computed in double.</summary>
    public const double Precise = 9.81;

    /// <summary>Metres per second squared.</summary>
    public const float Acceleration = (float)Precise;
}
