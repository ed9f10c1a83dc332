namespace CreatureGen.Anatomy;

/// <summary>What a skin is covered with.</summary>
internal enum SkinCover
{
    /// <summary>Naked skin with fine wrinkles.</summary>
    Wrinkles,

    /// <summary>Short hair.</summary>
    Fur,

    /// <summary>Overlapping scales.</summary>
    Scales,

    /// <summary>Overlapping feathers with a shaft.</summary>
    Feathers,

    /// <summary>Plates with seams between them.</summary>
    Plates,
}
