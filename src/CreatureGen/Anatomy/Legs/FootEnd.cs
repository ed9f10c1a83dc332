namespace CreatureGen.Anatomy.Legs;

/// <summary>How a limb ends.</summary>
internal enum FootEnd
{
    /// <summary>A flat end split into toes or fingers.</summary>
    Toes,

    /// <summary>A hoof.</summary>
    Hoof,

    /// <summary>A round sole with nails.</summary>
    Pad,

    /// <summary>A narrow tip.</summary>
    Point,
}
