using CreatureGen.Species;

namespace CreatureGen.Sampling.Parents;

/// <summary>The three species that a creature is mixed of, and which of them gives what.</summary>
/// <param name="First">The species that gives kind and frame of the trunk.</param>
/// <param name="Second">The second in the torso.</param>
/// <param name="Third">The third in the torso.</param>
internal sealed record Parentage(SpeciesProfile First, SpeciesProfile Second, SpeciesProfile Third)
{
    /// <summary>Shares in the torso, together 1.</summary>
    public (double First, double Second, double Third) Torso { get; init; } = (1, 0, 0);

    /// <summary>Least share of the donor in the region that it gives.</summary>
    public (double Head, double Tail) Region { get; init; }

    /// <summary>Gives plan, legs and how they stand.</summary>
    public SpeciesProfile Legs { get; init; } = First;

    /// <summary>Legs that it hangs in the water; null for none.</summary>
    public LegPreset? Paddles { get; init; }

    /// <summary>Gives skull, face, eyes, mouth and ears.</summary>
    public SpeciesProfile Head { get; init; } = First;

    /// <summary>Gives the tail and its end.</summary>
    public SpeciesProfile Tail { get; init; } = First;

    /// <summary>Gives cover, pattern and known colouring.</summary>
    public SpeciesProfile Skin { get; init; } = First;

    /// <summary>Gives horns, crests, hair, collars and shells.</summary>
    public SpeciesProfile Ornaments { get; init; } = First;

    /// <summary>Gives the wings.</summary>
    public SpeciesProfile Wings { get; init; } = First;

    /// <summary>Gives the fins.</summary>
    public SpeciesProfile Fins { get; init; } = First;

    /// <summary>Gives the ears, where it is not the head that does.</summary>
    public SpeciesProfile Ears { get; init; } = First;
}
