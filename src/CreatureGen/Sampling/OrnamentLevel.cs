namespace CreatureGen.Sampling;

/// <summary>How much a requested creature wears on its skin: horns, spikes, tufts.</summary>
public enum OrnamentLevel
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>Less than usual.</summary>
    Sparse,

    /// <summary>What is usual for its kin.</summary>
    Normal,

    /// <summary>More than usual.</summary>
    Rich,
}
