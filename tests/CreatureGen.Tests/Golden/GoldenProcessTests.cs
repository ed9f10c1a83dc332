using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Reflection;
using System.Runtime.Intrinsics.X86;
using System.Runtime.Versioning;
using System.Threading;
using System.Threading.Tasks;
using CreatureGen.Digest;
using Xunit;

namespace CreatureGen.Tests.Golden;

/// <summary>What can only be set when a process starts does not change a byte either.</summary>
public sealed class GoldenProcessTests
{
    private const string Advice = "The golden file itself is checked by GoldenFileTests: if those pass, the bytes depend on the surroundings.";

    [Theory]
    [InlineData("DOTNET_EnableHWIntrinsic", "vector128=False")]
    [InlineData("DOTNET_EnableAVX2", "avx2=False")]
    [InlineData("DOTNET_EnableAVX", "avx2=False")]
    public async Task Vector_instructions_do_not_matter(string switchedOff, string shown)
    {
        string remark = await RunAsync(["1"], new() { [switchedOff] = "0" });
        Assert.True(!X86Base.IsSupported || remark.Contains(shown, StringComparison.Ordinal), remark);
    }

    [Theory]
    [InlineData("DOTNET_TieredCompilation", "0")]
    [InlineData("DOTNET_TieredPGO", "0")]
    [InlineData("DOTNET_TC_QuickJitForLoops", "0")]
    [InlineData("DOTNET_ReadyToRun", "0")]
    [InlineData("DOTNET_JITMinOpts", "1")]
    public async Task What_the_compiler_makes_of_the_code_does_not_matter(string name, string value) => await RunAsync(["1"], new() { [name] = value });

    [Theory]
    [InlineData("tr-TR")]
    [InlineData("ar-SA")]
    [InlineData("fa-IR")]
    public async Task The_culture_does_not_matter(string culture)
    {
        string posix = culture.Replace('-', '_') + ".UTF-8";
        string remark = await RunAsync(["1", culture], new() { ["LANG"] = posix, ["LC_ALL"] = posix });
        Assert.DoesNotContain("number=-1234567.5", remark, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_machine_without_cultures_does_not_matter()
    {
        string remark = await RunAsync(["1", "tr-TR"], new() { ["DOTNET_SYSTEM_GLOBALIZATION_INVARIANT"] = "1" });
        Assert.EndsWith("number=minus1234567,5", remark, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("2")]
    [InlineData("5")]
    public async Task Threads_and_the_order_of_creatures_do_not_matter(string threads) => await RunAsync([threads, "tr-TR"], []);

    /// <summary>Runs the program that lies beside the tests, compares what it prints with the golden file, and returns its remark about its surroundings.</summary>
    private static async Task<string> RunAsync(string[] arguments, Dictionary<string, string> environment)
    {
        CancellationToken cancellation = TestContext.Current.CancellationToken;
        string dotnet = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") is { Length: > 0 } host ? host : "dotnet";
        var start = new ProcessStartInfo(dotnet, [typeof(GoldenEntry).Assembly.Location, "print", GoldenFile.FullPath, .. arguments])
        {
            RedirectStandardOutput = true,
            RedirectStandardError = true,
            StandardOutputEncoding = System.Text.Encoding.UTF8,
            UseShellExecute = false,
        };
        foreach ((string name, string value) in environment)
        {
            start.Environment[name] = value;
        }

        using Process process = Process.Start(start)!;
        Task<string> output = process.StandardOutput.ReadToEndAsync(cancellation);
        Task<string> errors = process.StandardError.ReadToEndAsync(cancellation);
        await process.WaitForExitAsync(cancellation);
        Assert.True(process.ExitCode == 0, await errors);
        string text = await output;
        string remark = text.Split('\n')[0];
        Assert.StartsWith("# library=" + typeof(CreatureGenerator).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName + " ", remark, StringComparison.Ordinal);
        GoldenFile.AssertSame(GoldenEntry.Parse(text), Advice);
        return remark;
    }
}
