using System;
using System.Diagnostics;
using CreatureGen.Creatures;

namespace CreatureGen.Benchmarks.Table;

/// <summary>Time and bytes of each stage of assemblies.</summary>
internal sealed class StageClock : IAssemblyObserver
{
    private readonly Sample[] microseconds = Array.ConvertAll(Enum.GetValues<AssemblyStage>(), _ => new Sample());
    private readonly Sample[] bytes = Array.ConvertAll(Enum.GetValues<AssemblyStage>(), _ => new Sample());
    private long time;
    private long allocated;

    /// <summary>An assembly begins.</summary>
    public void Start()
    {
        allocated = GC.GetAllocatedBytesForCurrentThread();
        time = Stopwatch.GetTimestamp();
    }

    /// <inheritdoc/>
    public void StageFinished(AssemblyStage stage)
    {
        long now = Stopwatch.GetTimestamp();
        long total = GC.GetAllocatedBytesForCurrentThread();
        microseconds[(int)stage].Add((now - time) * 1e6 / Stopwatch.Frequency);
        bytes[(int)stage].Add(total - allocated);
        allocated = GC.GetAllocatedBytesForCurrentThread();
        time = Stopwatch.GetTimestamp();
    }

    public Sample Microseconds(AssemblyStage stage) => microseconds[(int)stage];

    public Sample Bytes(AssemblyStage stage) => bytes[(int)stage];
}
