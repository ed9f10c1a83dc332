using BenchmarkDotNet.Attributes;
using CreatureGen.Rigging;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>Skeleton, limb chains, attachment points, body capsule.</summary>
public class RigBenchmarks : StageBenchmark
{
    /// <summary>The rig at scale 1.</summary>
    [Benchmark]
    public object Build() => CreatureRigger.Build(Subject.RigInput);
}
