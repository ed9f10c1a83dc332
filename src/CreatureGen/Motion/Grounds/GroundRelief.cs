namespace CreatureGen.Motion;

/// <summary>How even a ground is on which motion is tried or shown.</summary>
public enum GroundRelief
{
    /// <summary>The plane y = 0.</summary>
    Flat,

    /// <summary>The hills of <see cref="HillField"/>.</summary>
    Rough,
}
