using System;
using System.Globalization;
using CreatureGen.Creatures;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Creatures;

/// <summary>Creatures of every kind for tests of their levels of detail.</summary>
internal static class LodSubjects
{
    /// <summary>The kinds.</summary>
    public static TheoryData<RequestedKind> Kinds => new(RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming);

    /// <summary>Seeds to try of each kind: a sample, or as many as the environment variable CREATUREGEN_SEEDS asks for.</summary>
    public static int Seeds { get; } = int.TryParse(Environment.GetEnvironmentVariable("CREATUREGEN_SEEDS"), NumberStyles.None, CultureInfo.InvariantCulture, out int seeds) ? seeds : Thoroughness.IsExhaustive ? 60 : 6;

    /// <summary>A creature of a kind with a budget of triangles, of the seed's size.</summary>
    public static Creature Of(RequestedKind kind, int seed, int budget = 20000) =>
        GrownCreatures.Of((ulong)seed, SizeOfSeed.In(new CreatureOptions { Kind = kind, TriangleBudget = budget, Strangeness = 0 }, (ulong)seed));
}
