using BenchmarkDotNet.Attributes;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>From a seed to a blueprint, with the attachment rules; and the check that every blueprint passes before it is built.</summary>
public class SamplingBenchmarks : StageBenchmark
{
    /// <summary>Seed to blueprint.</summary>
    [Benchmark]
    public object Sample() => BlueprintSampler.Sample(Subject.Seed, Kind);

    /// <summary>Every field of the blueprint against its range.</summary>
    [Benchmark]
    public object Validate() => BlueprintValidator.Validate(Subject.Blueprint);
}
