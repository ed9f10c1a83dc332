using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Threading.Tasks;
using CreatureGen.Creatures;
using CreatureGen.Tests.Engines;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>The add-on for Godot 4 compiles and runs, on stand-ins for the few types of Godot that it uses; what it hands to Godot is given to Godot itself (<see cref="GodotEngine"/>), which is a Godot 3.</summary>
public sealed class GodotAddonTests
{
    private const string Checks = """
        using System;
        using System.Collections.Generic;
        using System.Linq;
        using System.Reflection;
        using System.Text.Json;
        using CreatureGen;
        using CreatureGen.Creatures;
        using CreatureGen.Geometry;
        using CreatureGen.GodotAddon;
        using CreatureGen.Skinning;
        using Godot;

        public static class Check
        {
            private static readonly BindingFlags Own = BindingFlags.NonPublic | BindingFlags.Instance;

            private static CreatureNode Walking(ulong seed)
            {
                var node = new CreatureNode { Seed = seed, GlobalPosition = new Vector3(3f, 0f, -2f), TextureSize = 256 };
                node._Ready();
                for (int frame = 0; frame < 120; frame++)
                {
                    node._PhysicsProcess(1.0 / 60.0);
                }

                return node;
            }

            private static Skeleton3D Bones(CreatureNode node) => (Skeleton3D)typeof(CreatureNode).GetField("skeleton", Own).GetValue(node);

            // Where the library has each vertex.
            private static System.Numerics.Vector3[] Expected(CreatureNode node)
            {
                CreatureMesh source = node.Creature.Mesh.Textured();
                var matrices = new System.Numerics.Matrix4x4[node.Creature.Skeleton.Count];
                SkinMatrices.Fill(node.Creature.Skeleton, node.Animator.ModelPose, matrices);
                var positions = new System.Numerics.Vector3[source.Positions.Length];
                var normals = new System.Numerics.Vector3[source.Positions.Length];
                CpuSkinning.Skin(matrices, source.Weights, source.Positions, source.Normals, positions, normals);
                return positions;
            }

            // How far any vertex that Godot would draw is from where the library has it, and how far the creature went.
            public static float[] Walk(ulong seed)
            {
                CreatureNode node = Walking(seed);
                System.Numerics.Vector3[] expected = Expected(node);
                Skeleton3D skeleton = Bones(node);
                Skin skin = CreatureMeshes.Binds(node.Creature);
                Godot.Collections.Array arrays = CreatureMeshes.Surface(node.Creature).Arrays;
                var vertices = (Vector3[])arrays[(int)Mesh.ArrayType.Vertex].Value;
                var bones = (int[])arrays[(int)Mesh.ArrayType.Bones].Value;
                var weights = (float[])arrays[(int)Mesh.ArrayType.Weights].Value;
                float worst = 0f;
                for (int i = 0; i < vertices.Length; i += 13)
                {
                    Vector3 drawn = default;
                    for (int k = 0; k < 4; k++)
                    {
                        int bone = bones[(4 * i) + k];
                        drawn += (skeleton.GetBoneGlobalPose(bone) * (skin.Binds[bone] * vertices[i])) * weights[(4 * i) + k];
                    }

                    worst = Math.Max(worst, (GodotSpace.Point(drawn) - expected[i]).Length());
                }

                System.Numerics.Vector3 way = GodotSpace.Point(node.GlobalPosition) - new System.Numerics.Vector3(3f, 0f, -2f);
                return new[] { worst, way.Length() };
            }

            // All that the add-on hands to Godot, and where it is to draw each vertex.
            public static string Given(ulong seed)
            {
                CreatureNode node = Walking(seed);
                Skeleton3D skeleton = Bones(node);
                Godot.Collections.Array arrays = CreatureMeshes.Surface(node.Creature).Arrays;
                return JsonSerializer.Serialize(new
                {
                    vertices = Numbers((Vector3[])arrays[(int)Mesh.ArrayType.Vertex].Value),
                    normals = Numbers((Vector3[])arrays[(int)Mesh.ArrayType.Normal].Value),
                    texcoords = ((Vector2[])arrays[(int)Mesh.ArrayType.TexUV].Value).SelectMany(v => new[] { v.X, v.Y }),
                    colours = ((Color[])arrays[(int)Mesh.ArrayType.Color].Value).SelectMany(c => new[] { c.R, c.G, c.B }),
                    bones = (int[])arrays[(int)Mesh.ArrayType.Bones].Value,
                    weights = (float[])arrays[(int)Mesh.ArrayType.Weights].Value,
                    indices = (int[])arrays[(int)Mesh.ArrayType.Index].Value,
                    names = skeleton.Names,
                    parents = skeleton.Parents,
                    rests = skeleton.Rests.SelectMany(Numbers),
                    binds = CreatureMeshes.Binds(node.Creature).Binds.SelectMany(Numbers),
                    poses = skeleton.Names.SelectMany((_, bone) => Numbers(skeleton.GetBonePose(bone))),
                    expected = Expected(node).SelectMany(v => new[] { v.X, v.Y, v.Z }),
                });
            }

            private static IEnumerable<float> Numbers(Vector3[] all) => all.SelectMany(v => new[] { v.X, v.Y, v.Z });

            private static IEnumerable<float> Numbers(Transform3D t) => Numbers(new[] { t.Basis.X, t.Basis.Y, t.Basis.Z, t.Origin });
        }
        """;

    private static readonly Lazy<Assembly> sample = new(() => EngineSamples.Compile("samples/Godot", LanguageVersion.Latest, Checks));

    [Theory]
    [InlineData(101)]
    [InlineData(42)]
    public void Godot_draws_each_vertex_where_the_library_has_it(ulong seed)
    {
        float[] found = sample.Value.Call<float[]>("Walk", seed);
        Assert.InRange(found[0], 0f, 1e-3f);
        Assert.True(found[1] > 0.1f);
    }

    /// <summary>Godot 3 is given, by a script that goes the add-on's way, all that the add-on gives to Godot 4. It keeps weights in 16 bits, colours in 8, texture coordinates as halves.</summary>
    [Theory]
    [InlineData(101)]
    [InlineData(42)]
    public async Task Godot_itself_has_each_vertex_where_the_library_has_it(ulong seed)
    {
        Dictionary<string, double[]> found = await GodotEngine.RunAsync("tests/CreatureGen.Tests/SampleProjects/godot-addon.gd", sample.Value.Call<string>("Given", seed));
        CreatureMesh mesh = CreatureGenerator.Generate(seed).Mesh.Textured();
        float size = mesh.Positions.ToArray().Max(position => position.Length());
        Assert.Equal([mesh.Positions.Length, mesh.Triangles.Length], found["count"].Select(number => (int)number));
        Assert.InRange(found["rest"][0], 0.0, 2e-4 * size);
        Assert.InRange(found["drawn"][0], 0.0, 2e-4 * size);
        Assert.InRange(found["colour"][0], 0.0, 1.001 / 255);
        Assert.InRange(found["texel"][0], 0.0, 1.0 / 2048);
        Assert.True(found["volume"][0] > 0.0);
    }
}
