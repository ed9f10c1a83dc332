using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System;
using CreatureGen.Creatures;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbSkinTests
{
    public static TheoryData<int> Numbers => new(Enumerable.Range(0, 12));

    [Theory]
    [MemberData(nameof(Numbers))]
    public void The_scene_has_the_mesh_and_the_root_joint_as_roots(int number)
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(number));
        GlbFile file = GlbFile.Of(creature);
        JsonElement nodes = file.Json.GetProperty("nodes");
        int[] roots = file.Json.GetProperty("scenes")[0].GetProperty("nodes").EnumerateArray().Select(n => n.GetInt32()).ToArray();
        Assert.Equal(2, roots.Length);
        Assert.Equal(["name", "mesh", "skin"], nodes[roots[0]].EnumerateObject().Select(p => p.Name));
        Assert.Equal("Root", nodes[roots[1]].GetProperty("name").GetString());
        JsonElement skin = file.Json.GetProperty("skins")[0];
        Assert.Equal(roots[1], skin.GetProperty("skeleton").GetInt32());
        Assert.Equal(creature.Skeleton.Joints.Select(j => j.Name), skin.GetProperty("joints").EnumerateArray().Select(j => nodes[j.GetInt32()].GetProperty("name").GetString()));
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Joints_hang_on_their_parents_without_a_node_in_between(int number)
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(number));
        JsonElement[] nodes = GlbFile.Of(creature).Json.GetProperty("nodes").EnumerateArray().ToArray();
        var parents = new Dictionary<string, string>();
        foreach (JsonElement node in nodes.Where(n => n.TryGetProperty("children", out _)))
        {
            foreach (double child in GlbFile.Array(node, "children")!)
            {
                parents.Add(nodes[(int)child].GetProperty("name").GetString()!, node.GetProperty("name").GetString()!);
            }
        }

        IReadOnlyList<Joint> joints = creature.Skeleton.Joints;
        Assert.All(joints.Skip(1), joint => Assert.Equal(joints[joint.Parent].Name, parents[joint.Name]));
        Assert.All(creature.AttachmentPoints, point => Assert.Equal(joints[point.Joint].Name, parents[point.Name]));
        Assert.Equal(joints.Count - 1 + creature.AttachmentPoints.Count, parents.Count);
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Inverse_binds_undo_the_rest_pose(int number)
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(number)));
        JsonElement skin = file.Json.GetProperty("skins")[0];
        double[] inverses = file.Numbers(skin.GetProperty("inverseBindMatrices").GetInt32());
        double[][] worlds = file.WorldMatrices();
        int[] joints = skin.GetProperty("joints").EnumerateArray().Select(j => j.GetInt32()).ToArray();
        for (int j = 0; j < joints.Length; j++)
        {
            double[] inverse = inverses[(16 * j)..((16 * j) + 16)];
            double[] product = GlbFile.Multiply(worlds[joints[j]], inverse);
            Assert.Equal([0.0, 0.0, 0.0, 1.0], new[] { inverse[3], inverse[7], inverse[11], inverse[15] });
            for (int k = 0; k < 16; k++)
            {
                Assert.Equal(k % 5 == 0 ? 1.0 : 0.0, product[k], 2e-6);
            }
        }
    }

    [Fact]
    public void Nodes_have_no_matrix_no_scale_and_no_identity()
    {
        foreach (JsonElement node in GlbFile.Of(SampleCreature.Build(SampleShape.Of(7))).Json.GetProperty("nodes").EnumerateArray())
        {
            Assert.False(node.TryGetProperty("matrix", out _));
            Assert.False(node.TryGetProperty("scale", out _));
            Assert.NotEqual([0, 0, 0], GlbFile.Array(node, "translation") ?? [1]);
            Assert.NotEqual([0, 0, 0, 1], GlbFile.Array(node, "rotation") ?? [1]);
        }
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Weights_sum_to_one_in_single_precision(int number)
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(number)));
        double[] weights = file.Numbers(file.Attribute("WEIGHTS_0"));
        double[] joints = file.Numbers(file.Attribute("JOINTS_0"));
        for (int i = 0; i < weights.Length; i += 4)
        {
            float sum = 0f;
            int used = 0;
            for (int k = i; k < i + 4; k++)
            {
                sum += (float)weights[k];
                used += weights[k] > 0 ? 1 : 0;
                Assert.True(weights[k] > 0 || joints[k] == 0);
            }

            Assert.True(Math.Abs(sum - 1f) <= 2e-7f * used, $"vertex {i / 4} sums to {sum:R}");
        }
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Vertices_of_one_place_follow_their_joints_alike(int number)
    {
        GlbFile file = GlbFile.Of(SampleCreature.Build(SampleShape.Of(number)));
        double[] positions = file.Numbers(file.Attribute("POSITION"));
        double[] joints = file.Numbers(file.Attribute("JOINTS_0"));
        double[] weights = file.Numbers(file.Attribute("WEIGHTS_0"));
        var followed = new Dictionary<(double, double, double), double[]>();
        int repeats = 0;
        for (int i = 0; i < positions.Length / 3; i++)
        {
            double[] influences = [.. joints[(4 * i)..((4 * i) + 4)], .. weights[(4 * i)..((4 * i) + 4)]];
            if (!followed.TryAdd((positions[3 * i], positions[(3 * i) + 1], positions[(3 * i) + 2]), influences))
            {
                Assert.Equal(followed[(positions[3 * i], positions[(3 * i) + 1], positions[(3 * i) + 2])], influences);
                repeats++;
            }
        }

        Assert.True(repeats > 0);
    }

    [Theory]
    [InlineData(255, 5121)]
    [InlineData(256, 5123)]
    [InlineData(400, 5123)]
    public void Joints_are_bytes_up_to_255_of_them_and_shorts_beyond(int count, int componentType)
    {
        var shape = new SampleShape(1, LegPairs: 0, Tail: 1);
        Creature creature = SampleCreature.Build(shape with { Spine = count - 5 });
        Assert.Equal(count, creature.Skeleton.Joints.Count);
        SkinWeights[] weights = creature.Mesh.Weights.ToArray();
        weights[0] = new SkinWeights(count - 1, 0, 0, 0, Vector4.UnitX);
        GlbFile file = GlbFile.Of(SampleCreature.With(creature, weights: weights));
        Assert.Equal(componentType, file.Accessor(file.Attribute("JOINTS_0")).GetProperty("componentType").GetInt32());
        Assert.Equal(count - 1, file.Numbers(file.Attribute("JOINTS_0"))[0]);
    }

    [Theory]
    [MemberData(nameof(Numbers))]
    public void Attachment_points_are_where_they_were_and_stand_upright_on_the_skin(int number)
    {
        Creature creature = SampleCreature.Build(SampleShape.Of(number));
        Vector3[] normals = [Vector3.UnitY, -Vector3.UnitY, Vector3.UnitX, -Vector3.UnitX, Vector3.UnitZ, -Vector3.UnitZ, Vector3.Normalize(new Vector3(1, -2, 3)), Vector3.Normalize(new Vector3(1e-4f, -1, 0))];
        creature = creature with { AttachmentPoints = creature.AttachmentPoints.Select((p, i) => p with { Normal = normals[i % normals.Length] }).ToArray() };
        GlbFile file = GlbFile.Of(creature);
        double[][] worlds = file.WorldMatrices();
        for (int i = 0; i < creature.AttachmentPoints.Count; i++)
        {
            AttachmentPoint point = creature.AttachmentPoints[i];
            int index = 1 + creature.Skeleton.Joints.Count + i;
            JsonElement node = file.Json.GetProperty("nodes")[index];
            double[] world = worlds[index];
            Assert.Equal(point.Name, node.GetProperty("name").GetString());
            Assert.False(node.TryGetProperty("children", out _));
            AssertNear(point.Position, world[12..15]);
            AssertNear(point.Normal, world[4..7]);
            if (point.Normal is { Z: 0f, Y: > -0.5f })
            {
                AssertNear(Vector3.UnitZ, world[8..11]);
            }

            JsonElement socket = node.GetProperty("extras").GetProperty("socket");
            AssertNear(point.Normal, GlbFile.Array(socket, "normal")!);
            Assert.Equal(point.Width, socket.GetProperty("width").GetSingle());
        }
    }

    private static void AssertNear(Vector3 expected, double[] actual)
    {
        Assert.Equal(expected.X, actual[0], 2e-6);
        Assert.Equal(expected.Y, actual[1], 2e-6);
        Assert.Equal(expected.Z, actual[2], 2e-6);
    }
}
