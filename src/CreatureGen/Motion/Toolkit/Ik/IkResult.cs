namespace CreatureGen.Motion.Toolkit;

/// <summary>How a solver ended.</summary>
public enum IkStatus
{
    /// <summary>The end is at the target.</summary>
    Reached,

    /// <summary>The target is within reach but so near the end of it that the limb stays a little behind, lest its joint snap straight.</summary>
    Softened,

    /// <summary>The target is beyond reach; the end points at it.</summary>
    TooFar,

    /// <summary>The target is nearer than the limb folds; the end points at it.</summary>
    TooNear,

    /// <summary>Joint limits kept the end from the target.</summary>
    Limited,

    /// <summary>The rounds were over before the end was at the target, though no limit was in the way.</summary>
    NotConverged,
}

/// <summary>How a solver ended, and how far the end is from the target.</summary>
/// <param name="Status">How it ended, at full weight.</param>
/// <param name="Residual">Distance between end and target in metres, at full weight.</param>
public readonly record struct IkResult(IkStatus Status, float Residual)
{
    /// <summary>Whether the end is at the target.</summary>
    public bool Reached => Status == IkStatus.Reached;
}
