using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbRefusalTests
{
    private static readonly Creature Sample = SampleCreature.Build(SampleShape.Of(5));

    private static readonly Dictionary<string, (Creature Creature, string Message)> Defects = new()
    {
        ["position NaN"] = (Positions(7, new Vector3(float.NaN, 0, 1)), "vertex 7: its position is (NaN, 0, 1); expected finite numbers"),
        ["position infinite"] = (Positions(0, new Vector3(0, float.PositiveInfinity, 1)), "vertex 0: its position is (0, Infinity, 1)"),
        ["normal zero"] = (Normals(3, Vector3.Zero), "vertex 3: its normal is (0, 0, 0); expected a unit vector"),
        ["normal NaN"] = (Normals(3, new Vector3(float.NaN, 0, 0)), "vertex 3: its normal is (NaN, 0, 0)"),
        ["normal too long"] = (Normals(4, new Vector3(0, 1.001f, 0)), "vertex 4: its normal"),
        ["texture coordinates NaN"] = (Texcoords(5, new Vector2(0, float.NaN)), "vertex 5: its texture coordinates are (0, NaN)"),
        ["colour above one"] = (Colours(6, new Vector3(0, 1.0001f, 0)), "vertex 6: its colour is (0, 1.0001, 0); expected components of 0..1"),
        ["colour negative"] = (Colours(6, new Vector3(-0.1f, 0, 0)), "vertex 6: its colour"),
        ["colour NaN"] = (Colours(6, new Vector3(0, 0, float.NaN)), "vertex 6: its colour"),
        ["weights too small"] = (Weights(2, new SkinWeights(1, 2, 0, 0, new Vector4(0.5f, 0.49f, 0, 0))), "vertex 2: its weights are (0.5, 0.49, 0, 0); expected none negative, in descending order, with a sum of one"),
        ["weights negative"] = (Weights(2, new SkinWeights(1, 2, 0, 0, new Vector4(1.5f, -0.5f, 0, 0))), "vertex 2: its weights"),
        ["weights NaN"] = (Weights(2, new SkinWeights(1, 2, 0, 0, new Vector4(float.NaN, 0.5f, 0, 0))), "vertex 2: its weights"),
        ["weights not in order"] = (Weights(2, new SkinWeights(1, 2, 0, 0, new Vector4(0.25f, 0.75f, 0, 0))), "vertex 2: its weights"),
        ["weights all zero"] = (Weights(2, new SkinWeights(0, 0, 0, 0, Vector4.Zero)), "vertex 2: its weights"),
        ["joint twice"] = (Weights(2, new SkinWeights(1, 1, 0, 0, new Vector4(0.5f, 0.5f, 0, 0))), "vertex 2: its joints are 1, 1, 0 and 0"),
        ["joint unknown"] = (Weights(2, new SkinWeights(999, 0, 0, 0, Vector4.UnitX)), "vertex 2: its joints are 999"),
        ["joint negative"] = (Weights(2, new SkinWeights(-1, 0, 0, 0, Vector4.UnitX)), "vertex 2: its joints are -1"),
        ["joint without weight"] = (Weights(2, new SkinWeights(1, 2, 0, 0, Vector4.UnitX)), "vertex 2: its joints are 1, 2, 0 and 0"),
        ["triangle without a third vertex"] = (RepeatedCorner(5), "triangle 1: its corners are the vertices"),
        ["no triangle"] = (Sample with { Mesh = new CreatureMesh([], [], [], [], [], [], []) }, "the mesh: it has no triangle"),
        ["joint named as the mesh"] = (Joints(2, j => j with { Name = "Creature" }), "joint Creature: another node has the same name"),
        ["socket named as a joint"] = (Sockets(p => p with { Name = "Body" }), "attachment point Body: another node has the same name"),
        ["socket without a name"] = (Sockets(p => p with { Name = string.Empty }), "attachment point : it has no name"),
        ["socket with a blank"] = (Sockets(p => p with { Name = "on top" }), "attachment point on top: its name has other characters than importers keep"),
        ["socket on no joint"] = (Sockets(p => p with { Joint = 99 }), "it refers to joint 99; expected 0.."),
        ["socket at NaN"] = (Sockets(p => p with { Position = new Vector3(float.NaN) }), "position: it is (NaN, NaN, NaN)"),
        ["socket without direction"] = (Sockets(p => p with { Normal = Vector3.Zero }), "its normal is (0, 0, 0)"),
        ["socket without width"] = (Sockets(p => p with { Width = 0f }), "width: it is 0; expected a finite positive number"),
        ["limb of unknown joints"] = (Sample with { Limbs = [Sample.Limbs[0] with { Joints = [1, 77] }] }, "limb 0: it refers to joint 77"),
        ["limb of no kind"] = (Sample with { Limbs = [Sample.Limbs[0] with { Kind = (LimbKind)99 }] }, "limb 0: its kind is 99 and its side 1"),
        ["limb with pole NaN"] = (Sample with { Limbs = [Sample.Limbs[0] with { Pole = new Vector3(float.NaN) }] }, "limb 0, pole"),
        ["capsule of no size"] = (Sample with { Body = Sample.Body with { Radius = float.NaN } }, "the body's capsule, radius: it is NaN"),
        ["capsule on no joint"] = (Sample with { Bones = [Sample.Bones[0] with { Joint = -1 }] }, "capsule 0: it refers to joint -1"),
        ["no mass"] = (Sample with { Mass = Sample.Mass with { Mass = 0f } }, "the mass: it is 0"),
        ["inertia infinite"] = (Sample with { Mass = Sample.Mass with { InertiaDiagonal = new Vector3(float.NegativeInfinity) } }, "the moments of inertia"),
        ["height NaN"] = (Sample with { StandingHeight = float.NaN }, "the standing height: it is NaN"),
        ["speed negative"] = (Sample with { DefaultSpeed = -1f }, "the default speed: it is -1"),
    };

    public static TheoryData<string> Names => new(Defects.Keys);

    [Theory]
    [MemberData(nameof(Names))]
    public void A_defect_is_named_with_its_place_and_nothing_is_written(string name)
    {
        (Creature creature, string message) = Defects[name];
        using var stream = new MemoryStream();
        var error = Assert.Throws<InvalidOperationException>(() => GlbWriter.Write(creature, GltfOptions.Default, stream));
        Assert.StartsWith("the creature cannot be written: ", error.Message, StringComparison.Ordinal);
        Assert.Contains(message, error.Message, StringComparison.Ordinal);
        Assert.Contains("; expected ", error.Message, StringComparison.Ordinal);
        Assert.Equal(0, stream.Length);
    }

    [Fact]
    public void Arguments_are_checked()
    {
        using var stream = new MemoryStream();
        Assert.Throws<ArgumentNullException>("creature", () => GlbWriter.Write(null!, GltfOptions.Default, stream));
        Assert.Throws<ArgumentNullException>("options", () => GlbWriter.Write(Sample, null!, stream));
        Assert.Throws<ArgumentNullException>("destination", () => GlbWriter.Write(Sample, GltfOptions.Default, null!));
        Assert.Throws<ArgumentException>("destination", () => GlbWriter.Write(Sample, GltfOptions.Default, new MemoryStream(new byte[4], writable: false)));
        Assert.Throws<ArgumentException>("options", () => GlbWriter.Write(Sample, new GltfOptions { Shading = (Shading)7 }, stream));
    }

    [Fact]
    public void The_stream_stays_open_and_is_written_from_where_it_stands()
    {
        using var stream = new MemoryStream();
        stream.WriteByte(42);
        GlbWriter.Write(Sample, GltfOptions.Default, stream);
        Assert.True(stream.CanWrite);
        Assert.Equal(42, stream.ToArray()[0]);
        Assert.Equal(GlbFile.Write(Sample), stream.ToArray()[1..]);
    }

    private static Creature Positions(int vertex, Vector3 value) => SampleCreature.With(Sample, positions: Set(Sample.Mesh.Positions, vertex, value));

    private static Creature Normals(int vertex, Vector3 value) => SampleCreature.With(Sample, normals: Set(Sample.Mesh.Normals, vertex, value));

    private static Creature Texcoords(int vertex, Vector2 value) => SampleCreature.With(Sample, texcoords: Set(Sample.Mesh.Texcoords, vertex, value));

    private static Creature Colours(int vertex, Vector3 value) => SampleCreature.With(Sample, colours: Set(Sample.Mesh.Colours, vertex, value));

    private static Creature Weights(int vertex, SkinWeights value) => SampleCreature.With(Sample, weights: Set(Sample.Mesh.Weights, vertex, value));

    /// <summary>A triangle corner that repeats the one before it.</summary>
    private static Creature RepeatedCorner(int corner)
    {
        int[] corners = Sample.Mesh.Triangles.ToArray();
        return SampleCreature.With(Sample, triangles: Set<int>(corners, corner, corners[corner - 1]));
    }

    private static Creature Joints(int index, Func<Joint, Joint> change) =>
        Sample with { Skeleton = new Skeleton(Sample.Skeleton.Joints.Select((j, i) => i == index ? change(j) : j).ToArray()) };

    private static Creature Sockets(Func<AttachmentPoint, AttachmentPoint> change) =>
        Sample with { AttachmentPoints = Sample.AttachmentPoints.Select((p, i) => i == 1 ? change(p) : p).ToArray() };

    private static T[] Set<T>(ReadOnlySpan<T> items, int index, T value)
    {
        T[] copy = items.ToArray();
        copy[index] = value;
        return copy;
    }
}
