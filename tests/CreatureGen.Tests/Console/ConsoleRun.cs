using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using System.Threading;
using CreatureGen.Console;
using CreatureGen.Console.Files;
using Xunit;

namespace CreatureGen.Tests.Console;

/// <summary>Runs the program in a folder of its own, which goes with it.</summary>
internal sealed class ConsoleRun : IDisposable
{
    public string Folder { get; } = Directory.CreateTempSubdirectory("creaturegen-").FullName;

    public string Out { get; private set; } = "";

    public string Error { get; private set; } = "";

    /// <summary>The files that went to the standard output.</summary>
    public byte[] Data { get; private set; } = [];

    /// <summary>What the standard input gives.</summary>
    public byte[] Input { get; init; } = [];

    /// <summary>The environment.</summary>
    public Func<string, string?> Variable { get; init; } = _ => null;

    public IDisk Disk { get; set; } = new LocalDisk();

    public CreatureChecks Checks { get; init; } = CreatureChecks.OfLibrary;

    /// <summary>Names of the files in the folder, sorted.</summary>
    public string[] Files => Directory.GetFileSystemEntries(Folder).Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal).ToArray();

    public int Run(params string[] arguments) => Run(CancellationToken.None, arguments);

    public int Run(CancellationToken cancellation, params string[] arguments) => Run(Surroundings() with { Cancellation = cancellation }, arguments);

    public int Run(Surroundings surroundings, params string[] arguments)
    {
        var output = new StringWriter();
        var error = new StringWriter();
        var data = new MemoryStream();
        int code = Application.Run(arguments, surroundings with { Out = output, Error = error, Data = data });
        Data = data.ToArray();
        Out = output.ToString();
        Error = error.ToString();
        return code;
    }

    /// <summary>The world as the program sees it here.</summary>
    public Surroundings Surroundings() => new(TextWriter.Null, TextWriter.Null) { Folder = Folder, Checks = Checks, Disk = Disk, Variable = Variable, Input = () => new MemoryStream(Input) };

    /// <summary>Runs what must be refused, and says in which single line it was.</summary>
    public string Refusal(int code, params string[] arguments)
    {
        Assert.Equal(code, Run(arguments));
        Assert.Equal("", Out);
        Assert.StartsWith("creaturegen: ", Error, StringComparison.Ordinal);
        Assert.Equal(1, Error.Count(letter => letter == '\n'));
        return Error.TrimEnd();
    }

    public JsonElement Json()
    {
        using JsonDocument document = JsonDocument.Parse(Out);
        return document.RootElement.Clone();
    }

    public string At(string name) => Path.Combine(Folder, name);

    public byte[] Bytes(string name) => File.ReadAllBytes(At(name));

    public IReadOnlyDictionary<string, byte[]> AllBytes() => Files.ToDictionary(name => name, Bytes);

    public void Dispose()
    {
        foreach (string path in Directory.GetFiles(Folder, "*", SearchOption.AllDirectories))
        {
            File.SetAttributes(path, FileAttributes.Normal);
        }

        Directory.Delete(Folder, recursive: true);
    }
}
