using System;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Console;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class UsageTests
{
    [Theory]
    [InlineData("unknown verb 'genrate'; expected one of generate, build, breed, evolve, inspect, sheet, gallery, animate, verify, merge, variety, metrics, events, teach, completion, manual; did you mean generate?", "genrate")]
    [InlineData("unknown option '--verison'; expected one of --help, --version; did you mean --version?", "--verison")]
    [InlineData("; did you mean --seed?", "generate", "--sed", "3")]
    [InlineData("generate: no seeds; expected --seed N or --seeds LIST, such as --seeds 1-36", "generate")]
    [InlineData("generate: --seed has no value; expected --seed N", "generate", "--seed")]
    [InlineData("generate: --seed has no value; expected --seed N", "generate", "--seed", "--json")]
    [InlineData("generate: --seed has no value; expected --seed N", "generate", "--seed=")]
    [InlineData("generate: --seed is there twice; expected it once", "generate", "--seed", "1", "--seed=1")]
    [InlineData("generate: --json is there twice; expected it once", "generate", "--json", "--json")]
    [InlineData("generate: --seed and --seeds; expected one of them", "generate", "--seed", "1", "--seeds", "2")]
    [InlineData("generate: --json = 'yes'; expected --json without a value", "generate", "--json=yes")]
    [InlineData("generate: '7' is no option; expected only options", "generate", "7")]
    [InlineData("generate: --seed = '-1'; expected a whole number 0..18446744073709551615", "generate", "--seed", "-1")]
    [InlineData("generate: --seeds: the range 9-3 runs backwards", "generate", "--seeds", "9-3")]
    [InlineData("generate: --kind = 'fly'; expected one of any, walking, flying, swimming; did you mean flying?", "generate", "--seed", "1", "--kind", "fly")]
    [InlineData("generate: --threads = '0'; expected a whole number 1..256", "generate", "--seed", "1", "--threads", "0")]
    [InlineData("generate: --scale = '2-1'; expected the smaller number first", "generate", "--seed", "1", "--scale", "2-1")]
    [InlineData("generate: --scale = '1-2-3'; expected a number, or the least and the greatest", "generate", "--seed", "1", "--scale", "1-2-3")]
    [InlineData("generate: --scale = 'NaN'; expected a number", "generate", "--seed", "1", "--scale", "NaN")]
    [InlineData("generate: --scale: maxScale = 99; expected 0.05..20", "generate", "--seed", "1", "--scale", "1-99")]
    [InlineData("generate: --leg-pairs = '1.5'; expected a number", "generate", "--seed", "1", "--leg-pairs", "1.5")]
    [InlineData("generate: --plans = 'hexpod'; expected one of digitigrade", "generate", "--seed", "1", "--plans", "hexpod=2")]
    [InlineData("generate: --plans = 'hexapod'; expected a weight 0..1000, such as hexapod=5", "generate", "--seed", "1", "--plans", "hexapod")]
    [InlineData("expected hexapod once", "generate", "--seed", "1", "--plans", "hexapod=1,hexapod=2")]
    [InlineData("weight = 5000; expected 0..1000", "generate", "--seed", "1", "--bodies", "feline=5000")]
    [InlineData("generate: --triangles: triangleBudget = 5; expected a whole number 6000..100000", "generate", "--seed", "1", "--triangles", "5")]
    [InlineData("expected options that leave at least one", "generate", "--seed", "1", "--kind", "swimming", "--leg-pairs", "7-8")]
    [InlineData("there is no such file; expected options as JSON", "generate", "--seed", "1", "--options", "none.json")]
    [InlineData("build: no file; expected build BLUEPRINT.json|FILE.glb", "build", "--out", "x.glb")]
    [InlineData("build: no --out; expected --out FILE", "build", "x.json")]
    [InlineData("build: 'b' after 'a'; expected one BLUEPRINT.json|FILE.glb", "build", "a", "b", "--out", "x.glb")]
    [InlineData("there is no such file; expected a blueprint (.json) or a creature (.glb)", "build", "none.glb", "--out", "x.glb")]
    [InlineData("it is a folder; expected a blueprint", "inspect", ".")]
    [InlineData("sheet: --view = 'sid'; expected one of three-quarter, side, front, back, top; did you mean side?", "sheet", "--seed", "1", "--out", "x.png", "--view", "sid")]
    [InlineData("a sheet of 18446744073709551616 creatures would be", "sheet", "--seeds", "0-18446744073709551615", "--out", "x.png")]
    [InlineData("verify: unknown option '--flat'", "verify", "--seed", "1", "--flat")]
    public void Bad_usage_is_told_in_one_line_and_nothing_is_made(string expected, params string[] arguments)
    {
        using var run = new ConsoleRun();
        Assert.Contains(expected, run.Refusal(ExitCode.BadInput, arguments), StringComparison.Ordinal);
        Assert.Empty(run.Files);
    }

    [Fact]
    public void All_problems_of_options_are_listed_each_on_a_line()
    {
        using var run = new ConsoleRun();
        File.WriteAllText(run.At("o.json"), """{"minScale": 0, "palette": "loud", "extra": 1}""");
        Assert.Equal(ExitCode.BadInput, run.Run("generate", "--seed", "1", "--options", "o.json"));
        Assert.Equal(4, run.Error.Count(letter => letter == '\n'));
        Assert.Contains("minScale = 0; expected 0.05..20 (line 1, column 14)", run.Error, StringComparison.Ordinal);
        Assert.Contains("palette = \"loud\"; expected one of any, natural", run.Error, StringComparison.Ordinal);
        Assert.Equal(ExitCode.BadInput, run.Run("generate", "--seed", "1", "--scale", "0-99"));
        Assert.Equal(3, run.Error.Count(letter => letter == '\n'));
    }

    [Fact]
    public void Help_has_examples_first_and_every_verb_has_its_own()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("--help"));
        Assert.True(run.Out.IndexOf("Examples", StringComparison.Ordinal) < run.Out.IndexOf("Verbs", StringComparison.Ordinal));
        foreach (string verb in Application.Verbs.Select(verb => verb.Syntax.Name))
        {
            Assert.Contains(verb, run.Out, StringComparison.Ordinal);
        }

        foreach (var verb in Application.Verbs)
        {
            Assert.Equal(ExitCode.Done, run.Run(verb.Syntax.Name, "--nonsense", "--help"));
            Assert.True(run.Out.IndexOf("Examples", StringComparison.Ordinal) is int examples and > 0 && examples < run.Out.IndexOf("Options", StringComparison.Ordinal));
            Assert.All(verb.Syntax.Options, option => Assert.Contains(option.ToString(), run.Out, StringComparison.Ordinal));
            string own = run.Out;
            Assert.Equal(ExitCode.Done, run.Run("help", verb.Syntax.Name));
            Assert.Equal(own, run.Out);
        }

        Assert.Equal("", run.Error);
        Assert.Empty(run.Files);
    }

    [Fact]
    public void Every_example_of_the_help_can_be_read()
    {
        foreach (var verb in Application.Verbs)
        {
            foreach (var example in verb.Syntax.Examples)
            {
                // Words, or several within quotes, up to where the output goes.
                string[] words = Regex.Matches(example.Line.Split('>')[0], "\"([^\"]*)\"|\\S+").Select(word => word.Value.Trim('"')).ToArray();
                Assert.Equal(verb.Syntax.Name, words[0]);
                Assert.NotNull(CreatureGen.Console.Arguments.ArgumentReader.Read(verb.Syntax, words[1..]));
            }
        }
    }

    [Fact]
    public void The_version_is_a_name_and_three_numbers()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("--version"));
        Assert.Matches(@"^creaturegen \d+\.\d+\.\d+\r?\n$", run.Out);
    }

    [Fact]
    public void Options_of_the_command_line_are_those_of_the_library()
    {
        using var run = new ConsoleRun();
        CreatureOptions options = CreatureOptions.Default with
        {
            Kind = RequestedKind.Walking,
            MinScale = 0.25,
            MaxScale = 0.75,
            MinLegPairs = 2,
            MaxLegPairs = 3,
            BodyPlans = new([new BodyPlanWeight(Anatomy.BodyPlan.Hexapod, 5), new BodyPlanWeight(Anatomy.BodyPlan.Upright, 0)]),
            BaseBodies = new([new BaseBodyWeight("insect", 2.5)]),
            Palette = PaletteMood.Dark,
            Ornaments = OrnamentLevel.Rich,
            TriangleBudget = 30000,
        };
        File.WriteAllText(run.At("o.json"), OptionsJson.Write(options with { Palette = PaletteMood.Pale }));
        Assert.Equal(0, run.Run("generate", "--seed", "3", "--no-picture", "--out", "a", "--options", "o.json", "--palette", "dark"));
        Assert.Equal(0, run.Run(
            "generate", "--seed", "3", "--no-picture", "--out", "b", "--kind", "walking", "--scale", "0.25-0.75", "--leg-pairs", "2-3", "--plans", "hexapod=5,upright=0",
            "--bodies", "insect=2.5", "--palette", "dark", "--ornaments", "rich", "--triangles", "30000"));
        byte[] expected = Gltf.GlbFile.Write(CreatureGenerator.Generate(3, options), new CreatureGen.Gltf.GltfOptions { TextureSize = 1024, Provenance = OptionsJson.Write(options) });
        Assert.Equal(expected, run.Bytes("a/creature-3.glb"));
        Assert.Equal(expected, run.Bytes("b/creature-3.glb"));
    }
}
