using System.Collections.Generic;

namespace CreatureGen.Console.Working;

/// <summary>The worst figure of each measure, and the run that has it; of equals the first.</summary>
/// <typeparam name="TRun">What was measured.</typeparam>
internal sealed class WorstRuns<TRun>
    where TRun : IMeasuredRun<TRun>
{
    private readonly Dictionary<Measure<TRun>, (float Value, TRun Run)> worst = [];

    /// <summary>Number of runs.</summary>
    public long Runs { get; private set; }

    /// <summary>Adds a run.</summary>
    public void Add(TRun run)
    {
        Runs++;
        foreach (Measure<TRun> measure in TRun.Measures)
        {
            if (measure.Value(run) is float value && (!worst.TryGetValue(measure, out (float Value, TRun Run) known) || measure.IsWorse(value, known.Value)))
            {
                worst[measure] = (value, run);
            }
        }
    }

    /// <summary>The worst of a measure; null when it applied to no run.</summary>
    public (float Value, TRun Run)? Of(Measure<TRun> measure) => worst.TryGetValue(measure, out (float Value, TRun Run) known) ? known : null;
}
