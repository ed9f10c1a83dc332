using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace CreatureGen.Benchmarks.Probe;

/// <summary>
/// Times rows of work for the table of the benchmarks, one round at a time and as it is told on the standard input: <c>write FOLDER COUNT</c> writes blueprints, <c>read FOLDER</c> reads those that all work is done on,
/// <c>export FOLDER COUNT</c> writes creatures for the programs of other libraries, <c>round ROW</c> answers with the nanoseconds of an operation of each item of a row. An empty line ends it. Where there is no standard input, as in
/// the runtime for browsers, <c>FOLDER MILLISECONDS ROW…</c> as arguments does rounds of each row for that long and prints the fastest of each item, a line for each row.
/// </summary>
public static class Program
{
    /// <summary>Obeys line by line.</summary>
    public static int Main(string[] arguments)
    {
        if (arguments.Length > 0)
        {
            PrintFastest(Subjects.Read(arguments[0]), int.Parse(arguments[1], CultureInfo.InvariantCulture), arguments.AsSpan(2));
            return 0;
        }

        Subjects? subjects = null;
        var rows = new Dictionary<string, Row>();
        while (Console.ReadLine() is { Length: > 0 } line)
        {
            string[] words = line.Split(' ');
            switch (words[0])
            {
                case "write":
                    Subjects.Write(words[1], int.Parse(words[2], CultureInfo.InvariantCulture));
                    Console.WriteLine("written");
                    break;
                case "read":
                    subjects = Subjects.Read(words[1]);
                    Console.WriteLine("read");
                    break;
#if !EARLIER
                case "export":
                    Export.Write(subjects ?? throw Unread(), words[1], int.Parse(words[2], CultureInfo.InvariantCulture));
                    Console.WriteLine("exported");
                    break;
#endif
                case "round":
                    if (!rows.TryGetValue(words[1], out Row? row))
                    {
                        row = Rows.Of(words[1], subjects ?? throw Unread());
                        rows.Add(words[1], row);
                    }

                    Console.WriteLine(Text(row.Round()));
                    break;
                default:
                    Console.Error.WriteLine($"'{line}'; expected write, read, export or round");
                    return 2;
            }
        }

        return 0;
    }

    private static void PrintFastest(Subjects subjects, int milliseconds, ReadOnlySpan<string> names)
    {
        foreach (string name in names)
        {
            Row row = Rows.Of(name, subjects);
            double[] fastest = row.Round();
            var watch = Stopwatch.StartNew();
            while (watch.ElapsedMilliseconds < milliseconds)
            {
                double[] times = row.Round();
                for (int i = 0; i < times.Length; i++)
                {
                    fastest[i] = Math.Min(fastest[i], times[i]);
                }
            }

            Console.WriteLine(Text(fastest));
        }
    }

    private static string Text(double[] nanoseconds) => string.Join(' ', Array.ConvertAll(nanoseconds, ns => ns.ToString("R", CultureInfo.InvariantCulture)));

    private static InvalidOperationException Unread() => new("no blueprints have been read; expected 'read FOLDER' first");
}
