using System;
using System.IO;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console;
using CreatureGen.Console.Files;
using CreatureGen.Gltf;
using Xunit;

namespace CreatureGen.Tests.Console;

/// <summary>What people expect of any program of the command line.</summary>
public sealed class HabitTests
{
    [Theory]
    [InlineData("-s", "7", "-k", "flying", "-o", "made")]
    [InlineData("-s7", "-kflying", "-omade")]
    [InlineData("-s=7", "-k=flying", "-o=made")]
    public void Short_options_mean_what_long_ones_do(params string[] words)
    {
        using var shorter = new ConsoleRun();
        using var longer = new ConsoleRun();
        Assert.Equal(ExitCode.Done, shorter.Run(["generate", "--no-picture", "--textures", "none", .. words]));
        Assert.Equal(ExitCode.Done, longer.Run("generate", "--no-picture", "--textures", "none", "--seed", "7", "--kind", "flying", "--out", "made"));
        Assert.Equal(File.ReadAllBytes(longer.At("made/creature-7.glb")), File.ReadAllBytes(shorter.At("made/creature-7.glb")));
    }

    [Fact]
    public void No_two_options_of_a_verb_share_a_letter_that_is_not_the_seeds()
    {
        Assert.All(Application.Verbs, verb => Assert.Equal(verb.Syntax.Options.Where(option => option.Short != null).Select(option => option.Short).Distinct(), verb.Syntax.Options.Where(option => option.Short != null).Select(option => option.Short)));
    }

    [Theory]
    [InlineData("no verb before '--seed'; did you mean creaturegen generate --seed?", "--seed", "7")]
    [InlineData("no verb before '7'; did you mean creaturegen generate --seed 7?", "7")]
    [InlineData("no verb before 'hero.glb'; did you mean creaturegen inspect hero.glb?", "hero.glb")]
    [InlineData("no verb before '--gait'; did you mean creaturegen animate --gait?", "--gait", "trot")]
    public void A_verb_that_was_left_out_is_suggested(string message, params string[] words)
    {
        using var run = new ConsoleRun();
        Assert.Contains(message, run.Refusal(ExitCode.BadInput, words), StringComparison.Ordinal);
    }

    [Fact]
    public void One_creature_goes_to_the_standard_output_and_comes_from_the_standard_input()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "-s", "7", "--textures", "none", "-o", "-"));
        Assert.Equal(("", ""), (run.Out, run.Error));
        Assert.Empty(run.Files);
        Assert.Equal(7ul, GlbReader.ReadBlueprint(new MemoryStream(run.Data)).GetBlueprint().Seed);
        using var next = new ConsoleRun { Input = run.Data };
        Assert.Equal(ExitCode.Done, next.Run("build", "-", "-o", "-"));
        Assert.Equal(run.Data, next.Data);
        Assert.Contains("takes one GLB", run.Refusal(ExitCode.BadInput, "generate", "--seeds", "1-2", "-o", "-"), StringComparison.Ordinal);
    }

    [Fact]
    public void Quiet_runs_tell_only_what_went_wrong()
    {
        using var run = new ConsoleRun();
        foreach (string line in new[] { "generate -s 1-2 --no-picture --textures none -q", "generate -s 7 --no-picture --textures none --quiet", "build creature-7.glb -o - -q", "sheet -s 1 --size 32 -o sheet.png -q" })
        {
            Assert.Equal(ExitCode.Done, run.Run(line.Split(' ')));
            Assert.Equal(("", ""), (run.Out, run.Error));
        }

        Assert.Equal(ExitCode.CheckFailed, run.Run(["generate", "--seeds", "1-8", .. RareCreatures.Options.Split(' '), "--no-picture", "--textures", "none", "-q"]));
        Assert.Equal("", run.Out);
        Assert.Contains("gave no creature", run.Error, StringComparison.Ordinal);
        Assert.Contains("--quiet and --json; expected one of them", run.Refusal(ExitCode.BadInput, "generate", "-s", "1", "-q", "--json"), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("generate -s 1-3 --no-picture --textures none")]
    [InlineData("verify -s 1-3")]
    [InlineData("--help")]
    [InlineData("generate --help")]
    [InlineData("generate --nothing")]
    public void Where_colours_are_not_wanted_no_codes_go_to_a_terminal(string line)
    {
        using var run = new ConsoleRun();
        var output = new StringWriter();
        var error = new StringWriter();
        Application.Run(line.Split(' '), run.Surroundings() with { Out = output, Error = error, OutIsTerminal = true, ErrorIsTerminal = true, AllowsColour = false });
        Assert.DoesNotContain(output.ToString() + error, letter => letter is '\e' || (letter == '\r' && Environment.NewLine == "\n"));
    }

    [Theory]
    [InlineData("--picture-size", "8x8", "--picture-size = '8x8'; expected width x height, each 16..4096")]
    [InlineData("--picture-size", "512", "expected width x height")]
    [InlineData("--views", "side,sid", "--views = 'sid'; expected all, or of three-quarter")]
    [InlineData("--views", "side,side", "expected side once")]
    public void Pictures_that_cannot_be_are_refused(string option, string value, string message)
    {
        using var run = new ConsoleRun();
        Assert.Contains(message, run.Refusal(ExitCode.BadInput, "generate", "-s", "1", option, value), StringComparison.Ordinal);
        Assert.Contains("--no-picture and " + option, run.Refusal(ExitCode.BadInput, "generate", "-s", "1", option, value, "--no-picture"), StringComparison.Ordinal);
    }
}
