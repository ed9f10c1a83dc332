using System;
using System.IO;
using System.Numerics;
using System.Text.Json.Nodes;
using CreatureGen.Gltf.Models;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Rigging;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Gltf.Models;

public sealed class VrmSpringTests
{
    private const float Stiffness = 0.5f;
    private const float Drag = 0.05f;
    private const float Power = 0.08f;

    [Theory]
    [InlineData(60)]
    [InlineData(144)]
    public void Hair_of_a_file_swings_as_the_extension_says(int rate)
    {
        SkinnedModel model = Read(File());
        ModelSpring spring = Assert.Single(model.Springs);
        Assert.Equal(("Hair", 2, 1), (spring.Name, spring.Rig.Joints.Length, spring.Colliders.Count));
        Skeleton skeleton = model.Skeleton;
        int first = spring.Rig.Joints[0];
        Assert.Equal(["Hair1", "Hair2"], [skeleton.Joints[first].Name, skeleton.Joints[spring.Rig.Joints[1]].Name]);
        var state = new SpringState(spring.Rig);
        Vector3[] naive = Naive(skeleton, first, 60);
        MovingPose pose = new(skeleton);
        float worst = 0f;
        float swung = 0f;
        for (int i = 0; i <= rate; i++)
        {
            pose = new MovingPose(skeleton);
            SpringBones.Update(spring.Rig, state, spring.Settings, RootPlace.Identity, default, i == 0 ? 0f : 1f / rate, pose.Local, pose.Model);
            float frame = i * 60f / rate;
            if (Math.Abs(frame - MathF.Round(frame)) < 1e-3f)
            {
                Vector3 tip = pose.ModelPositions[first + 2];
                worst = Math.Max(worst, Vec.Distance(tip, naive[(int)MathF.Round(frame)]));
                swung = Math.Max(swung, Vec.Distance(tip, skeleton.Joints[first + 2].ModelPosition));
            }
        }

        Assert.True(swung > 0.03f, $"swung {swung}");
        // The step of the extension is half a frame ahead at each bone.
        Assert.True(worst < 0.15f * swung, $"worst {worst} of {swung}");
    }

    [Fact]
    public void Hair_stays_out_of_the_colliders_of_its_groups()
    {
        SkinnedModel model = Read(File(gravity: 2f));
        ModelSpring spring = model.Springs[0];
        var state = new SpringState(spring.Rig);
        int first = spring.Rig.Joints[0];
        for (int i = 0; i < 120; i++)
        {
            MovingPose pose = new(model.Skeleton);
            SpringBones.Update(spring.Rig, state, spring.Settings, RootPlace.Identity, [.. spring.Colliders], 1f / 60f, pose.Local, pose.Model);
            int carrier = model.Skeleton.Parents[first];
            Vector3 centre = pose.ModelPositions[carrier] + Rotation.Rotate(pose.ModelRotations[carrier], new Vector3(0.1f, 0.1f, 0f));
            Assert.True(Vec.Distance(centre, pose.ModelPositions[first + 1]) > 0.03f + 0.01f - 1e-3f, $"{i}");
        }
    }

    [Fact]
    public void What_is_wrong_with_springs_is_told_once_and_where()
    {
        Told("extensions.VRMC_springBone.springs[0].joints[1].node", file => Joint(file, 1)["node"] = 99);
        Told("extensions.VRMC_springBone.springs[0].joints[1].stiffness", file => Joint(file, 1)["stiffness"] = -1);
        Told("a node below that of the joint before it", file => Joint(file, 1)["node"] = 4);
        Told("one of the 1 collider groups", file => Springs(file)["springs"]![0]!["colliderGroups"] = new JsonArray(3));
        Told("a sphere or a capsule", file => Springs(file)["colliders"]![0]!["shape"] = new JsonObject());

        static void Told(string what, Action<JsonObject> spoil)
        {
            HumanoidFile file = File();
            spoil(file.Json);
            using var stream = new MemoryStream(file.Write());
            Assert.Contains(what, ModelReader.Read(stream).Problem!.ToString(), StringComparison.Ordinal);
        }

        static JsonNode Joint(JsonObject file, int index) => Springs(file)["springs"]![0]!["joints"]![index]!;

        static JsonNode Springs(JsonObject file) => file["extensions"]!["VRMC_springBone"]!;
    }

