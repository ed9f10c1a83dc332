using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Console;
using CreatureGen.Events;
using CreatureGen.Gltf.Models;
using CreatureGen.Motion.Toolkit;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class EventsVerbTests
{
    [Theory]
    [InlineData("footstep")]
    [InlineData("whoosh")]
    public void Json_holds_what_the_rule_finds_in_each_clip_of_the_file(string preset)
    {
        using ConsoleRun run = Walker("walk,bite");
        Assert.Equal(ExitCode.Done, run.Run("events", "creature-42.glb", "--preset", preset, "--json"));
        Assert.Equal("", run.Error);
        SkinnedModel model = ModelReader.Read(new MemoryStream(run.Bytes("creature-42.glb"))).Model!;
        AngularRule rule = AngularRules.All.Single(known => known.Name == preset);
        Assert.Equal(["clips"], run.Json().EnumerateObject().Select(member => member.Name));
        JsonElement[] clips = [.. run.Json().GetProperty("clips").EnumerateArray()];
        Assert.Equal(["Walk", "Bite"], clips.Select(clip => clip.GetProperty("name").GetString()));
        foreach ((JsonElement told, KeyedClip clip) in clips.Zip(model.Clips))
        {
            var found = AngularEventDetector.Find(clip, model.Skeleton, rule).Events.Select(one => (one.Time, one.Name, one.Joint, one.Strength));
            Assert.Equal(found, told.GetProperty("events").EnumerateArray().Select(one =>
            {
                Assert.Equal(["time", "name", "joint", "strength"], one.EnumerateObject().Select(member => member.Name));
                return (one.GetProperty("time").GetSingle(), one.GetProperty("name").GetString()!, one.GetProperty("joint").GetString()!, one.GetProperty("strength").GetSingle());
            }));
        }
    }

    [Fact]
    public void A_walk_has_one_footstep_of_each_foot_and_people_read_them_in_lines()
    {
        using ConsoleRun run = Walker("walk");
        Assert.Equal(ExitCode.Done, run.Run("events", "creature-42.glb"));
        string[] lines = run.Out.Split(Environment.NewLine, StringSplitOptions.RemoveEmptyEntries);
        Assert.StartsWith("Walk  ", lines[0], StringComparison.Ordinal);
        Assert.EndsWith(" s, 4 events", lines[0], StringComparison.Ordinal);
        string[][] words = [.. lines.Skip(1).Select(line => line.Split(' ', StringSplitOptions.RemoveEmptyEntries))];
        Assert.All(words, line => Assert.Equal((4, "footstep"), (line.Length, line[1])));
        Assert.Equal(4, words.Select(line => line[2]).Distinct().Count());
    }

    [Fact]
    public void A_plot_is_a_picture_beside_what_is_told()
    {
        using ConsoleRun run = Walker("walk");
        Assert.Equal(ExitCode.Done, run.Run("events", "creature-42.glb", "--json"));
        string alone = run.Out;
        Assert.Equal(ExitCode.Done, run.Run("events", "creature-42.glb", "--json", "--plot", "steps.png"));
        Assert.Equal(alone, run.Out);
        Assert.Equal([0x89, (byte)'P', (byte)'N', (byte)'G'], run.Bytes("steps.png").Take(4));
        byte[] first = run.Bytes("steps.png");
        Assert.Equal(ExitCode.Done, run.Run("events", "creature-42.glb", "--plot", "steps.png"));
        Assert.Equal(first, run.Bytes("steps.png"));
    }

    [Fact]
    public void What_it_cannot_do_is_refused_in_one_line_and_nothing_is_written()
    {
        using ConsoleRun run = Walker("none");
        File.WriteAllText(run.At("words.glb"), "no model at all");
        string[] before = run.Files;
        Assert.Equal("creaturegen: events: --preset = 'footsteps'; expected one of " + string.Join(", ", AngularRules.All.Select(rule => rule.Name)) + "; did you mean footstep?", run.Refusal(ExitCode.BadInput, "events", "creature-42.glb", "--preset", "footsteps"));
        Assert.Contains("has no clips; expected a file with animations", run.Refusal(ExitCode.BadInput, "events", "creature-42.glb", "--plot", "a.png"), StringComparison.Ordinal);
        Assert.Contains("words.glb", run.Refusal(ExitCode.BadInput, "events", "words.glb", "--plot", "a.png"), StringComparison.Ordinal);
        Assert.Contains("its folder does not exist", run.Refusal(ExitCode.CannotWrite, "events", "creature-42.glb", "--plot", "no/a.png"), StringComparison.Ordinal);
        Assert.Equal(before, run.Files);
    }

    /// <summary>A folder with the file of a quadruped that walks.</summary>
    private static ConsoleRun Walker(string clips)
    {
        var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("generate", "--seed", "42", "--kind", "walking", "--textures", "none", "--no-picture", "--clips", clips));
        return run;
    }
}
