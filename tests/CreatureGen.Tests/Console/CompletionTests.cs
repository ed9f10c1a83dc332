using System;
using System.Diagnostics;
using System.IO;
using System.Linq;
using CreatureGen.Console;
using CreatureGen.Tests.Conventions;
using CreatureGen.Tests.SampleProjects;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class CompletionTests
{
    [Fact]
    public void The_page_on_the_console_is_what_the_program_prints()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("manual"));
        Assert.True(run.Out == RepositoryFiles.Text("docs/console.md"), "docs/console.md is not what 'creaturegen manual > docs/console.md' writes");
        Assert.All(Application.Verbs, verb => Assert.All(verb.Syntax.Options, option => Assert.Contains("`" + option.ToString().Replace("|", "\\|", StringComparison.Ordinal) + "`", run.Out, StringComparison.Ordinal)));
    }

    [Theory]
    [InlineData("gen", "generate")]
    [InlineData("generate --ki", "--kind")]
    [InlineData("generate --kind fl", "flying")]
    [InlineData("generate -k ", "any", "walking", "flying", "swimming")]
    [InlineData("generate --levels ha", "half")]
    [InlineData("sheet --view th", "three-quarter")]
    [InlineData("completion p", "powershell")]
    [InlineData("generate --seed ")]
    [InlineData("generate --out ", "folder")]
    [InlineData("inspect creature-", "creature-7.glb")]
    public void Bash_completes_what_is_typed(string typed, params string[] expected)
    {
        if (!File.Exists("/bin/bash"))
        {
            Assert.Skip("bash is not here");
        }

        using var run = new ConsoleRun();
        Directory.CreateDirectory(run.At("folder"));
        File.WriteAllText(run.At("creature-7.glb"), "");
        Assert.Equal(ExitCode.Done, run.Run("completion", "bash"));
        string[] words = typed.Split(' ');
        string script = $"{run.Out}\nCOMP_WORDS=(creaturegen {string.Join(' ', words.Select(word => $"'{word}'"))})\nCOMP_CWORD={words.Length}\n_creaturegen\nprintf '%s\\n' \"${{COMPREPLY[@]}}\"\n";
        using var bash = Process.Start(new ProcessStartInfo("/bin/bash", ["-c", script]) { WorkingDirectory = run.Folder, RedirectStandardOutput = true })!;
        string told = bash.StandardOutput.ReadToEnd();
        bash.WaitForExit();
        Assert.Equal(expected, told.Split('\n', StringSplitOptions.RemoveEmptyEntries));
    }

    /// <summary>By the engine of PowerShell itself, as a process of its own, which asks the script as a person's Tab does. Where nothing is told, PowerShell goes on to names of files.</summary>
    [Fact(Explicit = true)]
    public void Powershell_completes_what_is_typed()
    {
        (string Typed, string[] Expected)[] cases =
        [
            ("gen", ["generate"]),
            ("generate --ki", ["--kind"]),
            ("generate --kind fl", ["flying"]),
            ("generate -k ", ["any", "walking", "flying", "swimming"]),
            ("generate --levels ha", ["half"]),
            ("generate --json --s", ["--seed", "--seeds", "--scale", "--strangeness", "--shard", "--shards", "--skip-existing"]),
            ("sheet --view th", ["three-quarter"]),
            ("completion p", ["powershell"]),
            ("generate --seed ", []),
            ("nothing ", []),
        ];
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("completion", "powershell"));
        File.WriteAllText(run.At("completion.ps1"), run.Out);
        string program = SampleFiles.At($"tests/CreatureGen.PowerShell/bin/{new DirectoryInfo(AppContext.BaseDirectory).Parent!.Name}/net10.0/CreatureGen.PowerShell.dll");
        string told = SampleFiles.Run(run.Folder, "dotnet", [program, "completion.ps1", .. cases.Select(one => "creaturegen " + one.Typed)]);
        Assert.Equal(cases.Select(one => string.Join(' ', one.Expected)), told.ReplaceLineEndings("\n").Split('\n')[..^1]);
    }

    [Theory]
    [InlineData("bash")]
    [InlineData("zsh")]
    [InlineData("powershell")]
    public void Each_script_knows_all_verbs_and_options(string shell)
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("completion", shell));
        foreach (var verb in Application.Verbs.Select(verb => verb.Syntax))
        {
            Assert.Contains(verb.Name, run.Out, StringComparison.Ordinal);
            Assert.All(verb.Options, option => Assert.Contains(option.Name, run.Out, StringComparison.Ordinal));
        }

        Assert.DoesNotContain('\r', run.Out);
    }

    [Fact]
    public void An_unknown_shell_is_refused()
    {
        using var run = new ConsoleRun();
        Assert.Contains("'zhs' is no shell that is known; expected one of bash, zsh, powershell; did you mean zsh?", run.Refusal(ExitCode.BadInput, "completion", "zhs"), StringComparison.Ordinal);
    }
}
