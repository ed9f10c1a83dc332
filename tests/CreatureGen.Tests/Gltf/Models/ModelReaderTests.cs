using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Text.Json.Nodes;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Gltf.Models;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Gltf.Models;

public sealed class ModelReaderTests
{
    [Theory]
    [InlineData(-1.0)]
    [InlineData(0.0)]
    [InlineData(0.31)]
    [InlineData(0.77)]
    [InlineData(1.1)]
    [InlineData(1.25)]
    public void Every_vertex_of_a_foreign_character_is_where_the_specification_puts_it(double time)
    {
        byte[] file = HumanoidFile.Create().Write();
        SkinnedModel model = Read(file);
        var pose = new MovingPose(model.Skeleton);
        if (time >= 0)
        {
            model.Clips[0].Sample((float)time, pose.Local);
            ForwardKinematics.LocalToModel(model.Skeleton, pose.Local, pose.Model);
        }

        Vector3[] expected = new NaiveGltf(file).Vertices(time);
        Assert.True(expected.Zip(Skinned(model, pose)).Max(p => Vector3.Distance(p.First, p.Second)) < 1e-4f);
    }

    [Fact]
    public void A_character_whose_vertices_are_interleaved_is_the_same_character()
    {
        SkinnedModel apart = Read(HumanoidFile.Create().Write());
        SkinnedModel woven = Read(HumanoidFile.Create().Interleave().Write());
        Assert.Equal(apart.Mesh.Positions.ToArray(), woven.Mesh.Positions.ToArray());
        Assert.Equal(apart.Mesh.Weights.ToArray(), woven.Mesh.Weights.ToArray());
    }

    [Fact]
    public void A_clip_written_back_is_read_again_and_all_else_stays()
    {
        SkinnedModel model = Read(HumanoidFile.Create().Write());
        Clip added = Swing(model.Skeleton);
        using var stream = new MemoryStream();
        ModelWriter.Write(model, [added], stream);
        SkinnedModel again = Read(stream.ToArray());
        Assert.Equal(["Wave", "Swing"], again.Clips.Select(c => c.Name));
        Assert.Equal(new ClipEvent(0.25f, "footstep", "mixamorig:RightUpLeg", 0.75f), Assert.Single(again.Clips[1].Events));
        Assert.Equal(ClipEnd.Loops, again.Clips[1].End);
        Assert.Equal(model.Mesh.Positions.ToArray(), again.Mesh.Positions.ToArray());
        JsonNode json = JsonNode.Parse(stream.ToArray().AsSpan(20, BitConverter.ToInt32(stream.ToArray(), 12)))!;
        Assert.Equal("Cloth", (string?)json["materials"]![0]!["name"]);
        for (float time = -0.1f; time < 1.2f; time += 0.0371f)
        {
            Assert.True(Apart(model.Skeleton, added, again.Clips[1], time) < 1e-4f);
            Assert.True(Apart(model.Skeleton, model.Clips[0], again.Clips[0], time) < 1e-7f);
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Buzzing, Explicit = true)]
    public void Grown_creatures_come_back_as_models(BodyPlan plan)
    {
        Creature creature = Subject(plan);
        IReadOnlyList<Clip> clips = ClipBaker.Bake(creature);
        SkinnedModel model = Read(GlbFile.Write(creature, new GltfOptions { Clips = clips, ClipPrecision = null }));
        Assert.Equal(creature.Skeleton.Joints.Select(j => (j.Name, j.Parent, j.LocalPosition)), model.Skeleton.Joints.Select(j => (j.Name, j.Parent, j.LocalPosition)));
        Assert.Equal(creature.Mesh.Triangles.Length, model.Mesh.Triangles.Length);
        Assert.Equal(clips.Select(c => (c.Name, c.End)), model.Clips.Select(c => (c.Name, c.End)));
        for (int c = 0; c < clips.Count; c++)
        {
            for (int k = 0; k < 9; k++)
            {
                float time = clips[c].Duration * k * 0.127f;
                Assert.True(Apart(creature.Skeleton, clips[c], model.Clips[c], time) < 1e-4f, clips[c].Name);
            }
        }
    }

