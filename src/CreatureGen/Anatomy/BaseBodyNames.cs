using System;
using System.Collections.Generic;

namespace CreatureGen.Anatomy;

/// <summary>The names of the base bodies, nine families and then their species, as blueprints and options use them.</summary>
public static class BaseBodyNames
{
    private const int Families = 9;

    private static readonly string[] all =
    {
        "canine", "bovine", "feline", "reptile", "avian", "fish", "insect", "serpent", "amphibian",
        "beetle", "ant", "wasp", "mantis", "hopper", "spider", "centipede", "butterfly", "dragonfly", "bee", "moth",
        "shark", "ray", "angler", "turtle", "plesiosaur", "crocodile", "seal", "newt", "eel", "dolphin", "puffer", "swordfish",
        "duck", "raptor", "ostrich", "parrot", "heron", "owl", "penguin", "toucan",
        "frog", "cobra",
        "lion", "hyena", "boar", "horse", "bison", "camel", "bear", "rhino", "rabbit",
        "bat", "pterosaur", "ceratops", "lizard",
    };

    /// <summary>Family of each species, in the order of <see cref="all"/> behind the families.</summary>
    private static readonly string[] families =
    {
        "insect", "insect", "insect", "insect", "insect", "insect", "insect", "insect", "insect", "insect", "insect",
        "fish", "fish", "fish", "reptile", "reptile", "reptile", "canine", "amphibian", "serpent", "fish", "fish", "fish",
        "avian", "avian", "avian", "avian", "avian", "avian", "avian", "avian",
        "amphibian", "serpent",
        "feline", "canine", "bovine", "bovine", "bovine", "bovine", "canine", "bovine", "canine",
        "canine", "reptile", "reptile", "reptile",
    };

    /// <summary>All names, in a fixed order.</summary>
    public static IReadOnlyList<string> All { get; } = Array.AsReadOnly(all);

    /// <summary>The base body whose kin a body is: one of the first nine names; of those their own.</summary>
    /// <exception cref="ArgumentException">There is no body of this name.</exception>
    public static string FamilyOf(string name)
    {
        int index = Array.IndexOf(all, name);
        if (index < 0)
        {
            throw new ArgumentException($"base body \"{name}\"; expected one of " + string.Join(", ", all), nameof(name));
        }

        return index < Families ? all[index] : families[index - Families];
    }
}
