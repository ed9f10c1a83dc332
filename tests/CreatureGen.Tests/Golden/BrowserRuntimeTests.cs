using System;
using System.Collections.Generic;
using System.ComponentModel;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using System.Threading;
using System.Threading.Tasks;
using CreatureGen.Digest;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Golden;

/// <summary>The runtime that browsers have, on Node: another compiler, 32 bits, without cultures and threads.</summary>
public sealed class BrowserRuntimeTests
{
    private const string Script = "tests/browser/run.mjs";
    private const string Page = "samples/CreatureGen.Lab.Runtime/CreatureGen.Lab.Runtime.csproj";

    [Theory]
    [InlineData(3, Explicit = true)]
    [InlineData(int.MaxValue, Explicit = true)]
    public async Task Creatures_are_the_same_to_the_last_byte(int creatures)
    {
        GoldenEntry[] expected = GoldenFile.Entries.Take(creatures).ToArray();
        Assert.Equal(expected, GoldenEntry.Parse(await RunAsync(new() { ["golden.txt"] = GoldenEntry.Format("", expected) }, "print", "/files/golden.txt")));
    }

    [Fact(Explicit = true)]
    public async Task Motion_pictures_and_clips_are_the_same_to_the_last_bit()
    {
        string poses = PoseEntry.Format("", PoseEntry.Parse(RepositoryFiles.Text(GoldenFile.PosesPlace)));
        string others = string.Concat(AssetEntry.Parse(RepositoryFiles.Text(GoldenFile.AssetsPlace)).Select(entry => entry + "\n"));
        string printed = await RunAsync(new() { ["poses.txt"] = poses, ["assets.txt"] = others }, "print-others", "/files", "1", "tr-TR");
        Assert.Equal(poses + others, printed[(printed.IndexOf('\n', StringComparison.Ordinal) + 1)..]);
    }

    /// <summary>What the program prints that gives golden files, with these in its folder.</summary>
    private static async Task<string> RunAsync(Dictionary<string, string> files, params string[] arguments)
    {
        CancellationToken cancellation = TestContext.Current.CancellationToken;
        string version = Regex.Match(RepositoryFiles.Text(Page), "<PageRuntime>(.*)</PageRuntime>").Groups[1].Value;
        string packages = Environment.GetEnvironmentVariable("NUGET_PACKAGES") is { Length: > 0 } set ? set : Path.Combine(Environment.GetFolderPath(Environment.SpecialFolder.UserProfile), ".nuget", "packages");
        string pack = Path.Combine(packages, "microsoft.netcore.app.runtime.mono.browser-wasm", version, "runtimes", "browser-wasm");
        Assert.SkipUnless(Directory.Exists(pack), "needs the runtime for the browser, which dotnet build samples/CreatureGen.Lab.Runtime restores");
        string folder = Directory.CreateTempSubdirectory("creaturegen-browser-").FullName;
        try
        {
            foreach ((string name, string text) in files)
            {
                await File.WriteAllTextAsync(Path.Combine(folder, name), text, cancellation);
            }

            var start = new ProcessStartInfo("node", [Path.Combine(RepositoryFiles.Root, Script), pack, DigestProgram.Plain, folder, .. arguments])
            {
                RedirectStandardOutput = true,
                RedirectStandardError = true,
                StandardOutputEncoding = System.Text.Encoding.UTF8,
                UseShellExecute = false,
            };
            using Process process = Start(start);
            Task<string> output = process.StandardOutput.ReadToEndAsync(cancellation);
            Task<string> errors = process.StandardError.ReadToEndAsync(cancellation);
            await process.WaitForExitAsync(cancellation);
            Assert.True(process.ExitCode == 0, await errors);
            return await output;
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
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
            Assert.Skip("Node is not installed; it runs the runtime for the browser");
            throw;
        }
    }
}