    [Fact]
    public void A_foreign_clip_that_ends_as_it_begins_goes_around_and_another_stays()
    {
        HumanoidFile open = HumanoidFile.Create();
        open.Json["animations"]![0]!.AsObject().Remove("extras");
        Assert.Equal(ClipEnd.Stays, Assert.Single(Read(open.Write()).Clips).End);
        Assert.Equal(ClipEnd.Loops, Assert.Single(Read(HumanoidFile.Create().Close().Write()).Clips).End);
    }

    [Fact]
    public void A_leg_bone_of_a_foreign_character_points_at_its_knee()
    {
        Skeleton skeleton = Read(HumanoidFile.Create().Write()).Skeleton;
        Joint thigh = skeleton.Joints[skeleton.IndexOf("mixamorig:LeftUpLeg")];
        Assert.True(Vec.Distance(-Vector3.UnitX, thigh.Along) < 1e-6f);
        Assert.Equal(0.45f, thigh.Length, 5);
    }

    public static TheoryData<string, string> Defects => new()
    {
        { "nodes/1/scale=[1,2,1]", "scale (1, 2, 1)" },
        { "nodes/3/children=[1]", "a node below itself" },
        { "nodes/4/children=[3]", "one parent" },
        { "nodes/2/children=[3]", "one root" },
        { "nodes/2/matrix=[1,0,0,0,0,1,0,0,0,0,-1,0,0,0,0,1]", "mirrors" },
        { "nodes/3/rotation=[0,0,0,0]", "a quaternion of length 1" },
        { "nodes/3/rotation=[0,0,0]", "4 numbers" },
        { "skins/0/joints=[]", "a skinned model" },
        { "skins/0/joints=[99]", "a whole number of 0 to" },
        { "accessors/0/count=100000", "within the" },
        { "accessors/0/count=-1", "a whole number" },
        { "accessors/0/type=\"VEC2\"", "expected VEC3" },
        { "accessors/0/componentType=7", "5126" },
        { "bufferViews/0/byteOffset=1000000", "binary chunk" },
        { "buffers/0/uri=\"model.bin\"", "buffer 0" },
        { "meshes/0/primitives/0/mode=5", "4 (triangles)" },
        { "meshes/0/primitives/0/attributes/JOINTS_0=99", "one of the" },
        { "animations/0/samplers/0/interpolation=\"SPLINE\"", "STEP, LINEAR or CUBICSPLINE" },
        { "animations/0/samplers/0/output=0", "expected VEC4" },
        { "animations/0/channels/0/sampler=7", "0 to 3" },
        { "extensionsRequired=[\"KHR_draco_mesh_compression\"]", "compressed" },
        { "asset/version=\"1.0\"", "2.0" },
    };

