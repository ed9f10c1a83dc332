namespace CreatureGen.Anatomy;

/// <summary>What surrounds an eye.</summary>
internal enum EyeRim
{
    /// <summary>Nothing: eyes of insects.</summary>
    Bare,

    /// <summary>A rim of skin that never moves: eyes of fish and snakes.</summary>
    Still,

    /// <summary>Lids that shut.</summary>
    Lids,
}
