namespace CreatureGen.Appearance;

/// <summary>Small decisions of a coat that its blueprint leaves open, each drawn from the pattern seed by its own number.</summary>
internal static class CoatChoice
{
    /// <summary>Which marking the head has.</summary>
    public const int Mark = 101;

    /// <summary>Colour of the head's marking.</summary>
    public const int MarkColour = 102;

    /// <summary>Colour of the ring around the eyes.</summary>
    public const int EyeRing = 103;

    /// <summary>Whether the muzzle is pale or dark.</summary>
    public const int Muzzle = 104;

    /// <summary>Colour of fins.</summary>
    public const int Fin = 105;

    /// <summary>Colour of membranes and coverts.</summary>
    public const int Wing = 106;

    /// <summary>Colour of the tip of the tail.</summary>
    public const int TailTip = 107;

    /// <summary>Whether the head is darker or paler than the trunk.</summary>
    public const int HeadTone = 108;

    /// <summary>Whether the snout has pores.</summary>
    public const int Pores = 109;

    /// <summary>Uniform 0..1.</summary>
    public static float Of(int patternSeed, int decision) => LatticeHash.Unit(LatticeHash.Bits(patternSeed, decision, 0, 0));
}
