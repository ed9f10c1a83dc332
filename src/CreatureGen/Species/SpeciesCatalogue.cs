using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Species.Catalogue;

namespace CreatureGen.Species;

/// <summary>All species, the nine families first. The order decides which creature a seed is: a further species follows its family or stands at the end.</summary>
internal static class SpeciesCatalogue
{
    private static readonly SpeciesProfile[] all =
    {
        Canine.Profile,
        Bovine.Profile,
        Feline.Profile,
        Reptile.Profile,
        Avian.Profile,
        Fish.Profile,
        Insect.Profile,
        Serpent.Profile,
        Amphibian.Profile,
        Beetle.Profile,
        Ant.Profile,
        Wasp.Profile,
        Mantis.Profile,
        Hopper.Profile,
        Spider.Profile,
        Centipede.Profile,
        Butterfly.Profile,
        Dragonfly.Profile,
        Bee.Profile,
        Moth.Profile,
        Shark.Profile,
        Ray.Profile,
        Angler.Profile,
        Turtle.Profile,
        Plesiosaur.Profile,
        Crocodile.Profile,
        Seal.Profile,
        Newt.Profile,
        Eel.Profile,
        Dolphin.Profile,
        Puffer.Profile,
        Swordfish.Profile,
        Duck.Profile,
        Raptor.Profile,
        Ostrich.Profile,
        Parrot.Profile,
        Heron.Profile,
        Owl.Profile,
        Penguin.Profile,
        Toucan.Profile,
        Frog.Profile,
        Cobra.Profile,
        Lion.Profile,
        Hyena.Profile,
        Boar.Profile,
        Horse.Profile,
        Bison.Profile,
        Camel.Profile,
        Bear.Profile,
        Rhino.Profile,
        Rabbit.Profile,
        Bat.Profile,
        Pterosaur.Profile,
        Ceratops.Profile,
        Lizard.Profile,
        Hedgehog.Profile,
        Rooster.Profile,
    };

    /// <summary>Every profile by the name of its body: a blueprint asks for two dozen.</summary>
    private static readonly Dictionary<string, SpeciesProfile> byBody = all.ToDictionary(species => species.Body, StringComparer.Ordinal);

    private static readonly Dictionary<string, string[]> siblings = all.ToDictionary(
        species => species.Body,
        species => all.Where(other => other.IsSpecies && other.Family == species.Family && other.Body != species.Body && other.Dominance.Min < 0.93).Select(other => other.Body).ToArray(),
        StringComparer.Ordinal);

    /// <summary>Every profile, in a fixed order.</summary>
    public static IReadOnlyList<SpeciesProfile> All => all;

    /// <summary>The families, in a fixed order.</summary>
    public static IReadOnlyList<SpeciesProfile> Families { get; } = all.Where(profile => !profile.IsSpecies).ToArray();

    /// <summary>Names of the other species of the same family that mix well with it.</summary>
    public static IReadOnlyList<string> SiblingsOf(SpeciesProfile species) => siblings[species.Body];

    /// <summary>The profile of a base body.</summary>
    /// <exception cref="ArgumentException">There is none.</exception>
    public static SpeciesProfile Find(string body)
    {
        if (body != null && byBody.TryGetValue(body, out SpeciesProfile? found))
        {
            return found;
        }

        throw new ArgumentException($"base body \"{body}\"; expected one of " + string.Join(", ", all.Select(species => species.Body)), nameof(body));
    }
}