    [Fact]
    public void Springs_stay_in_a_file_that_is_written_back()
    {
        SkinnedModel model = Read(File());
        using var destination = new MemoryStream();
        ModelWriter.Write(model, [], destination);
        destination.Position = 0;
        Assert.Single(ModelReader.Read(destination).GetModel().Springs);
    }

    /// <summary>The humanoid with a chain of three nodes on its spine that no skin names.</summary>
    private static HumanoidFile File(float gravity = Power)
    {
        HumanoidFile file = HumanoidFile.Create();
        JsonArray nodes = file.Json["nodes"]!.AsArray();
        nodes[7]!["children"] = new JsonArray(8);
        nodes.Add(new JsonObject { ["name"] = "Hair1", ["translation"] = new JsonArray(0, 10, 0), ["children"] = new JsonArray(9) });
        nodes.Add(new JsonObject { ["name"] = "Hair2", ["translation"] = new JsonArray(20, 0, 0), ["children"] = new JsonArray(10) });
        nodes.Add(new JsonObject { ["name"] = "HairTip", ["translation"] = new JsonArray(0, 0, 15) });
        JsonObject Joint(int node) => new() { ["node"] = node, ["stiffness"] = Stiffness, ["dragForce"] = Drag, ["gravityPower"] = gravity, ["gravityDir"] = new JsonArray(0, -1, 0), ["hitRadius"] = 1.0 };
        file.Json["extensionsUsed"] = new JsonArray("VRMC_springBone");
        file.Json["extensions"] = new JsonObject
        {
            ["VRMC_springBone"] = new JsonObject
            {
                ["specVersion"] = "1.0",
                ["colliders"] = new JsonArray(new JsonObject { ["node"] = 7, ["shape"] = new JsonObject { ["sphere"] = new JsonObject { ["offset"] = new JsonArray(10, 10, 0), ["radius"] = 3 } } }),
                ["colliderGroups"] = new JsonArray(new JsonObject { ["colliders"] = new JsonArray(0) }),
                ["springs"] = new JsonArray(new JsonObject { ["name"] = "Hair", ["joints"] = new JsonArray(Joint(8), Joint(9), new JsonObject { ["node"] = 10 }), ["colliderGroups"] = new JsonArray(0) }),
            },
        };
        return file;
    }

    private static SkinnedModel Read(HumanoidFile file)
    {
        using var stream = new MemoryStream(file.Write());
        return ModelReader.Read(stream).GetModel();
    }

    /// <summary>Places of the tip at each frame, by the formulas of the extension as they stand in it.</summary>
    private static Vector3[] Naive(Skeleton skeleton, int first, int frames)
    {
        Vector3[] tail = new Vector3[2], before = new Vector3[2];
        float[] length = new float[2];
        for (int k = 0; k < 2; k++)
        {
            tail[k] = before[k] = skeleton.Joints[first + k + 1].ModelPosition;
            length[k] = Vec.Distance(tail[k], skeleton.Joints[first + k].ModelPosition);
        }

        const float Step = 1f / 60f;
        var places = new Vector3[frames + 1];
        places[0] = tail[1];
        for (int i = 1; i <= frames; i++)
        {
            Quaternion parent = skeleton.Joints[skeleton.Parents[first]].ModelRotation;
            Vector3 head = skeleton.Joints[first].ModelPosition;
            for (int k = 0; k < 2; k++)
            {
                Joint joint = skeleton.Joints[first + k];
                Quaternion rest = Rotation.Multiply(parent, joint.LocalRotation);
                Vector3 axis = Vec.Normalize(skeleton.Joints[first + k + 1].LocalPosition);
                Vector3 next = tail[k] + ((tail[k] - before[k]) * (1f - Drag)) + (Rotation.Rotate(rest, axis) * (Step * Stiffness)) + (new Vector3(0f, -1f, 0f) * (Step * Power));
                next = head + (Vec.Normalize(next - head) * length[k]);
                before[k] = tail[k];
                tail[k] = next;
                parent = Rotation.Multiply(Rotation.FromTo(Rotation.Rotate(rest, axis), next - head), rest);
                head = next;
            }

            places[i] = tail[1];
        }

        return places;
    }
}
