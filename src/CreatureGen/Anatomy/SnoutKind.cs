namespace CreatureGen.Anatomy;

/// <summary>What covers the front of the head.</summary>
internal enum SnoutKind
{
    /// <summary>The same skin as the rest of the head.</summary>
    Bare,

    /// <summary>A soft muzzle with a dark nose.</summary>
    Leather,

    /// <summary>A beak.</summary>
    Beak,
}
