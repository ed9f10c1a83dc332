using System;
using System.IO;
using CreatureGen.Sampling;
using CreatureGen.Tests.Events;

namespace CreatureGen.Benchmarks.Table;

/// <summary>How many moments the presets of rules for events find, and how many of them are false: footsteps against those of the animator by gait, whole clips and live; whooshes and rustling against what the acts know of themselves; the others against the places of joints by clip.</summary>
internal static class EventTable
{
    private const int LiveLoops = 4;

    /// <summary>Measures a preset on so many creatures and prints.</summary>
    /// <param name="output">Gets a table.</param>
    /// <param name="preset">Its name, or <c>live</c> for footsteps as they are heard live.</param>
    /// <param name="first">The first seed.</param>
    /// <param name="count">Number of creatures.</param>
    public static void Print(TextWriter output, string preset, ulong first, int count)
    {
        output.WriteLine("| gait or clip | moments | found | false | apart, mean |");
        output.WriteLine("| --- | --- | --- | --- | --- |");
        if (preset is "footstep" or "live")
        {
            var steps = new FootstepFigures();
            Action<Creatures.Creature> add = preset == "live" ? creature => steps.AddLive(creature, LiveLoops) : steps.Add;
            Measure(RequestedKind.Walking, add);
            output.Write(steps);
        }
        else if (preset is "stuff" or "whoosh")
        {
            var scripted = new ScriptedFigures(preset);
            Measure(RequestedKind.Walking, scripted.Add);
            output.Write(scripted);
        }
        else
        {
            var figures = new PresetFigures(preset);
            Measure(figures.Kind, figures.Add);
            output.Write(figures);
        }

        void Measure(RequestedKind kind, Action<Creatures.Creature> add)
        {
            for (int i = 0; i < count; i++)
            {
                add(CreatureGenerator.Generate(first + (ulong)i, CreatureOptions.Default with { Kind = kind }));
            }
        }
    }
}
