namespace CreatureGen.Anatomy;

/// <summary>The outline of a thin wing of an insect.</summary>
public enum ThinWingStyle
{
    /// <summary>Follows from how broad the wing is: slender, rounded off behind, or fanned out.</summary>
    Blade,

    /// <summary>Fore wing of a dragonfly.</summary>
    DragonflyFore,

    /// <summary>Hind wing of a dragonfly.</summary>
    DragonflyHind,

    /// <summary>Fore wing of a butterfly.</summary>
    ButterflyFore,

    /// <summary>Hind wing of a butterfly, with a tail.</summary>
    ButterflyHind,

    /// <summary>Fore wing of a moth.</summary>
    MothFore,

    /// <summary>Hind wing of a moth.</summary>
    MothHind,
}
