using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Threading.Tasks;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>What tests of samples need: their files, and programs to run.</summary>
internal static class SampleFiles
{
    /// <summary>The full path of a file of the repository.</summary>
    public static string At(string path) => Path.Combine(RepositoryFiles.Root, path);

    /// <summary>An executable that is the console as a process of its own.</summary>
    /// <param name="folder">Where it may be put.</param>
    public static string Console(string folder)
    {
        string path = Path.Combine(folder, "creaturegen");
        File.WriteAllText(path, $"#!/bin/sh\nexec dotnet '{typeof(CreatureGen.Console.Application).Assembly.Location}' \"$@\"\n");
        if (!System.OperatingSystem.IsWindows())
        {
            File.SetUnixFileMode(path, UnixFileMode.UserRead | UnixFileMode.UserWrite | UnixFileMode.UserExecute);
        }

        return path;
    }

    /// <summary>Starts a program whose output can be read.</summary>
    public static Process Start(string folder, string program, IEnumerable<string> arguments, params (string Name, string Value)[] environment)
    {
        var start = new ProcessStartInfo(program, arguments) { WorkingDirectory = folder, RedirectStandardOutput = true, RedirectStandardError = true };
        foreach ((string name, string value) in environment)
        {
            start.Environment[name] = value;
        }

        return Process.Start(start)!;
    }

    /// <summary>Runs a program to its end, which must be a good one.</summary>
    /// <returns>What it printed.</returns>
    public static string Run(string folder, string program, IEnumerable<string> arguments, params (string Name, string Value)[] environment)
    {
        using Process process = Start(folder, program, arguments, environment);
        Task<string> problems = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
        string told = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        Assert.True(process.ExitCode == 0, $"{program} {string.Join(' ', arguments)}: {told}{problems.Result}");
        return told;
    }
}