    [Theory]
    [MemberData(nameof(Defects))]
    public void What_is_wrong_is_told_with_its_place(string change, string expected)
    {
        HumanoidFile file = HumanoidFile.Create();
        string[] parts = change.Split('=', 2);
        string[] way = parts[0].Split('/');
        JsonNode at = file.Json;
        foreach (string step in way[..^1])
        {
            at = int.TryParse(step, out int index) ? at[index]! : at[step]!;
        }

        at[way[^1]] = JsonNode.Parse(parts[1]);
        using var stream = new MemoryStream(file.Write());
        ModelReading reading = ModelReader.Read(stream);
        Assert.Null(reading.Model);
        Assert.Contains(expected, reading.Problem!.ToString(), StringComparison.Ordinal);
        Assert.Contains("; expected ", reading.Problem.ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Broken_bytes_give_a_model_or_a_report_and_never_anything_else()
    {
        byte[] sound = HumanoidFile.Create().Write();
        var random = new Random(5);
        int read = 0;
        for (int i = 0; i < 400; i++)
        {
            byte[] broken = i % 4 == 0 ? sound[..random.Next(sound.Length)] : (byte[])sound.Clone();
            for (int k = 0; k < i % 7 && broken.Length > 0; k++)
            {
                broken[random.Next(broken.Length)] = (byte)random.Next(256);
            }

            using var stream = new MemoryStream(broken);
            ModelReading reading = ModelReader.Read(stream);
            Assert.True(reading.Model is null != reading.Problem is null);
            read += reading.Model is null ? 0 : 1;
        }

        Assert.InRange(read, 40, 300);
    }

    [Fact]
    public void Clips_of_other_skeletons_and_names_that_are_taken_are_refused()
    {
        SkinnedModel model = Read(HumanoidFile.Create().Write());
        using var stream = new MemoryStream();
        Assert.Contains("expected the 7", Assert.Throws<ArgumentException>(() => ModelWriter.Write(model, [Swing(Subject(BodyPlan.Digitigrade).Skeleton)], stream)).Message, StringComparison.Ordinal);
        Assert.Contains("unique names", Assert.Throws<ArgumentException>(() => ModelWriter.Write(model, [model.Clips[0]], stream)).Message, StringComparison.Ordinal);
        Assert.Equal(0, stream.Length);
    }

    internal static SkinnedModel Read(byte[] file)
    {
        using var stream = new MemoryStream(file);
        return ModelReader.Read(stream).GetModel();
    }

    /// <summary>One second of every joint swinging about an axis of its own, with a footstep.</summary>
    internal static Clip Swing(Skeleton skeleton)
    {
        int joints = skeleton.Count;
        var rotations = new Quaternion[31 * joints];
        var positions = new Vector3[31 * joints];
        for (int i = 0; i < rotations.Length; i++)
        {
            int joint = i % joints;
            double angle = 0.4 * PortableMath.Sin(PortableMath.Tau * (i / joints % 30) / 30);
            rotations[i] = Rotation.Normalize(Rotation.Multiply(skeleton.LocalRotations[joint], Rotation.FromAxisAngle(joint % 2 == 0 ? Vector3.UnitX : Vector3.UnitZ, angle)));
            positions[i] = skeleton.LocalPositions[joint];
        }

        return new Clip("Swing", ClipEnd.Loops, 30, 1.5f, joints, rotations, positions).WithEvents([new ClipEvent(0.25f, "footstep", skeleton.Joints[Math.Min(4, joints - 1)].Name, 0.75f)]);
    }

    private static Creature Subject(BodyPlan plan)
    {
        for (ulong seed = 1; ; seed++)
        {
            Creature creature = CreatureGenerator.Generate(seed);
            if (creature.Blueprint.Plan == plan)
            {
                return creature;
            }
        }
    }

    /// <summary>Farthest apart that two clips put a joint of the skeleton at a time.</summary>
    private static float Apart(Skeleton skeleton, IClip one, IClip other, float time)
    {
        var a = new MovingPose(skeleton);
        var b = new MovingPose(skeleton);
        one.Sample(time, a.Local);
        other.Sample(time, b.Local);
        ForwardKinematics.LocalToModel(skeleton, a.Local, a.Model);
        ForwardKinematics.LocalToModel(skeleton, b.Local, b.Model);
        return a.ModelPositions.Zip(b.ModelPositions).Max(p => Vec.Distance(p.First, p.Second));
    }

    private static Vector3[] Skinned(SkinnedModel model, MovingPose pose)
    {
        var matrices = new Matrix4x4[model.Skeleton.Count];
        model.FillSkinMatrices(pose.Model, matrices);
        return model.Mesh.Positions.ToArray().Zip(model.Mesh.Weights.ToArray(), (p, w) =>
            (Vector3.Transform(p, matrices[w.Joint0]) * w.Weights.X) + (Vector3.Transform(p, matrices[w.Joint1]) * w.Weights.Y)
            + (Vector3.Transform(p, matrices[w.Joint2]) * w.Weights.Z) + (Vector3.Transform(p, matrices[w.Joint3]) * w.Weights.W)).ToArray();
    }
}
