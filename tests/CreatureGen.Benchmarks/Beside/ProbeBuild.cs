using System;
using System.Diagnostics;
using System.IO;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>Builds the probe against this library and against that of an earlier commit, checked out beside.</summary>
internal static class ProbeBuild
{
    private const string Folder = "tests/CreatureGen.Benchmarks.Probe";

    /// <summary>The root of the repository that this program was built in.</summary>
    public static string Root { get; } = FindRoot();

    /// <summary>The probe's assembly, of the state of the files.</summary>
    public static string Now(string workFolder) => Build(Root, Path.Combine(workFolder, "now"), earlier: "false");

    /// <summary>The probe's assembly, of a commit.</summary>
    public static string Then(string commit, string workFolder)
    {
        string tree = Path.Combine(workFolder, "tree");
        if (!Directory.Exists(tree))
        {
            Run("git", Root, "worktree", "add", "--detach", tree, commit);
        }

        Directory.CreateDirectory(Path.Combine(tree, Folder));
        foreach (string pattern in new[] { "*.cs", "*.csproj" })
        {
            foreach (string file in Directory.GetFiles(Path.Combine(Root, Folder), pattern))
            {
                File.Copy(file, Path.Combine(tree, Folder, Path.GetFileName(file)), overwrite: true);
            }
        }

        return Build(tree, Path.Combine(workFolder, "then"), earlier: "true");
    }

    private static string Build(string root, string output, string earlier)
    {
        Run("dotnet", root, "build", Folder, "-c", "Release", "-v", "q", "--nologo", "-p:Earlier=" + earlier, "-p:RunAnalyzers=false", "-o", output);
        return Path.Combine(output, "CreatureGen.Benchmarks.dll");
    }

    /// <summary>Runs a program to its end.</summary>
    /// <returns>What it printed.</returns>
    /// <exception cref="InvalidOperationException">It failed.</exception>
    public static string Run(string program, string folder, params string[] arguments)
    {
        var start = new ProcessStartInfo(program) { WorkingDirectory = folder, RedirectStandardOutput = true };
        foreach (string argument in arguments)
        {
            start.ArgumentList.Add(argument);
        }

        using Process process = Process.Start(start) ?? throw new InvalidOperationException(program + " does not start");
        string output = process.StandardOutput.ReadToEnd();
        process.WaitForExit();
        if (process.ExitCode != 0)
        {
            throw new InvalidOperationException($"{program} {string.Join(' ', arguments)} ended with {process.ExitCode}: {output}");
        }

        return output;
    }

    private static string FindRoot()
    {
        string? folder = AppContext.BaseDirectory;
        while (folder != null && !File.Exists(Path.Combine(folder, "CreatureGen.sln")))
        {
            folder = Path.GetDirectoryName(folder);
        }

        return folder ?? throw new DirectoryNotFoundException($"no CreatureGen.sln above {AppContext.BaseDirectory}; expected to run inside the repository");
    }
}
