using System;
using System.Diagnostics;
using CreatureGen.Creatures;

namespace CreatureGen.Benchmarks.Table;

/// <summary>Time and bytes of each stage of assemblies: the fastest of several goes at each creature.</summary>
internal sealed class StageClock : IAssemblyObserver
{
    private readonly Sample[] microseconds = Array.ConvertAll(Enum.GetValues<AssemblyStage>(), _ => new Sample());
    private readonly Sample[] bytes = Array.ConvertAll(Enum.GetValues<AssemblyStage>(), _ => new Sample());
    private readonly double[] fastest = new double[Enum.GetValues<AssemblyStage>().Length];
    private readonly double[] leastBytes = new double[Enum.GetValues<AssemblyStage>().Length];
    private long time;
    private long allocated;

    /// <summary>The goes at a creature begin.</summary>
    public void Begin()
    {
        Array.Fill(fastest, double.MaxValue);
        Array.Fill(leastBytes, double.MaxValue);
    }

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
        fastest[(int)stage] = Math.Min(fastest[(int)stage], (now - time) * 1e6 / Stopwatch.Frequency);
        leastBytes[(int)stage] = Math.Min(leastBytes[(int)stage], total - allocated);
        allocated = GC.GetAllocatedBytesForCurrentThread();
        time = Stopwatch.GetTimestamp();
    }

    /// <summary>The goes at a creature are over.</summary>
    public void End()
    {
        for (int i = 0; i < fastest.Length; i++)
        {
            microseconds[i].Add(fastest[i]);
            bytes[i].Add(leastBytes[i]);
        }
    }

    public Sample Microseconds(AssemblyStage stage) => microseconds[(int)stage];

    public Sample Bytes(AssemblyStage stage) => bytes[(int)stage];
}
