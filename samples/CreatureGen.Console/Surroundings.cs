using System;
using System.IO;
using System.Threading;
using CreatureGen.Console.Files;

namespace CreatureGen.Console;

/// <summary>All that the program knows of the world around it.</summary>
/// <param name="Out">Takes data.</param>
/// <param name="Error">Takes complaints and progress.</param>
internal sealed record Surroundings(TextWriter Out, TextWriter Error)
{
    /// <summary>What a path is called that means the standard input or output.</summary>
    public const string Standard = "-";

    /// <summary>Takes files that go to the standard output.</summary>
    public Stream Data { get; init; } = Stream.Null;

    /// <summary>Opens the standard input.</summary>
    public Func<Stream> Input { get; init; } = () => Stream.Null;

    /// <summary>The value of a variable of the environment; null if it is not there.</summary>
    public Func<string, string?> Variable { get; init; } = _ => null;

    /// <summary>Where files are written.</summary>
    public IDisk Disk { get; init; } = new LocalDisk();

    /// <summary>Whether files have to be on the disk before they get their names.</summary>
    public Durability Durability { get; init; }

    /// <summary>Where relative paths start.</summary>
    public string Folder { get; init; } = Directory.GetCurrentDirectory();

    /// <summary>Whether data goes to a person.</summary>
    public bool OutIsTerminal { get; init; }

    /// <summary>Whether complaints go to a person, who may like to see progress too.</summary>
    public bool ErrorIsTerminal { get; init; }

    /// <summary>Takes remarks while data goes to the standard output; null for <see cref="Error"/>.</summary>
    private TextWriter? Remarks { get; init; }

    /// <summary>Whether progress may be shown to a person.</summary>
    public bool ShowsProgress { get; private init; } = true;

    /// <summary>Whether that person may be shown colours, and lines that are written over.</summary>
    public bool AllowsColour { get; init; }

    /// <summary>Stops the work: nothing else is begun.</summary>
    public CancellationToken Cancellation { get; init; }

    /// <summary>Stops what is in hand too: a creature whose clips and pictures take longer is left out as if it had not been begun. Comes after <see cref="Cancellation"/>, if at all.</summary>
    public CancellationToken Abandonment { get; init; }

    /// <summary>What creatures are checked with.</summary>
    public CreatureChecks Checks { get; init; } = CreatureChecks.OfLibrary;

    /// <summary>The absolute form of a path that somebody typed; the standard input or output stays what it is.</summary>
    public string Locate(string path) => path == Standard ? path : Path.GetFullPath(path, Folder);

    /// <summary>Where to tell of a file that was written to a path: not among the data.</summary>
    public TextWriter Telling(string path) => path == Standard ? Remarks ?? Error : Out;

    /// <summary>The same for somebody who wants to hear of nothing but what went wrong.</summary>
    public Surroundings Hushed() => this with { Out = TextWriter.Null, Remarks = TextWriter.Null, ShowsProgress = false };
}
