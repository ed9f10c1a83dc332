using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using System.Text.Json;
using System.Threading.Tasks;
using CreatureGen.Gltf;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Lab.Tests;

/// <summary>The page in a real browser: exported, served and checked once; each test asks for one claim. Skipped where Node or the packages cannot be had, but failed when the environment variable CI is set.</summary>
public sealed class PageFixture : IAsyncLifetime
{
    private static readonly RequestedKind[] kinds = [RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming];
    private static readonly TimeSpan longest = TimeSpan.FromMinutes(12);
    private readonly Dictionary<string, (bool Holds, string Detail)> claims = new(StringComparer.Ordinal);
    private string? missing;
    private string output = "";

    public static string LabFolder { get; } = Find();

    public static string Program => Path.Combine(LabFolder, "bin", "Release", "net10.0", "CreatureGen.Lab.dll");

    private static string PageFolder => Path.Combine(LabFolder, "page");

    public async ValueTask InitializeAsync()
    {
        missing = await MissingAsync();
        if (missing != null)
        {
            return;
        }

        string scratch = Directory.CreateTempSubdirectory("creaturegen-lab-").FullName;
        try
        {
            string exported = Path.Combine(scratch, "site");
            (int code, output) = await RunAsync("dotnet", [Program, "--export", exported]);
            if (code != 0)
            {
                return;
            }

            string expected = Path.Combine(scratch, "expected.json");
            await File.WriteAllTextAsync(expected, JsonSerializer.Serialize(NativeFiles()));
            (_, output) = await RunAsync("node", [Path.Combine(PageFolder, "tests", "check.mjs"), expected, exported]);
            foreach (string line in output.Split('\n').Where(line => line.StartsWith("{\"claim\"", StringComparison.Ordinal)))
            {
                JsonElement claim = JsonDocument.Parse(line).RootElement;
                claims[claim.GetProperty("claim").GetString()!] = (claim.GetProperty("holds").GetBoolean(), claim.GetProperty("detail").GetString()!);
            }
        }
        finally
        {
            Directory.Delete(scratch, recursive: true);
        }
    }

    public ValueTask DisposeAsync() => ValueTask.CompletedTask;

    /// <summary>Passes if the claim was checked and holds.</summary>
    public void Holds(string claim)
    {
        if (missing != null)
        {
            Assert.True(string.IsNullOrEmpty(Environment.GetEnvironmentVariable("CI")), missing);
            Assert.Skip(missing);
        }

        Assert.True(claims.TryGetValue(claim, out (bool Holds, string Detail) found), $"“{claim}” was not checked:\n{output}");
        Assert.True(found.Holds, found.Detail);
    }

    /// <summary>Runs a program to its end.</summary>
    public static async Task<(int ExitCode, string Output)> RunAsync(string program, IEnumerable<string> arguments)
    {
        var start = new ProcessStartInfo(program, arguments) { RedirectStandardOutput = true, RedirectStandardError = true, WorkingDirectory = LabFolder };
        using Process process = Process.Start(start)!;
        Task<string> told = process.StandardOutput.ReadToEndAsync();
        Task<string> errors = process.StandardError.ReadToEndAsync();
        if (await Task.WhenAny(process.WaitForExitAsync(), Task.Delay(longest)) is var first && !process.HasExited)
        {
            process.Kill(entireProcessTree: true);
        }

        return (process.HasExited ? process.ExitCode : -1, await told + await errors);
    }

    private static async Task<string?> MissingAsync()
    {
        try
        {
            await RunAsync("node", ["--version"]);
        }
        catch (Win32Exception)
        {
            return "Node is not installed; it builds the page and drives the browser";
        }

        return Directory.Exists(Path.Combine(PageFolder, "node_modules", "playwright-core")) ? null : "npm ci failed in " + PageFolder + "; it installs the browser";
    }

    private static object[] NativeFiles() =>
        [.. kinds.SelectMany(kind => Enumerable.Range(0, 12).Select(i => (ulong)(1 + (i * 7))).Select(seed =>
        {
            using var file = new MemoryStream();
            GlbWriter.Write(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }), GltfOptions.Default, file);
            return (object)new { seed, kind = kind.ToString().ToLowerInvariant(), sha256 = Convert.ToHexStringLower(SHA256.HashData(file.ToArray())) };
        }))];

    private static string Find()
    {
        for (string? folder = AppContext.BaseDirectory; folder != null; folder = Path.GetDirectoryName(folder))
        {
            string lab = Path.Combine(folder, "samples", "CreatureGen.Lab");
            if (Directory.Exists(lab))
            {
                return lab;
            }
        }

        throw new DirectoryNotFoundException("no samples/CreatureGen.Lab above " + AppContext.BaseDirectory);
    }
}
