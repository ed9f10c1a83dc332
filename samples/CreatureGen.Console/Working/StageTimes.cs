using System.Collections.Generic;
using System.Diagnostics;
using CreatureGen.Creatures;

namespace CreatureGen.Console.Working;

/// <summary>How long each stage of the way to a creature and its files took.</summary>
internal sealed class StageTimes : IAssemblyObserver
{
    private readonly List<(string Stage, double Milliseconds)> all = [];
    private long last = Stopwatch.GetTimestamp();

    /// <summary>The stages so far, in order.</summary>
    public IReadOnlyList<(string Stage, double Milliseconds)> All => all;

    /// <summary>A stage is done: all time since the one before it was its own.</summary>
    public void Finished(string stage)
    {
        long now = Stopwatch.GetTimestamp();
        all.Add((stage, (now - last) * 1e3 / Stopwatch.Frequency));
        last = now;
    }

    /// <inheritdoc/>
    public void StageFinished(AssemblyStage stage) => Finished(stage.ToString().ToLowerInvariant());
}
