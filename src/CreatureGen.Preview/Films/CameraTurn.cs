namespace CreatureGen.Preview.Films;

/// <summary>Whether a camera that goes along turns with what it sees.</summary>
public enum CameraTurn
{
    /// <summary>It looks the same way at all times, so that turns are seen.</summary>
    Still,

    /// <summary>It sees the same side at all times, so that lean and bend are seen; on walls and ceilings it is still.</summary>
    Along,
}
