namespace CreatureGen.Events;

/// <summary>What lies beyond the ends of a series of samples.</summary>
internal enum ClipEdge
{
    /// <summary>Nothing is known.</summary>
    Open,

    /// <summary>The other end: it loops.</summary>
    Joined,
}
