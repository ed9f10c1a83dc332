using System;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Engines;
using CreatureGen.Geometry;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Tests.Motion;
using Xunit;

namespace CreatureGen.Tests.Engines;

public sealed class EngineMeshTests
{
    private static readonly Creature creature = CreatureGenerator.Generate(4);

    public static TheoryData<string> Engines => [.. EngineAxes.All.Select(e => e.Name)];

    /// <summary>The volume that an engine works out of positions and corners, as its own front faces see it, is that of the library.</summary>
    [Theory]
    [MemberData(nameof(Engines))]
    public void Front_faces_look_outwards(string name)
    {
        EngineAxes axes = EngineAxes.All.Single(e => e.Name == name);
        EngineMesh mesh = creature.Mesh.For(axes);
        var positions = new Vector3[mesh.VertexCount];
        int[] corners = new int[mesh.IndexCount];
        mesh.FillPositions(positions);
        mesh.FillIndices(corners);

        // The product of three edges is positive where they are seen against the clock in a right-handed engine.
        double seen = (axes.IsLeftHanded ? -1 : 1) * (axes.FrontFace == FrontFace.Clockwise ? -1 : 1);
        MeshPart skin = mesh.Parts[0];
        double volume = 0;
        for (int t = skin.FirstIndex; t < skin.FirstIndex + skin.IndexCount; t += 3)
        {
            volume += seen * Vector3.Dot(positions[corners[t]], Vector3.Cross(positions[corners[t + 1]], positions[corners[t + 2]])) / 6;
        }

        Assert.Equal(creature.Mass.Volume, volume / Math.Pow(axes.UnitsPerMetre, 3), 0.02 * creature.Mass.Volume);
    }

    /// <summary>Skinning with the engine's numbers alone gives the library's skinned vertices.</summary>
    [Theory]
    [MemberData(nameof(Engines))]
    public void Rest_pose_bind_matrices_and_weights_belong_together(string name)
    {
        EngineAxes axes = EngineAxes.All.Single(e => e.Name == name);
        EngineSkeleton skeleton = creature.Skeleton.For(axes);
        var rotations = new Quaternion[skeleton.Count];
        var places = new Vector3[skeleton.Count];
        skeleton.FillRestPose(new Pose(rotations, places));
        var binds = new Matrix4x4[skeleton.Count];
        skeleton.FillInverseBinds(binds);
        var world = new Matrix4x4[skeleton.Count];
        for (int i = 0; i < world.Length; i++)
        {
            Matrix4x4 local = Matrix4x4.CreateFromQuaternion(rotations[i]);
            local.Translation = places[i];
            int parent = creature.Skeleton.Parents[i];
            world[i] = parent < 0 ? local : local * world[parent];
            Matrix4x4 bind = axes.MatrixMemory == MatrixMemory.Transposed ? Matrix4x4.Transpose(binds[i]) : binds[i];
            Matrix4x4 rest = bind * world[i];
            Assert.True((rest.Translation / axes.UnitsPerMetre).Length() < 1e-5f, $"{creature.Skeleton.Joints[i].Name}: {rest}");
            Assert.Equal(1f, rest.M11, 1e-5f);
            Assert.Equal(1f, rest.M22, 1e-5f);
            Assert.Equal(1f, rest.M33, 1e-5f);
        }
    }

    [Fact]
    public void Packed_weights_sum_to_255_in_descending_order_and_miss_by_less_than_one_part()
    {
        EngineMesh mesh = creature.Mesh.For(EngineAxes.Godot);
        byte[] joints = new byte[4 * mesh.VertexCount];
        byte[] weights = new byte[4 * mesh.VertexCount];
        mesh.FillInfluences(joints, weights);
        for (int v = 0; v < mesh.VertexCount; v++)
        {
            SkinWeights s = creature.Mesh.Weights[v];
            byte[] w = weights[(4 * v)..((4 * v) + 4)];
            Assert.Equal(255, w.Sum(x => x));
            Assert.Equal(w.OrderDescending(), w);
            float[] exact = [s.Weights.X, s.Weights.Y, s.Weights.Z, s.Weights.W];
            int[] of = [s.Joint0, s.Joint1, s.Joint2, s.Joint3];
            for (int k = 0; k < 4; k++)
            {
                Assert.True(Math.Abs(w[k] - (255 * exact[k])) < 1f);
                Assert.Equal(w[k] == 0 ? 0 : of[k], joints[(4 * v) + k]);
            }
        }
    }

