using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>What files will take that are not written yet.</summary>
internal static class PlanText
{
    /// <summary>Writes a line.</summary>
    /// <param name="output">Where to.</param>
    /// <param name="creatures">Creatures to be made.</param>
    /// <param name="files">Their files.</param>
    /// <param name="measured">Some of them.</param>
    public static void Write(TextWriter output, long creatures, long files, IReadOnlyList<MadeCreature> measured)
    {
        string what = $"{Units.Count(creatures)} creatures in {Units.Count(files)} files";
        if (measured.Count == 0)
        {
            output.WriteLine(what);
            return;
        }

        double bytes = measured.Average(one => one.Contents.Sum(content => (double)content.Content.Length)) * creatures;
        double seconds = measured.Average(one => one.Times.All.Sum(stage => stage.Milliseconds)) / 1000 * creatures;
        string size = bytes < 1e9 ? Units.Bytes((long)bytes) : Tenths(bytes / 1e9) + " GB";
        string time = seconds < 90 ? Tenths(seconds) + " s" : seconds < 5400 ? Tenths(seconds / 60) + " minutes" : Tenths(seconds / 3600) + " hours";
        output.WriteLine($"{what}: {(measured.Count == creatures ? "" : "about ")}{size}, about {time} on one processor, by {Units.Count(measured.Count)} that were made");
    }

    private static string Tenths(double number) => number.ToString("0.0", CultureInfo.InvariantCulture);
}
