using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Text.Json;
using System.Threading.Tasks;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Engines;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Engines;

/// <summary>The buffers for Godot, judged by Godot (<see cref="GodotEngine"/>).</summary>
public sealed class GodotTests
{
    /// <summary>Front faces: the normals that Godot makes from the order of corners are the library's. Tangents: those that it makes from texture coordinates (MikkTSpace) run along the library's and have the same side.</summary>
    [Theory]
    [InlineData(RequestedKind.Walking, 22)]
    [InlineData(RequestedKind.Flying, 2)]
    [InlineData(RequestedKind.Swimming, 3)]
    public async Task Godot_sees_the_creature_from_outside_with_its_tangents_and_its_bones(RequestedKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        Dictionary<string, double[]> found = await GodotEngine.RunAsync("tests/CreatureGen.Tests/Engines/godot.gd", Buffers(creature, EngineAxes.Godot));
        Assert.True(found["normals"][0] > 0.95 * found["normals"][1], $"{found["normals"][0]} of {found["normals"][1]} corners look outwards");
        Assert.True(found["tangents"][0] > 0.95 * found["tangents"][2], $"{found["tangents"][0]} of {found["tangents"][2]} tangents run along Godot's");
        Assert.True(found["tangents"][1] > 0.99 * found["tangents"][2], $"{found["tangents"][1]} of {found["tangents"][2]} tangents have Godot's side");
        Assert.True(found["rest"][0] < 1e-5, $"bind matrices move the rest pose by {found["rest"][0]}");
    }

    /// <summary>The measure sees a defect: with corners as other engines want them, the creature is inside out.</summary>
    [Fact]
    public async Task Godot_sees_counter_clockwise_triangles_inside_out()
    {
        Creature creature = CreatureGenerator.Generate(22);
        Dictionary<string, double[]> found = await GodotEngine.RunAsync("tests/CreatureGen.Tests/Engines/godot.gd", Buffers(creature, EngineAxes.ThreeJs));
        Assert.True(found["normals"][0] < 0.05 * found["normals"][1]);
    }

    private static string Buffers(Creature creature, EngineAxes axes)
    {
        EngineMesh mesh = creature.Mesh.Textured().For(axes);
        EngineSkeleton skeleton = creature.Skeleton.For(axes);
        var positions = new Vector3[mesh.VertexCount];
        var normals = new Vector3[mesh.VertexCount];
        var tangents = new Vector4[mesh.VertexCount];
        var texcoords = new Vector2[mesh.VertexCount];
        byte[] joints = new byte[4 * mesh.VertexCount];
        byte[] weights = new byte[4 * mesh.VertexCount];
        int[] indices = new int[mesh.IndexCount];
        mesh.FillPositions(positions);
        mesh.FillNormals(normals);
        mesh.FillTangents(tangents);
        mesh.FillTexcoords(texcoords);
        mesh.FillInfluences(joints, weights);
        mesh.FillIndices(indices);
        var rotations = new Quaternion[skeleton.Count];
        var places = new Vector3[skeleton.Count];
        var binds = new Matrix4x4[skeleton.Count];
        skeleton.FillRestPose(new Pose(rotations, places));
        skeleton.FillInverseBinds(binds);
        return JsonSerializer.Serialize(new
        {
            positions = Numbers(positions),
            normals = Numbers(normals),
            tangents = Numbers(tangents),
            texcoords = Numbers(texcoords),
            joints = joints.Select(j => (int)j),
            weights = weights.Select(w => w / 255f),
            indices,
            names = creature.Skeleton.Joints.Select(j => j.Name),
            parents = creature.Skeleton.Parents.ToArray(),
            rotations = Numbers(rotations),
            places = Numbers(places),
            binds = Numbers(binds),
        });
    }

    private static float[] Numbers<T>(T[] values)
        where T : struct => MemoryMarshal.Cast<T, float>(values).ToArray();
}
