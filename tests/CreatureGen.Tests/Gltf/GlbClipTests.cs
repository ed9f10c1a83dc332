using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Sampling;
using CreatureGen.Tests.Sampling;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbClipTests
{
    private const int Frames = 31;

    private static readonly Creature Subject = SpeciesSubject.Of("cobra", RequestedKind.Walking);

    [Fact]
    public void Every_clip_keys_the_same_joints_whichever_of_them_moves_each()
    {
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { Clips = [Nodding("Idle", "Head"), Nodding("Look", "Jaw")] });
        JsonElement animations = file.Json.GetProperty("animations");
        Assert.Equal(["Idle", "Look"], animations.EnumerateArray().Select(a => a.GetProperty("name").GetString()));
        string[] targets = animations.EnumerateArray().Select(a => string.Join(",", a.GetProperty("channels").EnumerateArray().Select(c => c.GetProperty("target").GetRawText()))).ToArray();
        Assert.Equal(targets[0], targets[1]);
        Assert.Equal(2, animations[0].GetProperty("channels").GetArrayLength());
    }

    [Fact]
    public void Keys_are_the_frames_at_thirty_a_second_and_the_last_is_the_first()
    {
        Clip clip = Nodding("Idle", "Head");
        GlbFile file = GlbFile.Of(Subject, new GltfOptions { Clips = [clip] });
        JsonElement animation = file.Json.GetProperty("animations")[0];
        JsonElement sampler = animation.GetProperty("samplers")[0];
        double[] times = file.Numbers(sampler.GetProperty("input").GetInt32());
        double[] values = file.Numbers(sampler.GetProperty("output").GetInt32());
        Assert.Equal(Frames, times.Length);
        Assert.Equal(0, times[0]);
        Assert.Equal(1, times[30], 6);
        int head = Subject.Skeleton.IndexOf("Head");
        for (int frame = 0; frame < Frames; frame++)
        {
            Assert.Equal(clip.RotationsAt(frame)[head].X, (float)values[4 * frame]);
        }

        Assert.Equal(values[..4], values[^4..]);
        JsonElement input = file.Accessor(sampler.GetProperty("input").GetInt32());
        Assert.Equal(0, input.GetProperty("min")[0].GetDouble());
        Assert.Equal(times[^1], input.GetProperty("max")[0].GetDouble());
        Assert.True(animation.GetProperty("extras").GetProperty("loop").GetBoolean());
        Assert.Equal(1.5, animation.GetProperty("extras").GetProperty("speed").GetDouble());
    }

    [Fact]
    public void Signs_of_rotations_do_not_jump()
    {
        Clip clip = Nodding("Idle", "Head", flip: 7);
        for (int frame = 1; frame < clip.Frames; frame++)
        {
            for (int joint = 0; joint < clip.Joints; joint++)
            {
                Assert.True(Quaternion.Dot(clip.RotationsAt(frame)[joint], clip.RotationsAt(frame - 1)[joint]) > 0);
            }
        }
    }

    [Fact]
    public void A_loop_that_does_not_close_is_refused()
    {
        Skeleton(out Quaternion[] rotations, out Vector3[] positions);
        positions[^1] += new Vector3(1e-6f, 0f, 0f);
        ArgumentException refusal = Assert.Throws<ArgumentException>(() => new Clip("Walk", ClipEnd.Loops, Clip.UsualRate, 0f, Subject.Skeleton.Count, rotations, positions));
        Assert.Contains("Walk", refusal.Message, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("")]
    [InlineData("a b")]
    [InlineData("Gehen!")]
    public void A_name_that_importers_would_change_is_refused(string name)
    {
        Skeleton(out Quaternion[] rotations, out Vector3[] positions);
        Assert.Throws<ArgumentException>(() => new Clip(name, ClipEnd.Loops, Clip.UsualRate, 0f, Subject.Skeleton.Count, rotations, positions));
    }

    [Fact]
    public void Two_clips_of_one_name_and_clips_of_another_skeleton_are_refused()
    {
        Clip clip = Nodding("Idle", "Head");
        Assert.Throws<InvalidOperationException>(() => GlbFile.Write(Subject, new GltfOptions { Clips = [clip, clip] }));
        Creature other = CreatureGenerator.Build(BlueprintSampler.Sample(6, LocomotionKind.Walking));
        Assert.Throws<InvalidOperationException>(() => GlbFile.Write(other, new GltfOptions { Clips = [clip] }));
    }

    [Fact]
    public async Task The_validator_of_the_standard_finds_nothing_in_files_with_clips()
    {
        string folder = Directory.CreateTempSubdirectory("creaturegen-").FullName;
        try
        {
            byte[] bytes = GlbFile.Write(Subject, new GltfOptions { Clips = [Nodding("Idle", "Head"), Nodding("Look", "Jaw")] });
            await File.WriteAllBytesAsync(Path.Combine(folder, "clips.glb"), bytes, TestContext.Current.CancellationToken);
            (int exitCode, string output, string errors) = await GltfTools.RunAsync("validate.mjs", folder, TestContext.Current.CancellationToken);
            Assert.True(exitCode == 0, output + errors);
        }
        finally
        {
            Directory.Delete(folder, recursive: true);
        }
    }

    private static void Skeleton(out Quaternion[] rotations, out Vector3[] positions)
    {
        var r = new List<Quaternion>();
        var p = new List<Vector3>();
        for (int frame = 0; frame < Frames; frame++)
        {
            r.AddRange(Subject.Skeleton.LocalRotations);
            p.AddRange(Subject.Skeleton.LocalPositions);
        }

        rotations = r.ToArray();
        positions = p.ToArray();
    }

    private static Clip Nodding(string name, string joint, int flip = -1)
    {
        Skeleton(out Quaternion[] rotations, out Vector3[] positions);
        int index = Subject.Skeleton.IndexOf(joint);
        int count = Subject.Skeleton.Count;
        for (int frame = 0; frame < Frames - 1; frame++)
        {
            Quaternion turn = Rotation.FromAxisAngle(Vector3.UnitX, 0.3f * MathF.Sin(frame * MathF.Tau / (Frames - 1)));
            Quaternion q = Rotation.Multiply(rotations[(frame * count) + index], turn);
            rotations[(frame * count) + index] = frame == flip ? -q : q;
        }

        rotations[((Frames - 1) * count) + index] = rotations[index];
        return new Clip(name, ClipEnd.Loops, Clip.UsualRate, 1.5f, count, rotations, positions);
    }
}
