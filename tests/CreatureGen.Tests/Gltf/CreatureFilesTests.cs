using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using Xunit;

namespace CreatureGen.Tests.Gltf;

/// <summary>What other programs are asked about is worth asking.</summary>
public sealed class CreatureFilesTests(CreatureFolder folder)
{
    [Theory]
    [InlineData(LocomotionKind.Walking, CreatureFiles.ManyPairs)]
    [InlineData(LocomotionKind.Flying, CreatureFiles.ManyPairs)]
    [InlineData(LocomotionKind.Swimming, 0)]
    public void Twenty_grown_creatures_of_each_kind_are_among_them_with_few_and_many_legs(LocomotionKind kind, int maxPairs)
    {
        Creature[] creatures = folder.Files.Where(f => f.Options.Provenance != "made by hand" && f.Creature.Blueprint.Kind == kind).Select(f => f.Creature).Distinct(ReferenceEqualityComparer.Instance).Cast<Creature>().ToArray();
        Assert.Equal(CreatureFiles.OfEachKind, creatures.Length);
        Assert.True(creatures.Max(Pairs) >= maxPairs);
        Assert.True(creatures.Min(Pairs) <= 2);
    }

    private static int Pairs(Creature creature) => creature.Blueprint.Legs.Count;
}
