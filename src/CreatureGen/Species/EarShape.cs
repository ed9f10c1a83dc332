namespace CreatureGen.Species;

/// <summary>Shapes of ears.</summary>
internal enum EarShape
{
    /// <summary>Upright triangles.</summary>
    Pointed,

    /// <summary>Flaps that hang down the cheeks.</summary>
    Drooping,

    /// <summary>Twice as long as pointed ones, and broad.</summary>
    Big,

    /// <summary>Short and round.</summary>
    Round,

    /// <summary>Leaves that stand out to the sides.</summary>
    Sideways,

    /// <summary>Long and narrow, straight up.</summary>
    Long,
}
