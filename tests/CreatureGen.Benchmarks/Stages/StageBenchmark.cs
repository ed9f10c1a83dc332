using BenchmarkDotNet.Attributes;
using CreatureGen.Anatomy;

namespace CreatureGen.Benchmarks.Stages;

/// <summary>One stage on the way from a seed to a file, measured on a creature of each kind.</summary>
[MemoryDiagnoser]
public abstract class StageBenchmark
{
    /// <summary>How the measured creature moves.</summary>
    [Params(LocomotionKind.Walking, LocomotionKind.Flying, LocomotionKind.Swimming)]
    public LocomotionKind Kind { get; set; }

    private protected Subject Subject { get; private set; } = null!;

    /// <summary>Builds what the stage starts from.</summary>
    [GlobalSetup]
    public virtual void SetUp() => Subject = new Subject(42, Kind);
}
