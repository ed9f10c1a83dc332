namespace CreatureGen.Motion;

/// <summary>Whether an act has begun.</summary>
public enum ActStatus
{
    /// <summary>It has begun.</summary>
    Started,

    /// <summary>The creature cannot do it.</summary>
    Refused,

    /// <summary>The creature can do it, but not so far.</summary>
    OutOfReach,
}

/// <summary>What came of asking for an act.</summary>
/// <param name="Status">Whether it has begun.</param>
/// <param name="Reason">Why not; null where it has.</param>
/// <param name="SecondsToContact">Seconds until contact or sound, once the creature stands where the act needs that; null for acts without.</param>
/// <param name="Missing">How far what strikes would stay from the target, metres of the world.</param>
public readonly record struct ActStart(ActStatus Status, string? Reason, float? SecondsToContact, float Missing);
