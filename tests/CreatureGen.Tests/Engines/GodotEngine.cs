using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Threading.Tasks;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Engines;

/// <summary>Godot 3 without a window, as a judge: the program <c>godot3-server</c> or the one that the environment variable GODOT names. Tests that ask it are skipped where there is none.</summary>
internal static class GodotEngine
{
    /// <summary>Runs a script in a project of its own, beside which <c>creature.json</c> lies.</summary>
    /// <param name="script">Path of the script in the repository.</param>
    /// <param name="creature">What is in <c>creature.json</c>.</param>
    /// <returns>The numbers after each name that the script prints with an @ before; the last of them is "end".</returns>
    public static async Task<Dictionary<string, double[]>> RunAsync(string script, string creature)
    {
        string project = Directory.CreateTempSubdirectory("creaturegen-godot-").FullName;
        try
        {
            await File.WriteAllTextAsync(Path.Combine(project, "project.godot"), "config_version=4\n\n[application]\n\nconfig/name=\"creature\"\n", TestContext.Current.CancellationToken);
            await File.WriteAllTextAsync(Path.Combine(project, "creature.json"), creature, TestContext.Current.CancellationToken);
            File.Copy(Path.Combine(RepositoryFiles.Root, script), Path.Combine(project, "judge.gd"));
            var start = new ProcessStartInfo(Environment.GetEnvironmentVariable("GODOT") ?? "godot3-server", ["--path", project, "-s", "judge.gd"])
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                UseShellExecute = false,
            };
            foreach (string folder in new[] { "HOME", "XDG_DATA_HOME", "XDG_CONFIG_HOME", "XDG_CACHE_HOME" })
            {
                start.Environment[folder] = project;
            }

            using Process process = Start(start);
            Task<string> errors = process.StandardError.ReadToEndAsync(TestContext.Current.CancellationToken);
            string output = await process.StandardOutput.ReadToEndAsync(TestContext.Current.CancellationToken);
            await process.WaitForExitAsync(TestContext.Current.CancellationToken);
            Dictionary<string, double[]> found = output.Split('\n').Where(l => l.StartsWith('@')).Select(l => l[1..].Split(' ', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries))
                .ToDictionary(w => w[0], w => w.Skip(1).Select(n => double.Parse(n, CultureInfo.InvariantCulture)).ToArray());
            Assert.True(found.ContainsKey("end"), output + await errors);
            return found;
        }
        finally
        {
            Directory.Delete(project, true);
        }
    }

    private static Process Start(ProcessStartInfo start)
    {
        try
        {
            return Process.Start(start)!;
        }
        catch (Win32Exception)
        {
            Assert.Skip($"{start.FileName} is not installed; it is Godot 3 without a window, and judges what is meant for Godot");
            throw;
        }
    }
}
