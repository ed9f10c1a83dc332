using System;
using System.Collections.Generic;

namespace CreatureGen.Anatomy;

/// <summary>The names of the base bodies, nine families and then their species, as blueprints and options use them.</summary>
public static class BaseBodyNames
{
    private static readonly string[] all =
    {
        "canine", "bovine", "feline", "reptile", "avian", "fish", "insect", "serpent", "amphibian",
        "beetle", "ant", "wasp", "mantis", "hopper", "spider", "centipede", "butterfly", "dragonfly",
        "shark", "ray", "angler", "turtle", "plesiosaur", "crocodile", "seal", "newt", "eel",
        "duck", "raptor", "ostrich", "parrot", "heron", "owl",
        "frog", "cobra",
    };

    /// <summary>All names, in a fixed order.</summary>
    public static IReadOnlyList<string> All { get; } = Array.AsReadOnly(all);
}
