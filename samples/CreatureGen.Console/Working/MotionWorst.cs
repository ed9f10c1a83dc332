using System.Collections.Generic;

namespace CreatureGen.Console.Working;

/// <summary>The worst figure of each measure, and the run that has it; of equals the first.</summary>
internal sealed class MotionWorst
{
    private readonly Dictionary<MotionMeasure, (float Value, RunName Run)> worst = [];

    /// <summary>Number of runs.</summary>
    public long Runs { get; private set; }

    /// <summary>Adds a run.</summary>
    public void Add(MeasuredRun run)
    {
        Runs++;
        foreach (MotionMeasure measure in MotionMeasure.All)
        {
            if (measure.Value(run) is float value && (!worst.TryGetValue(measure, out (float Value, RunName Run) known) || measure.IsWorse(value, known.Value)))
            {
                worst[measure] = (value, run.Name);
            }
        }
    }

    /// <summary>The worst of a measure; null when it applied to no run.</summary>
    public (float Value, RunName Run)? Of(MotionMeasure measure) => worst.TryGetValue(measure, out (float Value, RunName Run) known) ? known : null;
}
