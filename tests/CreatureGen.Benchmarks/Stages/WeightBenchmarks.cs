using BenchmarkDotNet.Attributes;
using CreatureGen.Creatures;
using CreatureGen.Skinning;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>Joint influences of each vertex, and the capsules of the bones.</summary>
public class WeightBenchmarks : StageBenchmark
{
    /// <summary>Influences of all vertices of the surface.</summary>
    [Benchmark]
    public object Solve() => AnatomicalWeights.Solve(Subject.RigInput, Subject.Rig);

    /// <summary>A capsule for each bone that moves skin.</summary>
    [Benchmark]
    public object Capsules()
    {
        Creature creature = Subject.Creature;
        return BoneCapsules.Fit(creature.Skeleton, creature.Mesh.Weights, creature.Mesh.Positions);
    }
}
