using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Sampling;

namespace CreatureGen.Tests.Sampling;

/// <summary>Creatures of one species: subjects that stay the same kind of creature when the catalogue grows.</summary>
internal static class SpeciesSubject
{
    /// <summary>Options that leave one species and kind, as the animal is.</summary>
    public static CreatureOptions Only(string body, RequestedKind kind) => CreatureOptions.Default with
    {
        Kind = kind,
        Strangeness = 0,
        BaseBodies = new ValueList<BaseBodyWeight>(BaseBodyNames.All.Select(name => new BaseBodyWeight(name, name == body ? 1 : 0))),
    };

    /// <summary>The creature of a seed among those of a species, of the seed's size.</summary>
    public static Creature Of(string body, RequestedKind kind, ulong seed = 0) => CreatureGenerator.Generate(seed, SizeOfSeed.In(Only(body, kind), seed));
}
