using System;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text;
using CreatureGen.Console;
using CreatureGen.Gltf.Models;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class ClipOptionTests
{
    [Fact]
    public void Clips_asked_for_by_name_are_in_the_file_and_what_a_creature_cannot_do_is_left_out()
    {
        Assert.Equal(["Idle", "Walk", "TurnLeft", "Bite"], Clips("--clips", "bite,idle,WALK,turn-left,swim,glide").Select(clip => clip.Name));
    }

    [Fact]
    public void All_clips_are_all_that_the_library_bakes_of_the_creature()
    {
        string[] known = [.. ClipBaker.RecipesOf(new MotionProfile(CreatureGenerator.Generate(42, new CreatureOptions { Kind = RequestedKind.Walking }))).Select(recipe => recipe.Name)];
        Assert.Equal(known, Clips("--clips", "all").Select(clip => clip.Name));
    }

    [Theory]
    [InlineData("generic", "Walk", "Start")]
    [InlineData("godot", "Walk-loop", "Start")]
    [InlineData("unity", "Walk", "Start", Explicit = true)]
    [InlineData("unreal", "Walk", "Start", Explicit = true)]
    public void Clips_are_named_as_the_importer_of_the_engine_reads_them(string engine, params string[] names)
    {
        Assert.Equal(names, Clips("--clips", "walk,start", "--engine", engine).Select(clip => clip.Name));
    }

    [Fact(Explicit = true)]
    public void The_root_joint_stays_or_travels_and_keys_are_few_or_all()
    {
        KeyedClip stays = Assert.Single(Clips("--clips", "walk"));
        KeyedClip travels = Assert.Single(Clips("--clips", "walk", "--root-motion", "travels"));
        Assert.Equal(0f, Way(stays));
        Assert.True(Way(travels) > 0.1f);
        Assert.Equal(stays.Duration, travels.Duration);
        KeyedClip all = Assert.Single(Clips("--clips", "walk", "--keys", "all"));
        Assert.True(Keys(all) > Keys(stays), $"{Keys(all)} and {Keys(stays)}");
    }

    [Fact]
    public void What_nobody_knows_is_refused_in_one_line()
    {
        using var run = new ConsoleRun();
        Assert.Contains("--clips = 'walk,tort'", run.Refusal(ExitCode.BadInput, "generate", "--seed", "42", "--clips", "walk,tort"), StringComparison.Ordinal);
        Assert.Contains("did you mean trot?", run.Refusal(ExitCode.BadInput, "generate", "--seed", "42", "--clips", "trott"), StringComparison.Ordinal);
        Assert.Contains("expected one of generic, godot, unity, unreal", run.Refusal(ExitCode.BadInput, "generate", "--seed", "42", "--clips", "walk", "--engine", "source"), StringComparison.Ordinal);
        Assert.Contains("expected in-place or travels", run.Refusal(ExitCode.BadInput, "generate", "--seed", "42", "--clips", "walk", "--root-motion", "yes"), StringComparison.Ordinal);
        Assert.Contains("expected reduced or all", run.Refusal(ExitCode.BadInput, "generate", "--seed", "42", "--clips", "walk", "--keys", "few"), StringComparison.Ordinal);
        Assert.Empty(run.Files);
    }

    [Fact(Explicit = true)]
    public void A_film_has_a_sound_as_long_as_itself_with_its_events_in_it()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run("animate", "--seed", "42", "--gait", "walk", "--out", "walk.png", "--size", "64", "--sound", "walk.wav"));
        Assert.Equal(["walk-strip.png", "walk.png", "walk.wav"], run.Files);
        string[] told = run.Out.TrimEnd().Split("walk.wav: ")[1].Split(' ');
        Assert.Equal(["8", "events", "in"], told[..3]);
        float seconds = float.Parse(told[3], CultureInfo.InvariantCulture);
        byte[] wav = run.Bytes("walk.wav");
        Assert.Equal("RIFF", Encoding.ASCII.GetString(wav, 0, 4));
        Assert.Equal(wav.Length - 8, BitConverter.ToInt32(wav, 4));
        int rate = BitConverter.ToInt32(wav, 24);
        short[] samples = [.. Enumerable.Range(0, (wav.Length - 44) / 2).Select(i => BitConverter.ToInt16(wav, 44 + (2 * i)))];


        // A second longer, in which it dies away; seconds are told to a tenth.
        Assert.Equal((seconds + 1f) * rate, samples.Length, rate * 0.05f);
        Assert.True(samples.Max() > 1000, $"{samples.Max()}");
        Assert.Equal(ExitCode.Done, run.Run("animate", "--seed", "42", "--gait", "walk", "--out", "walk.png", "--size", "64", "--sound", "again.wav"));
        Assert.Equal(wav, run.Bytes("again.wav"));
    }

    [Theory]
    [InlineData("-")]
    [InlineData("walk.png")]
    [InlineData("walk-strip.png")]
    public void A_sound_does_not_go_where_a_picture_goes(string sound)
    {
        using var run = new ConsoleRun();
        Assert.Contains("a file beside the moving picture and its strip", run.Refusal(ExitCode.BadInput, "animate", "--seed", "42", "--gait", "walk", "--out", "walk.png", "--size", "64", "--sound", sound), StringComparison.Ordinal);
        Assert.Empty(run.Files);
    }

    private static float Way(KeyedClip clip)
    {
        var pose = new Pose(new Quaternion[clip.Joints], new Vector3[clip.Joints]);
        clip.Sample(0f, pose);
        Vector3 first = pose.Positions[0];
        clip.Sample(0.999f * clip.Duration, pose);
        return Vector3.Distance(first, pose.Positions[0]);
    }

    private static int Keys(KeyedClip clip) => clip.Rotations.Concat(clip.Positions).Sum(track => track.Count);

    /// <summary>The clips of the file of a quadruped.</summary>
    private static KeyedClip[] Clips(params string[] options)
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(["generate", "--seed", "42", "--kind", "walking", "--textures", "none", "--no-picture", .. options]));
        return [.. ModelReader.Read(new MemoryStream(run.Bytes("creature-42.glb"))).Model!.Clips];
    }
}
