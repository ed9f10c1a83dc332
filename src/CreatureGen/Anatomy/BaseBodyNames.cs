using System;
using System.Collections.Generic;

namespace CreatureGen.Anatomy;

/// <summary>The names of the base bodies, as blueprints and options use them.</summary>
public static class BaseBodyNames
{
    private static readonly string[] all = { "canine", "bovine", "feline", "reptile", "avian", "fish", "insect", "serpent", "amphibian" };

    /// <summary>All names, in a fixed order.</summary>
    public static IReadOnlyList<string> All { get; } = Array.AsReadOnly(all);
}
