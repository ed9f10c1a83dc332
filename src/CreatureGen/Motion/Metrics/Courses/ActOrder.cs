namespace CreatureGen.Motion.Metrics;

/// <summary>What a command tells an act that is under way.</summary>
public enum ActOrder
{
    /// <summary>Nothing: it goes its way.</summary>
    None,

    /// <summary>To leave a phase that lasts.</summary>
    GoOn,

    /// <summary>To break off.</summary>
    Stop,
}
