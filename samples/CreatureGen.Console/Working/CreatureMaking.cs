using System;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;

namespace CreatureGen.Console.Working;

/// <summary>From a seed to its files in a folder.</summary>
internal static class CreatureMaking
{
    /// <summary>Makes a creature and writes its files.</summary>
    /// <param name="specimen">Which.</param>
    /// <param name="task">What is made of it.</param>
    /// <param name="folder">Where its files go.</param>
    /// <param name="threads">Threads that share the work of a picture.</param>
    /// <param name="surroundings">What is in hand when the work is stopped is finished, unless it is abandoned.</param>
    /// <exception cref="ImpossibleSeed">This seed's creature cannot meet the options.</exception>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    /// <exception cref="WriteFailure">A file cannot be written.</exception>
    /// <exception cref="InvalidOperationException">The creature is not whole: a defect of the library.</exception>
    /// <exception cref="OperationCanceledException">It was abandoned; no file of it was written.</exception>
    public static GeneratedCreature Make(Specimen specimen, CreatureTask task, string folder, int threads, Surroundings surroundings)
    {
        MadeCreature made = task.Make(specimen, threads, surroundings.Abandonment);
        CreatureFile[] files = CreatureFiles.Write(folder, specimen.Name, made.Contents, surroundings with { Cancellation = default }).ToArray();
        made.Times.Finished("files");
        return new GeneratedCreature(made.Facts, made.Clips, files, made.Times);
    }

    /// <summary>The same of many: a seed that gives no creature is one result among others.</summary>
    /// <exception cref="UsageError">No creature meets the options.</exception>
    /// <exception cref="WriteFailure">A file cannot be written.</exception>
    /// <exception cref="OperationCanceledException">It was abandoned; no file of it was written.</exception>
    public static GenerationResult Try(Specimen specimen, CreatureTask task, string folder, int threads, Surroundings surroundings)
    {
        try
        {
            return Make(specimen, task, folder, threads, surroundings);
        }
        catch (ImpossibleSeed problem)
        {
            return new MissingCreature(specimen, problem.Message);
        }
        catch (InvalidOperationException defect)
        {
            // The library refuses to finish or to write a creature that is not whole.
            return new MissingCreature(specimen, "a defect of CreatureGen: " + defect.Message);
        }
    }
}
