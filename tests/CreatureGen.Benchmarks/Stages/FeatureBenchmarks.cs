using BenchmarkDotNet.Attributes;
using CreatureGen.Creatures;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>Eyes, lids, nostrils, teeth, claws, horns, antennae, insect wings.</summary>
public class FeatureBenchmarks : StageBenchmark
{
    /// <summary>All pieces of a creature.</summary>
    [Benchmark]
    public object Set() => FeatureSetter.Set(Subject.Blueprint, Subject.Grown, Subject.Painter, Subject.Normals).Pieces;
}
