using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Creatures;

public sealed class TexturedMeshTests
{
    /// <summary>Seen from the front, u to the left of the creature (+X) and v down: the picture's top is up.</summary>
    [Fact]
    public void The_tangent_of_a_flat_square_is_where_u_grows_and_the_third_axis_is_where_v_shrinks()
    {
        CreatureMesh mesh = Mesh(
            [new(0, 1, 0), new(0, 0, 0), new(1, 0, 0), new(1, 1, 0)],
            [new(0.5f, 0.5f), new(0.5f, 0.6f), new(0.6f, 0.6f), new(0.6f, 0.5f)],
            [0, 1, 2, 0, 2, 3]).Textured();
        Assert.Equal(4, mesh.Positions.Length);
        foreach (Vector4 t in mesh.Tangents)
        {
            Assert.Equal(new Vector4(1, 0, 0, 1), t);
            Assert.Equal(Vector3.UnitY, t.W * Vector3.Cross(Vector3.UnitZ, new Vector3(t.X, t.Y, t.Z)));
        }
    }

    /// <summary>One triangle has u to the left, one of three times the area has u upwards.</summary>
    [Fact]
    public void Large_triangles_count_for_more()
    {
        CreatureMesh mesh = Mesh(
            [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(-3, 0, 0)],
            [new(0.5f, 0.5f), new(0.6f, 0.5f), new(0.5f, 0.4f), new(0.5f, 0.4f)],
            [0, 1, 2]);
        CreatureMesh both = Mesh(
            [new(0, 0, 0), new(1, 0, 0), new(0, 1, 0), new(0, 3, 0), new(-1, 0, 0)],
            [new(0.5f, 0.5f), new(0.6f, 0.5f), new(0.5f, 0.4f), new(0.6f, 0.5f), new(0.5f, 0.4f)],
            [0, 1, 2, 0, 3, 4]).Textured();
        Assert.Equal(new Vector4(1, 0, 0, 1), mesh.Textured().Tangents[0]);
        Vector4 shared = both.Tangents[0];
        Vector3 expected = Vector3.Normalize(new Vector3(1, 3, 0));
        Assert.Equal(expected.X, shared.X, 1e-6f);
        Assert.Equal(expected.Y, shared.Y, 1e-6f);
    }

    [Fact]
    public void A_vertex_where_the_texture_turns_over_becomes_two_with_opposite_sides()
    {
        CreatureMesh mesh = Mesh(
            [new(0, 0, 0), new(0, 1, 0), new(1, 0, 0), new(-1, 0, 0)],
            [new(0.5f, 0.5f), new(0.5f, 0.4f), new(0.6f, 0.5f), new(0.6f, 0.5f)],
            [0, 2, 1, 0, 1, 3]).Textured();
        Assert.Equal(6, mesh.Positions.Length);
        Assert.Equal(mesh.Positions[0], mesh.Positions[mesh.Triangles[3]]);
        Vector4 left = mesh.Tangents[mesh.Triangles[0]];
        Vector4 right = mesh.Tangents[mesh.Triangles[3]];
        Assert.Equal(new Vector4(1, 0, 0, 1), left);
        Assert.Equal(new Vector4(-1, 0, 0, -1), right);
    }

    [Fact]
    public void The_vertices_of_the_mesh_come_first_in_their_order()
    {
        CreatureMesh mesh = CreatureGenerator.Generate(22).Mesh;
        CreatureMesh textured = mesh.Textured();
        Assert.True(textured.Positions.Length > mesh.Positions.Length);
        Assert.True(textured.Positions[..mesh.Positions.Length].SequenceEqual(mesh.Positions));
        Assert.Equal(textured.Positions.Length, textured.Tangents.Length);
        Assert.True(mesh.Tangents.IsEmpty);
    }

    private static CreatureMesh Mesh(Vector3[] positions, Vector2[] texcoords, int[] triangles)
    {
        var normals = new Vector3[positions.Length];
        var colours = new Vector3[positions.Length];
        var weights = new SkinWeights[positions.Length];
        Array.Fill(normals, Vector3.UnitZ);
        Array.Fill(colours, Vector3.One);
        Array.Fill(weights, new SkinWeights(0, 0, 0, 0, Vector4.UnitX));
        return new CreatureMesh(positions, normals, texcoords, colours, weights, triangles, [new MeshPart(MaterialKind.Skin, 0, triangles.Length)]);
    }
}
