using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Runtime.InteropServices;
using CreatureGen.Engines;
using CreatureGen.Rigging;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Engines;

public sealed class EngineAxesTests
{
    private static readonly float half = MathF.Sqrt(0.5f);

    public static TheoryData<string> Engines => [.. EngineAxes.All.Select(e => e.Name)];

    [Theory]
    [MemberData(nameof(Engines))]
    public void Each_engine_is_as_worked_out_by_hand(string name)
    {
        EngineAxes axes = Named(name);
        Dictionary<string, float[]> expected = Reference(name);
        Same(expected["left"], axes.Point(new Vector3(1, 2, 3)));
        Same(expected["turn"], axes.Rotation(new Quaternion(0, half, 0, half)));
        Same(expected["nod"], axes.Rotation(new Quaternion(half, 0, 0, half)));
        Same(expected["matrix"], axes.Matrix(new Matrix4x4(0, 0, -1, 0, 0, 1, 0, 0, 1, 0, 0, 0, 1, 2, 3, 1)));
        Same(expected["tangent"], axes.Tangent(new Vector4(1, 0, 0, -1)));
        Same(expected["texel"], axes.Texcoord(new Vector2(0.25f, 0.1f)));
        int[] corners = new int[3];
        axes.Convert([0, 1, 2], corners);
        Assert.Equal(expected["corners"].Select(c => (int)c), corners);
        ushort[] shorts = new ushort[3];
        axes.Convert([0, 1, 2], shorts);
        Assert.Equal(corners, shorts.Select(s => (int)s));
    }

    [Theory]
    [MemberData(nameof(Engines))]
    public void Turning_and_converting_can_change_places(string name)
    {
        EngineAxes axes = Named(name);
        var random = new Random(7);
        for (int i = 0; i < 200; i++)
        {
            Quaternion q = Quaternion.Normalize(new Quaternion(Number(random), Number(random), Number(random), Number(random)));
            var p = new Vector3(Number(random), Number(random), Number(random));
            var o = new Vector3(Number(random), Number(random), Number(random));
            Vector3 expected = axes.Point(Vector3.Transform(p, q) + o);
            Assert.True(Vector3.Distance(expected, Vector3.Transform(axes.Point(p), axes.Rotation(q)) + axes.Point(o)) < 2e-6f * axes.UnitsPerMetre);
            Matrix4x4 m = Matrix4x4.CreateFromQuaternion(q);
            m.Translation = o;
            Matrix4x4 converted = axes.Matrix(m);
            Matrix4x4 byRows = axes.MatrixMemory == MatrixMemory.Transposed ? Matrix4x4.Transpose(converted) : converted;
            Assert.True(Vector3.Distance(expected, Vector3.Transform(axes.Point(p), byRows)) < 4e-6f * axes.UnitsPerMetre);
        }
    }

    /// <summary>The engine multiplies n × t by its own numbers; on the back, with the picture's top ahead, the third axis points ahead.</summary>
    [Theory]
    [MemberData(nameof(Engines))]
    public void The_third_axis_of_a_tangent_points_up_the_picture(string name)
    {
        EngineAxes axes = Named(name);
        Vector4 t = axes.Tangent(new Vector4(1, 0, 0, -1));
        Assert.Equal(axes.Ahead, t.W * Vector3.Cross(axes.Up, new Vector3(t.X, t.Y, t.Z)));
    }

    [Fact]
    public void Triangles_keep_their_first_corner()
    {
        int[] converted = new int[6];
        EngineAxes.Unity.Convert([5, 7, 9, 9, 7, 11], converted);
        Assert.Equal([5, 9, 7, 9, 11, 7], converted);
    }

    [Fact]
    public void Poses_are_converted_joint_by_joint_without_allocation()
    {
        Quaternion[] rotations = [new(0, half, 0, half), Quaternion.Identity];
        Vector3[] positions = [new(1, 2, 3), Vector3.UnitX];
        Quaternion[] turned = new Quaternion[2];
        Vector3[] moved = new Vector3[2];
        EngineAxes.Unreal.Convert(new Pose(rotations, positions), new Pose(turned, moved));
        Assert.Equal(new Vector3(300, -100, 200), moved[0]);
        Assert.Equal(new Vector3(0, -100, 0), moved[1]);
        Assert.Equal(new Quaternion(0, 0, -half, half), turned[0]);
        long before = GC.GetAllocatedBytesForCurrentThread();
        EngineAxes.Unreal.Convert(new Pose(rotations, positions), new Pose(turned, moved));
        Assert.Equal(before, GC.GetAllocatedBytesForCurrentThread());
    }

    [Fact]
    public void An_engine_of_ones_own_needs_three_axes()
    {
        Assert.Contains("ahead", Assert.Throws<ArgumentException>(() => new EngineAxes("own", Vector3.UnitX, Vector3.UnitY, -Vector3.UnitX)).Message, StringComparison.Ordinal);
        Assert.Contains("left = (0.6, 0.8, 0)", Assert.Throws<ArgumentException>(() => new EngineAxes("own", new Vector3(0.6f, 0.8f, 0), Vector3.UnitY, Vector3.UnitZ)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => new EngineAxes("own", Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ, 0f));
        Assert.True(new EngineAxes("own", Vector3.UnitX, Vector3.UnitZ, Vector3.UnitY).IsLeftHanded);
    }

    [Fact]
    public void What_does_not_fit_is_refused()
    {
        Assert.Contains("vertex 65536", Assert.Throws<ArgumentException>(() => EngineAxes.Unity.Convert([0, 1, 65536], new ushort[3])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => EngineAxes.Unity.Convert([0, 1, 2], new int[2]));
        Assert.Throws<ArgumentException>(() => EngineAxes.Unity.Convert([0, 1], new int[2]));
    }

    [Fact]
    public void The_table_of_engines_in_the_docs_is_made_of_the_code()
    {
        string page = RepositoryFiles.Text("docs/using-it.md").ReplaceLineEndings("\n");
        string table = EngineTable.Markdown();
        Assert.True(page.Contains(table, StringComparison.Ordinal), "docs/using-it.md does not have this table:\n" + table);
    }

    private static EngineAxes Named(string name) => EngineAxes.All.Single(e => e.Name == name);

    private static float Number(Random random) => (random.NextSingle() * 2f) - 1f;

    private static void Same<T>(float[] expected, T actual)
        where T : struct
    {
        float[] numbers = MemoryMarshal.Cast<T, float>(new[] { actual }).ToArray();
        Assert.Equal(expected.Length, numbers.Length);
        Assert.All(expected.Zip(numbers), p => Assert.Equal(p.First, p.Second, 1e-6f));
    }

    private static Dictionary<string, float[]> Reference(string engine) => RepositoryFiles.Text("tests/CreatureGen.Tests/Engines/engines.txt").Split('\n')
        .Select(l => l.Split(' ', StringSplitOptions.RemoveEmptyEntries | StringSplitOptions.TrimEntries))
        .Where(w => w.Length > 2 && w[0] == engine)
        .ToDictionary(w => w[1], w => w.Skip(2).Select(n => float.Parse(n, CultureInfo.InvariantCulture)).ToArray());
}
