using System;
using System.IO;
using System.Linq;
using System.Numerics;
using CreatureGen.Console;
using CreatureGen.Gltf;
using CreatureGen.Gltf.Models;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class TeachVerbTests
{
    [Fact]
    public void A_character_gets_clips_whose_feet_stand_on_its_ground()
    {
        using var run = new ConsoleRun();
        Write(run, "hero.glb");
        Assert.Equal(ExitCode.Done, run.Run("teach", "hero.glb", "--clips", "idle,walk,bite", "--out", "moves.glb"));
        Assert.EndsWith("3 clips added: Idle, Walk, Bite" + Environment.NewLine, run.Out, StringComparison.Ordinal);
        SkinnedModel model = Read(run, "moves.glb");
        Assert.Equal(["Idle", "Walk", "Bite"], model.Clips.Select(clip => clip.Name));
        IClip walk = model.Clips[1];
        Assert.Equal(4, walk.Events.Select(one => one.Joint).Distinct().Count());
        var pose = new Pose(new Quaternion[model.Skeleton.Count], new Vector3[model.Skeleton.Count]);
        int[] balls = [.. Enumerable.Range(0, model.Skeleton.Count).Where(joint => model.Skeleton.Joints[joint].Role == JointRole.Ball)];
        float rest = balls.Min(joint => model.Skeleton.ModelPositions[joint].Y);
        for (int i = 0; i < 20; i++)
        {
            walk.Sample(walk.Duration * i / 20f, pose);
            ForwardKinematics.LocalToModel(model.Skeleton, pose, pose);
            float lowest = float.MaxValue;
            foreach (int ball in balls)
            {
                lowest = Math.Min(lowest, pose.Positions[ball].Y);
            }

            Assert.InRange(lowest, 0.8f * rest, 1.5f * rest);
        }
    }

    [Fact]
    public void The_same_file_is_taught_the_same_bytes()
    {
        using var run = new ConsoleRun();
        Write(run, "hero.glb");
        foreach (string name in new[] { "first.glb", "second.glb" })
        {
            Assert.Equal(ExitCode.Done, run.Run("teach", "hero.glb", "--clips", "walk,jump", "--mass", "40", "--out", name));
        }

        Assert.Equal(run.Bytes("first.glb"), run.Bytes("second.glb"));
    }

    [Fact]
    public void What_cannot_be_taught_is_told_and_nothing_is_written()
    {
        using var run = new ConsoleRun();
        Write(run, "hero.glb");
        using (var stream = File.Create(run.At("fish.glb")))
        {
            GlbWriter.Write(CreatureGenerator.Generate(3, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 0 }), GltfOptions.Default with { TextureSize = 0 }, stream);
        }

        Assert.Contains("no pair of legs that stands", run.Refusal(ExitCode.BadInput, "teach", "fish.glb", "--out", "a.glb"), StringComparison.Ordinal);
        Assert.Contains("--mass = '-1'", run.Refusal(ExitCode.BadInput, "teach", "hero.glb", "--mass", "-1", "--out", "a.glb"), StringComparison.Ordinal);
        Assert.Contains("there is no such file", run.Refusal(ExitCode.BadInput, "teach", "none.glb", "--out", "a.glb"), StringComparison.Ordinal);
        Assert.Equal(["fish.glb", "hero.glb"], run.Files);
    }

    [Fact]
    public void A_clip_whose_name_is_taken_gets_a_number()
    {
        using var run = new ConsoleRun();
        Write(run, "hero.glb");
        Assert.Equal(ExitCode.Done, run.Run("teach", "hero.glb", "--clips", "walk", "--out", "once.glb"));
        Assert.Equal(ExitCode.Done, run.Run("teach", "once.glb", "--clips", "idle,walk", "--out", "twice.glb"));
        Assert.Equal(["Walk", "Idle", "Walk_2"], Read(run, "twice.glb").Clips.Select(clip => clip.Name));
    }

    private static void Write(ConsoleRun run, string name)
    {
        using FileStream stream = File.Create(run.At(name));
        GlbWriter.Write(Walkers.Any(101), GltfOptions.Default with { TextureSize = 0 }, stream);
    }

    private static SkinnedModel Read(ConsoleRun run, string name)
    {
        using FileStream stream = File.OpenRead(run.At(name));
        ModelReading reading = ModelReader.Read(stream);
        return reading.Model ?? throw new InvalidOperationException($"{reading.Problem}");
    }
}
