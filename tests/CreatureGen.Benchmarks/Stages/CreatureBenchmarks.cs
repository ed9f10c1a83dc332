using BenchmarkDotNet.Attributes;
using CreatureGen.Creatures;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>Whole creatures.</summary>
public class CreatureBenchmarks : StageBenchmark
{
    /// <summary>Blueprint to creature.</summary>
    [Benchmark]
    public object Assemble() => CreatureAssembler.Assemble(Subject.Blueprint);

    /// <summary>Seed to creature.</summary>
    [Benchmark]
    public object Generate() => CreatureAssembler.Assemble(BlueprintSampler.Sample(Subject.Seed, Kind));
}
