namespace CreatureGen.Motion;

/// <summary>What a seeking creature is about. A value to keep per creature; the default stands.</summary>
public struct SeekState
{
    internal SeekAct Act;
    internal bool Turning;

    /// <summary>What it does about the distance.</summary>
    public readonly SeekAct Doing => Act;

    /// <summary>Whether it is turning towards the target.</summary>
    public readonly bool IsTurning => Turning;
}

/// <summary>What a seeking creature does about the distance to its target.</summary>
public enum SeekAct
{
    /// <summary>The distance is right.</summary>
    Hold,

    /// <summary>Goes nearer.</summary>
    Approach,

    /// <summary>Backs away.</summary>
    Retreat,
}
