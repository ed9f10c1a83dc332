using System;
using System.Globalization;
using System.IO;

namespace CreatureGen.Fuzz;

/// <summary>Fuzzes in a folder: goes on where the last run stopped, keeps what is not as promised, tells progress.</summary>
internal static class Program
{
    private const string Usage = "usage: CreatureGen.Fuzz FOLDER COUNT | crosses FOLDER COUNT: tries COUNT more inputs, or crosses of two creatures; results, progress and what went wrong are in FOLDER";
    private const int Parents = 400;
    private const int SaveEvery = 200;

    /// <summary>Inputs that were repaired and are kept, to look at.</summary>
    private const int MostSamples = 100;

    private static int Main(string[] arguments)
    {
        bool crosses = arguments.Length == 3 && arguments[0] == "crosses";
        if ((!crosses && arguments.Length != 2) || !long.TryParse(arguments[^1], NumberStyles.None, CultureInfo.InvariantCulture, out long count))
        {
            Console.Error.WriteLine(Usage);
            return 2;
        }

        CultureInfo.CurrentCulture = CultureInfo.InvariantCulture;
        string folder = arguments[^2];
        Directory.CreateDirectory(folder);
        string progress = Path.Combine(folder, "progress.txt");
        FuzzTally tally = File.Exists(progress) ? FuzzTally.Parse(File.ReadAllText(progress)) : new FuzzTally();
        var inputs = new FuzzInputs(Parents);
        long end = tally.Next + count;
        while (tally.Next < end)
        {
            if (crosses)
            {
                tally.Add(tally.Next, CrossTrial.Of(tally.Next, inputs));
            }
            else
            {
                Try(inputs.Of(tally.Next), tally, folder);
            }

            if (tally.Next % SaveEvery == 0 || tally.Next == end)
            {
                File.WriteAllText(progress + ".new", tally.ToString());
                File.Move(progress + ".new", progress, overwrite: true);
                Console.Error.Write("\r" + tally.Next + " done");
            }
        }

        Console.Out.Write("\n" + tally);
        return tally.IsClean ? 0 : 1;
    }

    private static void Try(FuzzInput input, FuzzTally tally, string folder)
    {
        FuzzTrial trial = FuzzTrial.Of(input);
        tally.Add(input, trial);
        bool sample = trial.Verdict == FuzzVerdict.Repaired && tally.Count(FuzzVerdict.Repaired) <= MostSamples;
        if (sample || trial.Verdict is FuzzVerdict.Crashed or FuzzVerdict.Dear or FuzzVerdict.Beyond)
        {
            string name = Path.Combine(folder, $"{trial.Verdict.ToString().ToLowerInvariant()}-{input.Index}");
            File.WriteAllBytes(name + ".json", input.Text);
            File.WriteAllText(name + ".txt", input.Way + "\n" + trial.Detail + "\n");
        }
    }
}
