namespace CreatureGen.Motion;

/// <summary>A moment of an act that games wait for.</summary>
public enum ActMark
{
    /// <summary>No moment.</summary>
    None,

    /// <summary>The act has begun: where it has to stand still first, once it does.</summary>
    Begin,

    /// <summary>From here on its target stays where it was.</summary>
    Commit,

    /// <summary>It strikes, bites, touches.</summary>
    Contact,

    /// <summary>A voice begins.</summary>
    SoundBegin,

    /// <summary>The voice ends.</summary>
    SoundEnd,

    /// <summary>The act is over, or was broken off.</summary>
    End,
}
