using System;
using System.IO;
using System.Threading;

namespace CreatureGen.Console;

/// <summary>All that the program knows of the world around it.</summary>
/// <param name="Out">Takes data.</param>
/// <param name="Error">Takes complaints and progress.</param>
internal sealed record Surroundings(TextWriter Out, TextWriter Error)
{
    /// <summary>Where relative paths start.</summary>
    public string Folder { get; init; } = Directory.GetCurrentDirectory();

    /// <summary>Whether data goes to a person.</summary>
    public bool OutIsTerminal { get; init; }

    /// <summary>Whether complaints go to a person, who may like to see progress too.</summary>
    public bool ErrorIsTerminal { get; init; }

    /// <summary>Whether that person may be shown colours.</summary>
    public bool AllowsColour { get; init; }

    /// <summary>Stops the work.</summary>
    public CancellationToken Cancellation { get; init; }

    /// <summary>What creatures are checked with.</summary>
    public CreatureChecks Checks { get; init; } = CreatureChecks.OfLibrary;

    /// <summary>The absolute form of a path that somebody typed.</summary>
    public string Locate(string path) => Path.GetFullPath(path, Folder);
}
