namespace CreatureGen.Motion;

/// <summary>What carries a creature at present.</summary>
public enum BodyState
{
    /// <summary>What its way of going has carry it: its feet, its wings, the water, its belly.</summary>
    Supported,

    /// <summary>Its feet, off which it pushes itself for a jump.</summary>
    Leaping,

    /// <summary>Nothing: it falls or flies in a jump, and its legs reach for the ground.</summary>
    Falling,

    /// <summary>Its feet, which have come down and take up the fall.</summary>
    Landed,

    /// <summary>The ground, on which it lies, or will: nothing holds its joints.</summary>
    Limp,

    /// <summary>The ground still, but it is getting up.</summary>
    Rising,

    /// <summary>Water that is too deep for its legs: it floats at the surface and paddles.</summary>
    Afloat,
}
