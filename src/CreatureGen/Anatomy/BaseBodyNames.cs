using System;
using System.Collections.Generic;

namespace CreatureGen.Anatomy;

/// <summary>The names of the base bodies, nine families and then their species, as blueprints and options use them.</summary>
public static class BaseBodyNames
{
    private static readonly (string Name, string Family)[] bodies =
    {
        ("canine", "canine"),
        ("bovine", "bovine"),
        ("feline", "feline"),
        ("reptile", "reptile"),
        ("avian", "avian"),
        ("fish", "fish"),
        ("insect", "insect"),
        ("serpent", "serpent"),
        ("amphibian", "amphibian"),
        ("beetle", "insect"),
        ("ant", "insect"),
        ("wasp", "insect"),
        ("mantis", "insect"),
        ("hopper", "insect"),
        ("spider", "insect"),
        ("centipede", "insect"),
        ("butterfly", "insect"),
        ("dragonfly", "insect"),
        ("bee", "insect"),
        ("moth", "insect"),
        ("shark", "fish"),
        ("ray", "fish"),
        ("angler", "fish"),
        ("turtle", "reptile"),
        ("plesiosaur", "reptile"),
        ("crocodile", "reptile"),
        ("seal", "canine"),
        ("newt", "amphibian"),
        ("eel", "serpent"),
        ("dolphin", "fish"),
        ("puffer", "fish"),
        ("swordfish", "fish"),
        ("duck", "avian"),
        ("raptor", "avian"),
        ("ostrich", "avian"),
        ("parrot", "avian"),
        ("heron", "avian"),
        ("owl", "avian"),
        ("penguin", "avian"),
        ("toucan", "avian"),
        ("frog", "amphibian"),
        ("cobra", "serpent"),
        ("lion", "feline"),
        ("hyena", "canine"),
        ("boar", "bovine"),
        ("horse", "bovine"),
        ("bison", "bovine"),
        ("camel", "bovine"),
        ("bear", "canine"),
        ("rhino", "bovine"),
        ("rabbit", "canine"),
        ("bat", "canine"),
        ("pterosaur", "reptile"),
        ("ceratops", "reptile"),
        ("lizard", "reptile"),
        ("hedgehog", "canine"),
        ("rooster", "avian"),
    };

    /// <summary>All names, in a fixed order.</summary>
    public static IReadOnlyList<string> All { get; } = Array.AsReadOnly(Array.ConvertAll(bodies, body => body.Name));

    /// <summary>The base body whose kin a body is: one of the first nine names; of those their own.</summary>
    /// <exception cref="ArgumentException">There is no body of this name.</exception>
    public static string FamilyOf(string name)
    {
        foreach ((string known, string family) in bodies)
        {
            if (string.Equals(known, name, StringComparison.Ordinal))
            {
                return family;
            }
        }

        throw new ArgumentException($"base body \"{name}\"; expected one of " + string.Join(", ", All), nameof(name));
    }
}
