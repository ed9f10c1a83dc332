namespace CreatureGen.Sampling;

/// <summary>The mood of a requested creature's colours.</summary>
public enum PaletteMood
{
    /// <summary>Any; the seed decides.</summary>
    Any,

    /// <summary>Earthen and muted, as furs and hides are.</summary>
    Natural,

    /// <summary>Strong and saturated.</summary>
    Vivid,

    /// <summary>Light and faint.</summary>
    Pale,

    /// <summary>Dark.</summary>
    Dark,
}
