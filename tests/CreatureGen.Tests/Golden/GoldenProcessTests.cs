using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Reflection.PortableExecutable;
using System.Runtime.Intrinsics.X86;
using System.Runtime.Versioning;
using System.Threading;
using System.Threading.Tasks;
using CreatureGen.Digest;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Golden;

/// <summary>What can only be set when a process starts does not change a byte either. What processors, threads and the just-in-time compiler make of the code is asked of the library as it is shipped, cultures of the one beside the tests, which starts sooner.</summary>
public sealed class GoldenProcessTests
{
    private const string Advice = "The golden file itself is checked by GoldenFileTests: if those pass, the bytes depend on the surroundings.";

    [Theory]
    [InlineData("DOTNET_EnableHWIntrinsic", "vector128=False", Explicit = true)]
    [InlineData("DOTNET_EnableAVX2", "avx2=False", Explicit = true)]
    [InlineData("DOTNET_EnableAVX", "avx2=False", Explicit = true)]
    public async Task Vector_instructions_do_not_matter(string switchedOff, string shown)
    {
        string remark = await RunAsync(DigestProgram.Plain, ["1"], new() { [switchedOff] = "0" });
        Assert.True(!X86Base.IsSupported || remark.Contains(shown, StringComparison.Ordinal), remark);
    }

    [Theory]
    [InlineData("DOTNET_TieredCompilation", "0", Explicit = true)]
    [InlineData("DOTNET_TieredPGO", "0", Explicit = true)]
    [InlineData("DOTNET_TC_QuickJitForLoops", "0", Explicit = true)]
    [InlineData("DOTNET_ReadyToRun", "0", Explicit = true)]
    [InlineData("DOTNET_JITMinOpts", "1", Explicit = true)]
    public async Task What_the_compiler_makes_of_the_code_does_not_matter(string name, string value) => await RunAsync(DigestProgram.Plain, ["1"], new() { [name] = value });

    [Theory]
    [InlineData("tr-TR")]
    [InlineData("ar-SA", Explicit = true)]
    [InlineData("fa-IR", Explicit = true)]
    public async Task The_culture_does_not_matter(string culture)
    {
        string posix = culture.Replace('-', '_') + ".UTF-8";
        string remark = await RunAsync(DigestProgram.Beside, ["1", culture], new() { ["LANG"] = posix, ["LC_ALL"] = posix });
        Assert.DoesNotContain("number=-1234567.5", remark, StringComparison.Ordinal);
    }

    [Fact]
    public async Task A_machine_without_cultures_does_not_matter()
    {
        string remark = await RunAsync(DigestProgram.Beside, ["1", "tr-TR"], new() { ["DOTNET_SYSTEM_GLOBALIZATION_INVARIANT"] = "1" });
        Assert.EndsWith("number=minus1234567,5", remark, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("2", Explicit = true)]
    [InlineData("5", Explicit = true)]
    public async Task Threads_and_the_order_of_creatures_do_not_matter(string threads) => await RunAsync(DigestProgram.Plain, [threads, "tr-TR"], []);

    /// <summary>Poses, textures, PNG files and clips.</summary>
    [Theory]
    [InlineData("tr-TR", "", "", Explicit = true)]
    [InlineData("th-TH", "DOTNET_JITMinOpts", "1", Explicit = true)]
    [InlineData("ar-SA", "DOTNET_EnableHWIntrinsic", "0", Explicit = true)]
    [InlineData("fa-IR", "DOTNET_TieredCompilation", "0", Explicit = true)]
    [InlineData("sv-SE", "DOTNET_EnableAVX2", "0", Explicit = true)]
    [InlineData("hi-IN", "DOTNET_ReadyToRun", "0", Explicit = true)]
    [InlineData("tr-TR", "DOTNET_SYSTEM_GLOBALIZATION_INVARIANT", "1", Explicit = true)]
    public async Task Motion_pictures_and_clips_are_the_same_in_any_culture_and_on_any_processor(string culture, string name, string value)
    {
        Dictionary<string, string> environment = name.Length == 0 ? [] : new() { [name] = value };
        await CompareOthersAsync(DigestProgram.Plain, culture, environment);
    }

    /// <summary>Of the library itself compiled without optimisation, which <c>.ci/run</c> builds.</summary>
    [Fact]
    public async Task A_debug_build_gives_the_same_bits()
    {
        string debug = DigestProgram.Debug;
        Assert.SkipUnless(File.Exists(debug), "needs dotnet build -c Debug tests/CreatureGen.Digest");
        await CompareOthersAsync(debug, "th-TH", []);
        await RunAsync(debug, [], []);
    }

    /// <summary>Of the library compiled before it runs, which lies beside the tests where the compiler can be had. The other processes compile as they run.</summary>
    [Fact(Explicit = true)]
    public async Task Code_compiled_ahead_gives_the_same_bits()
    {
        Assert.SkipUnless(IsCompiled(typeof(CreatureGenerator).Assembly.Location), "needs the compiler of tools/ReadyToRun, and a Release build");
        Assert.False(IsCompiled(Path.Combine(Path.GetDirectoryName(DigestProgram.Plain)!, "CreatureGen.dll")));
        await CompareOthersAsync(DigestProgram.Beside, "th-TH", []);
        await RunAsync(DigestProgram.Beside, [], []);
    }

    private static bool IsCompiled(string assembly)
    {
        using FileStream file = File.OpenRead(assembly);
        using var reader = new PEReader(file);
        return reader.PEHeaders.CorHeader!.ManagedNativeHeaderDirectory.Size > 0;
    }

    /// <summary>Runs the program and compares what it prints with the golden files of poses and of assets.</summary>
    private static async Task CompareOthersAsync(string program, string culture, Dictionary<string, string> environment)
    {
        using var sample = new GoldenSample();
        string printed = await PrintAsync(program, ["print-others", sample.Folder, "1", culture], environment);
        Assert.Equal(sample.Others, printed[(printed.IndexOf('\n', StringComparison.Ordinal) + 1)..]);
    }

    /// <summary>Runs the program, compares what it prints with the golden file, and returns its remark about its surroundings.</summary>
    private static async Task<string> RunAsync(string program, string[] arguments, Dictionary<string, string> environment)
    {
        using var sample = new GoldenSample();
        string text = await PrintAsync(program, ["print", sample.FilePath, .. arguments], environment);
        string remark = text.Split('\n')[0];
        Assert.StartsWith("# library=" + typeof(CreatureGenerator).Assembly.GetCustomAttribute<TargetFrameworkAttribute>()!.FrameworkName + " ", remark, StringComparison.Ordinal);
        GoldenFile.AssertSame(sample.Entries, GoldenEntry.Parse(text), Advice);
        return remark;
    }

    private static async Task<string> PrintAsync(string program, string[] arguments, Dictionary<string, string> environment)
    {
        CancellationToken cancellation = TestContext.Current.CancellationToken;
        string dotnet = Environment.GetEnvironmentVariable("DOTNET_HOST_PATH") is { Length: > 0 } host ? host : "dotnet";
        var start = new ProcessStartInfo(dotnet, [program, .. arguments])
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
        return await output;
    }
}