    [Theory]
    [InlineData(0.25f, 0.25f, 0.25f, 0.25f, 64, 64, 64, 63)]
    [InlineData(1f, 0f, 0f, 0f, 255, 0, 0, 0)]
    [InlineData(0.5f, 0.5f, 0f, 0f, 128, 127, 0, 0)]
    [InlineData(0.998f, 0.002f, 0f, 0f, 254, 1, 0, 0)]
    [InlineData(0.999f, 0.001f, 0f, 0f, 255, 0, 0, 0)]
    public void Weights_are_packed_to_the_nearest_parts(float x, float y, float z, float w, byte a, byte b, byte c, byte d)
    {
        byte[] weights = new byte[12];
        byte[] joints = new byte[12];
        Triangle(new SkinWeights(1, 2, 3, 4, new Vector4(x, y, z, w))).For(EngineAxes.Unity).FillInfluences(joints, weights);
        Assert.Equal([a, b, c, d], weights[..4]);
        Assert.Equal([1, b == 0 ? 0 : 2, c == 0 ? 0 : 3, d == 0 ? 0 : 4], joints[..4].Select(j => (int)j));
    }

    [Fact]
    public void Joints_beyond_a_byte_take_two()
    {
        EngineMesh mesh = Triangle(new SkinWeights(300, 2, 0, 0, new Vector4(0.75f, 0.25f, 0, 0))).For(EngineAxes.Unity);
        Assert.Contains("joint 300", Assert.Throws<ArgumentException>(() => mesh.FillInfluences(new byte[12], new byte[12])).Message, StringComparison.Ordinal);
        ushort[] joints = new ushort[12];
        var weights = new Vector4[3];
        mesh.FillInfluences(joints, weights);
        Assert.Equal([300, 2, 0, 0], joints[..4].Select(j => (int)j));
        Assert.Equal(new Vector4(0.75f, 0.25f, 0, 0), weights[2]);
    }

    [Fact]
    public void Tangents_are_those_of_the_textured_mesh()
    {
        Assert.Throws<InvalidOperationException>(() => creature.Mesh.For(EngineAxes.Unity).FillTangents(new Vector4[creature.Mesh.Positions.Length]));
        CreatureMesh textured = creature.Mesh.Textured();
        EngineMesh mesh = textured.For(EngineAxes.Unity);
        var tangents = new Vector4[mesh.VertexCount];
        var normals = new Vector3[mesh.VertexCount];
        mesh.FillTangents(tangents);
        mesh.FillNormals(normals);
        for (int v = 0; v < tangents.Length; v++)
        {
            Vector4 t = textured.Tangents[v];
            Assert.Equal(new Vector4(-t.X, t.Y, t.Z, -t.W), tangents[v]);
            Assert.Equal(0f, Vector3.Dot(normals[v], new Vector3(tangents[v].X, tangents[v].Y, tangents[v].Z)), 1e-5f);
        }
    }

    [Fact]
    public void Filling_allocates_nothing()
    {
        EngineMesh mesh = creature.Mesh.Textured().For(EngineAxes.Stride);
        EngineSkeleton skeleton = creature.Skeleton.For(EngineAxes.Stride);
        Assert.True(mesh.FitsShortIndices);
        var threes = new Vector3[mesh.VertexCount];
        var fours = new Vector4[mesh.VertexCount];
        var twos = new Vector2[mesh.VertexCount];
        byte[] joints = new byte[4 * mesh.VertexCount];
        byte[] weights = new byte[4 * mesh.VertexCount];
        ushort[] corners = new ushort[mesh.IndexCount];
        var binds = new Matrix4x4[skeleton.Count];
        void Fill()
        {
            mesh.FillPositions(threes);
            mesh.FillNormals(threes);
            mesh.FillTangents(fours);
            mesh.FillTexcoords(twos);
            mesh.FillColours(fours);
            mesh.FillInfluences(joints, weights);
            mesh.FillIndices(corners);
            skeleton.FillInverseBinds(binds);
        }

        Assert.Equal(0, MovingPose.Allocated(Fill));
    }

    [Fact]
    public void Spans_of_another_length_are_refused()
    {
        EngineMesh mesh = creature.Mesh.For(EngineAxes.Unity);
        Assert.Contains("vertices", Assert.Throws<ArgumentException>(() => mesh.FillPositions(new Vector3[3])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => mesh.FillInfluences(new byte[3], new byte[3]));
        Assert.Throws<ArgumentException>(() => mesh.FillIndices(new int[3]));
        Assert.Throws<ArgumentException>(() => creature.Skeleton.For(EngineAxes.Unity).FillInverseBinds(new Matrix4x4[1]));
    }

    private static CreatureMesh Triangle(SkinWeights weights) => new(
        [Vector3.Zero, Vector3.UnitX, Vector3.UnitY],
        [Vector3.UnitZ, Vector3.UnitZ, Vector3.UnitZ],
        [Vector2.Zero, Vector2.UnitX, Vector2.UnitY],
        [Vector3.One, Vector3.One, Vector3.One],
        [weights, weights, weights],
        [0, 1, 2],
        [new MeshPart(MaterialKind.Skin, 0, 3)]);
}
