using System;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Sampling;
using CreatureGen.Tests.Conventions;
using CreatureGen.Tests.Sampling;

namespace CreatureGen.Tests.Motion.Kept;

/// <summary>Creatures that claims about motion were made of, by the seeds that they had: their blueprints lie beside this class, so that the claims stay about them when seeds give others.</summary>
internal static class KeptCreatures
{
    /// <summary>A creature at its natural size.</summary>
    public static Creature Of(ulong seed) => CreatureGenerator.Build(BlueprintOf(seed));

    /// <summary>A creature at the size of its seed (<see cref="SizeOfSeed"/>).</summary>
    public static Creature AtSizeOfSeed(ulong seed) => CreatureGenerator.Build(BlueprintOf(seed) with { Scale = SizeOfSeed.In(CreatureOptions.Default, seed).MinScale });

    private static CreatureBlueprint BlueprintOf(ulong seed)
    {
        string path = FormattableString.Invariant($"tests/CreatureGen.Tests/Motion/Kept/{seed}.json");
        BlueprintReading reading = BlueprintJson.Read(RepositoryFiles.Text(path));
        return reading.Blueprint ?? throw new InvalidOperationException($"{path}: {string.Join('\n', reading.Problems)}");
    }
}
