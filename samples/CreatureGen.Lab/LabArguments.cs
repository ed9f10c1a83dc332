using System;
using System.Globalization;
using System.IO;

namespace CreatureGen.Lab;

/// <summary>What the lab is started for.</summary>
internal enum LabTask
{
    /// <summary>To serve the page on this machine.</summary>
    Serve,

    /// <summary>To write the page to a folder.</summary>
    Export,

    /// <summary>To say how it is used.</summary>
    Help,
}

/// <summary>What was typed.</summary>
/// <param name="Task">What to do.</param>
/// <param name="Port">Where to serve; 0 for any port that is free.</param>
/// <param name="Folder">Where to write.</param>
internal sealed record LabArguments(LabTask Task, int Port, string Folder)
{
    public const string Usage = """
        The creature lab: a page in which creatures live.

          --port N       serves it on this machine at port N (default 5187; 0 for any that is free)
          --export DIR   writes it to a folder, for any web server
          --help         this text
        """;

    private const int DefaultPort = 5187;

    public static LabArguments? Read(string[] arguments, out string? problem)
    {
        var wanted = new LabArguments(LabTask.Serve, DefaultPort, "");
        problem = null;
        for (int i = 0; i < arguments.Length; i += 2)
        {
            string? value = i + 1 < arguments.Length ? arguments[i + 1] : null;
            switch (arguments[i])
            {
                case "--help" or "-h":
                    return wanted with { Task = LabTask.Help };
                case "--port" when int.TryParse(value, NumberStyles.None, CultureInfo.InvariantCulture, out int port) && port <= ushort.MaxValue:
                    wanted = wanted with { Port = port };
                    break;
                case "--export" when !string.IsNullOrEmpty(value):
                    wanted = wanted with { Task = LabTask.Export, Folder = Path.GetFullPath(value) };
                    break;
                case "--port":
                    problem = $"--port is '{value ?? "nothing"}'; expected a whole number 0..65535";
                    return null;
                case "--export":
                    problem = "--export has no folder; expected one to write to";
                    return null;
                default:
                    problem = $"'{arguments[i]}' is not known; expected --port N, --export DIR or --help";
                    return null;
            }
        }

        return wanted;
    }
}
