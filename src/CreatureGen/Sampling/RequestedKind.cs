namespace CreatureGen.Sampling;

/// <summary>How a requested creature moves.</summary>
public enum RequestedKind
{
    /// <summary>In any way; the seed decides.</summary>
    Any,

    /// <summary>On legs, or on its belly.</summary>
    Walking,

    /// <summary>On wings.</summary>
    Flying,

    /// <summary>In water.</summary>
    Swimming,
}
