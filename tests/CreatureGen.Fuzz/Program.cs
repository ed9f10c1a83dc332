using System;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace CreatureGen.Fuzz;

/// <summary>Fuzzes in a folder: goes on where the last run stopped, keeps what is not as promised, tells progress.</summary>
internal static class Program
{
    private const string Usage = "usage: CreatureGen.Fuzz FOLDER COUNT [EVERY] | crosses FOLDER COUNT: tries COUNT more inputs, or crosses of two creatures; results, progress and what went wrong are in FOLDER. With EVERY only the creature of every EVERY-th input is built, the others are only read";
    private const int Parents = 400;

    /// <summary>Seconds between two notes of how far it is.</summary>
    private const double SaveAfter = 5;

    /// <summary>Most seconds of processor time for an input: reading it, and building and inspecting its creature.</summary>
    private const double MaxSeconds = 1;

    /// <summary>Inputs that were repaired and are kept, to look at.</summary>
    private const int MaxSamples = 100;

    private static int Main(string[] arguments)
    {
        bool crosses = arguments.Length == 3 && arguments[0] == "crosses";
        long every = 1;
        if ((!crosses && arguments.Length is not (2 or 3)) || !TryNumber(arguments[crosses ? 2 : 1], out long count) || (!crosses && arguments.Length == 3 && !TryNumber(arguments[2], out every)))
        {
            Console.Error.WriteLine(Usage);
            return 2;
        }

        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        string folder = arguments[crosses ? 1 : 0];
        Directory.CreateDirectory(folder);
        string progress = Path.Combine(folder, "progress.txt");
        FuzzTally tally = File.Exists(progress) ? FuzzTally.Parse(File.ReadAllText(progress)) : new FuzzTally();
        var inputs = new FuzzInputs(Parents);
        long end = tally.Next + count;
        long saved = Stopwatch.GetTimestamp();
        while (tally.Next < end)
        {
            if (crosses)
            {
                tally.Add(tally.Next, CrossTrial.Of(tally.Next, inputs));
            }
            else
            {
                FuzzInput input = inputs.Of(tally.Next);
                Note(input, Try(input, built: input.Index % every == 0), tally, folder);
            }

            if (Stopwatch.GetElapsedTime(saved).TotalSeconds > SaveAfter || tally.Next == end)
            {
                saved = Stopwatch.GetTimestamp();
                File.WriteAllText(progress + ".new", tally.ToString());
                File.Move(progress + ".new", progress, overwrite: true);
                Console.Error.Write("\r" + tally.Next + " done");
            }
        }

        Console.Out.Write("\n" + tally);
        return tally.IsClean ? 0 : 1;
    }

    private static bool TryNumber(string word, out long number) => long.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out number) && number > 0;

    /// <summary>Reads an input, builds it as well if it is asked for, against the clock; what is broken is then repaired, however long that takes.</summary>
    private static FuzzTrial Try(FuzzInput input, bool built)
    {
        TimeSpan start = ProcessorTime();
        FuzzTrial trial = built ? FuzzTrial.WithoutRepair(input) : FuzzTrial.WithoutCreature(input);
        double seconds = (ProcessorTime() - start).TotalSeconds;
        return seconds > MaxSeconds && trial.Verdict != FuzzVerdict.Crashed ? new FuzzTrial(FuzzVerdict.Dear, string.Create(CultureInfo.InvariantCulture, $"{seconds:F2} s"))
            : trial.Verdict == FuzzVerdict.Told ? FuzzTrial.Of(input)
            : trial;
    }

    private static TimeSpan ProcessorTime() => Process.GetCurrentProcess().TotalProcessorTime;

    private static void Note(FuzzInput input, FuzzTrial trial, FuzzTally tally, string folder)
    {
        tally.Add(input, trial);
        bool sample = trial.Verdict == FuzzVerdict.Repaired && tally.Count(FuzzVerdict.Repaired) <= MaxSamples;
        if (sample || trial.Verdict is FuzzVerdict.Crashed or FuzzVerdict.Dear or FuzzVerdict.Beyond)
        {
            string name = Path.Combine(folder, $"{trial.Verdict.ToString().ToLowerInvariant()}-{input.Index}");
            File.WriteAllBytes(name + ".json", input.Text);
            File.WriteAllText(name + ".txt", input.Way + "\n" + trial.Detail + "\n");
        }
    }
}
