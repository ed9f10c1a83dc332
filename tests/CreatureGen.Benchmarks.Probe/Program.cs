using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Globalization;
using System.IO;

namespace CreatureGen.Benchmarks.Probe;

/// <summary>
/// Times rows of work for the table of the benchmarks, one round at a time and as it is told on the standard input: <c>write FOLDER COUNT</c> writes blueprints, <c>read FOLDER</c> reads those that all work is done on,
/// <c>round ROW</c> answers with the nanoseconds of an operation of each item of a row. An empty line ends it.
/// </summary>
public static class Program
{
    /// <summary>Obeys line by line.</summary>
    public static int Main()
    {
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
                case "round":
                    if (!rows.TryGetValue(words[1], out Row? row))
                    {
                        row = Rows.Of(words[1], subjects ?? throw new InvalidOperationException("no blueprints have been read; expected 'read FOLDER' first"));
                        rows.Add(words[1], row);
                    }

                    Console.WriteLine(string.Join(' ', Array.ConvertAll(row.Round(), ns => ns.ToString("R", CultureInfo.InvariantCulture))));
                    break;
                default:
                    Console.Error.WriteLine($"'{line}'; expected write, read or round");
                    return 2;
            }
        }

        return 0;
    }
}
