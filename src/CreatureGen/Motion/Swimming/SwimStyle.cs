namespace CreatureGen.Motion.Swimming;

/// <summary>What drives a swimmer.</summary>
internal enum SwimStyle
{
    /// <summary>The hind half of the body beats from side to side (most fish).</summary>
    Carangiform,

    /// <summary>A wave runs down the whole body (eels).</summary>
    Anguilliform,

    /// <summary>The hind half of the body beats up and down (whales).</summary>
    Cetacean,

    /// <summary>Pairs of flippers row and fly under water (turtles, plesiosaurs).</summary>
    Flippers,

    /// <summary>The halves of a disc beat like wings (rays).</summary>
    Disc,
}
