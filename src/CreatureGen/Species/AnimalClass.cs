namespace CreatureGen.Species;

/// <summary>The great groups that species belong to: what their skins, limbs and habits have in common.</summary>
internal enum AnimalClass
{
    /// <summary>Fur, ears, lips.</summary>
    Mammal,

    /// <summary>Feathers and a beak.</summary>
    Bird,

    /// <summary>Dry scales: lizards, snakes, dinosaurs.</summary>
    Reptile,

    /// <summary>Moist skin, broad head.</summary>
    Amphibian,

    /// <summary>Fins.</summary>
    Fish,

    /// <summary>A hard outside and jointed legs.</summary>
    Arthropod,
}
