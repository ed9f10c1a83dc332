using System;
using System.Reflection;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>The add-on for Godot 4 compiles and runs, on stand-ins for the few types of Godot that it uses. What Godot makes of such buffers is tested in Godot itself.</summary>
public sealed class GodotAddonTests
{
    private const string Checks = """
        using System;
        using System.Reflection;
        using CreatureGen;
        using CreatureGen.Creatures;
        using CreatureGen.Geometry;
        using CreatureGen.GodotAddon;
        using CreatureGen.Skinning;
        using Godot;

        public static class Check
        {
            // How far any vertex that Godot would draw is from where the library has it, and how far the creature went.
            public static float[] Walk(ulong seed)
            {
                var node = new CreatureNode { Seed = seed, GlobalPosition = new Vector3(3f, 0f, -2f), TextureSize = 256 };
                node._Ready();
                for (int frame = 0; frame < 120; frame++)
                {
                    node._PhysicsProcess(1.0 / 60.0);
                }

                Creature creature = node.Creature;
                CreatureMesh source = creature.Mesh.Textured();
                var matrices = new System.Numerics.Matrix4x4[creature.Skeleton.Count];
                SkinMatrices.Fill(creature.Skeleton, node.Animator.ModelPose, matrices);
                var skeleton = (Skeleton3D)typeof(CreatureNode).GetField("skeleton", BindingFlags.NonPublic | BindingFlags.Instance).GetValue(node);
                Skin skin = CreatureMeshes.Binds(creature);
                Godot.Collections.Array arrays = CreatureMeshes.Surface(creature).Arrays;
                var vertices = (Vector3[])arrays[(int)Mesh.ArrayType.Vertex].Value;
                var bones = (int[])arrays[(int)Mesh.ArrayType.Bones].Value;
                var weights = (float[])arrays[(int)Mesh.ArrayType.Weights].Value;
                float worst = 0f;
                for (int i = 0; i < vertices.Length; i += 13)
                {
                    System.Numerics.Vector3 expected = default;
                    Vector3 drawn = default;
                    SkinWeights s = source.Weights[i];
                    int[] joints = { s.Joint0, s.Joint1, s.Joint2, s.Joint3 };
                    float[] parts = { s.Weights.X, s.Weights.Y, s.Weights.Z, s.Weights.W };
                    for (int k = 0; k < 4; k++)
                    {
                        expected += System.Numerics.Vector3.Transform(source.Positions[i], matrices[joints[k]]) * parts[k];
                        int bone = bones[(4 * i) + k];
                        drawn += (skeleton.GetBoneGlobalPose(bone) * (skin.Binds[bone] * vertices[i])) * weights[(4 * i) + k];
                    }

                    System.Numerics.Vector3 off = GodotSpace.Point(drawn) - expected;
                    worst = Math.Max(worst, off.Length());
                }

                System.Numerics.Vector3 way = GodotSpace.Point(node.GlobalPosition) - new System.Numerics.Vector3(3f, 0f, -2f);
                return new[] { worst, way.Length() };
            }
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
}
