using System;
using System.IO;
using System.Linq;
using System.Reflection;
using System.Text.Json;
using System.Text.RegularExpressions;
using CreatureGen.Tests.Conventions;
using Microsoft.CodeAnalysis.CSharp;
using Xunit;

namespace CreatureGen.Tests.SampleProjects;

/// <summary>The package for Unity: it compiles as C# 9 and runs, on stand-ins for the few types of Unity that it uses.</summary>
public sealed class UnityTests
{
    private const string Package = "samples/Unity/com.creaturegen";

    private const string Checks = """
        using System;
        using System.Linq;
        using System.Reflection;
        using CreatureGen;
        using CreatureGen.Creatures;
        using CreatureGen.Geometry;
        using CreatureGen.Meadow;
        using CreatureGen.Motion;
        using CreatureGen.Skinning;
        using CreatureGen.Unity;
        using UnityEngine;

        public static class Check
        {
            private const BindingFlags Own = BindingFlags.NonPublic | BindingFlags.Instance;

            public static CreatureBehaviour Walking(ulong seed)
            {
                var behaviour = new GameObject("creature").AddComponent<CreatureBehaviour>();
                behaviour.transform.SetPositionAndRotation(new Vector3(3f, 0f, -2f), new Quaternion(0f, 0.6f, 0f, 0.8f));
                behaviour.Show(CreatureGenerator.Generate(seed));
                behaviour.Input = new MotionInput(behaviour.Creature.DefaultSpeed, 0.3f);
                Call(behaviour, "Start");
                for (int frame = 0; frame < 120; frame++)
                {
                    Call(behaviour, "Update");
                }

                return behaviour;
            }

            // How far any vertex that Unity would draw is from where the library has it, in Unity's space.
            public static float WorstVertex(ulong seed)
            {
                CreatureBehaviour behaviour = Walking(seed);
                Creature creature = behaviour.Creature;
                CreatureMesh source = creature.Mesh.Textured();
                var matrices = new System.Numerics.Matrix4x4[creature.Skeleton.Count];
                SkinMatrices.Fill(creature.Skeleton, behaviour.Animator.ModelPose, matrices);
                Transform[] bones = (Transform[])typeof(CreatureBehaviour).GetField("bones", Own).GetValue(behaviour);
                Mesh mesh = CreatureMeshes.Skinned(creature);
                float worst = 0f;
                for (int i = 0; i < mesh.vertices.Length; i += 7)
                {
                    SkinWeights s = source.Weights[i];
                    System.Numerics.Vector3 p = source.Positions[i];
                    System.Numerics.Vector3 model = (System.Numerics.Vector3.Transform(p, matrices[s.Joint0]) * s.Weights.X) + (System.Numerics.Vector3.Transform(p, matrices[s.Joint1]) * s.Weights.Y)
                        + (System.Numerics.Vector3.Transform(p, matrices[s.Joint2]) * s.Weights.Z) + (System.Numerics.Vector3.Transform(p, matrices[s.Joint3]) * s.Weights.W);
                    Vector3 expected = UnitySpace.Point(behaviour.Animator.Root.ToWorld(model));
                    BoneWeight w = mesh.boneWeights[i];
                    Vector3 drawn = (Skin(bones, mesh, w.boneIndex0, i) * w.weight0) + (Skin(bones, mesh, w.boneIndex1, i) * w.weight1) + (Skin(bones, mesh, w.boneIndex2, i) * w.weight2) + (Skin(bones, mesh, w.boneIndex3, i) * w.weight3);
                    worst = Math.Max(worst, Math.Max(Math.Abs(drawn.x - expected.x), Math.Max(Math.Abs(drawn.y - expected.y), Math.Abs(drawn.z - expected.z))));
                }

                return worst;
            }

            public static float Way(ulong seed)
            {
                Vector3 p = Walking(seed).transform.position;
                return (float)Math.Sqrt(((p.x - 3f) * (p.x - 3f)) + ((p.z + 2f) * (p.z + 2f)));
            }

            public static bool IsComplete(ulong seed)
            {
                Mesh mesh = CreatureMeshes.Skinned(CreatureGenerator.Generate(seed));
                int[] all = mesh.Triangles.Values.SelectMany(part => part).ToArray();
                return mesh.Triangles.Count == mesh.subMeshCount && all.Length % 3 == 0 && all.Distinct().Count() == mesh.vertices.Length && mesh.normals.Length == mesh.vertices.Length && mesh.uv.Length == mesh.vertices.Length;
            }

            public static bool ComesBack(ulong seed)
            {
                var saves = new GameObject("saves").AddComponent<CreatureSaves>();
                var before = new GameObject("before").AddComponent<CreatureBehaviour>();
                var after = new GameObject("after").AddComponent<CreatureBehaviour>();
                if (saves.Load(after))
                {
                    return false;
                }

                before.Show(CreatureGenerator.Generate(seed));
                typeof(CreatureSaves).GetField("creature", Own).SetValue(saves, before);
                saves.Save();
                return saves.Load(after) && after.Creature.Blueprint.Equals(before.Creature.Blueprint);
            }

            public static int Herd()
            {
                var spawner = new GameObject("spawner").AddComponent<CreatureSpawner>();
                Call(spawner, "Start");
                Call(spawner, "Update");
                return ((CreatureBehaviour[])typeof(CreatureSpawner).GetField("herd", Own).GetValue(spawner)).Select(one => one.Creature.Blueprint.ToString()).Distinct().Count();
            }

            public static byte[] Texture(ulong seed) => CreatureMeshes.BaseColour(CreatureGenerator.Generate(seed), 256).Data;

            private static Vector3 Skin(Transform[] bones, Mesh mesh, int bone, int vertex) => bones[bone].position + (bones[bone].rotation * mesh.bindposes[bone].MultiplyPoint3x4(mesh.vertices[vertex]));

            private static void Call(object target, string method) => target.GetType().GetMethod(method, Own).Invoke(target, null);
        }
        """;

    private static readonly Lazy<Assembly> sample = new(() => EngineSamples.Compile("samples/Unity", LanguageVersion.CSharp9, Checks));

    [Theory]
    [InlineData(101, Explicit = true)]
    [InlineData(42)]
    public void Unity_draws_each_vertex_where_the_library_has_it(ulong seed)
    {
        Assert.InRange(sample.Value.Call<float>("WorstVertex", seed), 0f, 1e-3f);
        Assert.True(sample.Value.Call<float>("Way", seed) > 0.1f);
        Assert.True(sample.Value.Call<bool>("IsComplete", seed));
    }

    [Fact]
    public void A_saved_creature_comes_back() => Assert.True(sample.Value.Call<bool>("ComesBack", 7ul));

    [Fact]
    public void A_herd_has_as_many_individuals() => Assert.Equal(8, sample.Value.Call<int>("Herd"));

    [Fact]
    public void Textures_begin_at_the_bottom_as_unity_wants_them()
    {
        byte[] turned = sample.Value.Call<byte[]>("Texture", 7ul);
        byte[] rows = CreatureGen.Creatures.CreatureTextures.Bake(CreatureGenerator.Generate(7), 256).BaseColour.ToArray();
        Assert.Equal(rows[..768], turned[^768..]);
        Assert.Equal(rows[^768..], turned[..768]);
    }

    [Fact]
    public void Every_asset_has_its_own_id_and_the_library_is_taken_by_name()
    {
        string[] metas = RepositoryFiles.Below(Package, "*.meta").ToArray();
        string[] ids = metas.Select(path => Regex.Match(RepositoryFiles.Text(path), "^guid: ([0-9a-f]{32})$", RegexOptions.Multiline).Groups[1].Value).ToArray();
        Assert.All(ids, id => Assert.NotEmpty(id));
        Assert.Equal(ids.Length, ids.Distinct().Count());
        string[] assets = RepositoryFiles.Below(Package).Where(path => !path.EndsWith(".meta", StringComparison.Ordinal) && !Path.GetFileName(path).StartsWith('.')).ToArray();
        Assert.All(assets, asset => Assert.Contains(asset + ".meta", metas));
        foreach (string definition in RepositoryFiles.Below(Package, "*.asmdef"))
        {
            using JsonDocument json = JsonDocument.Parse(RepositoryFiles.Text(definition));
            Assert.Contains("CreatureGen.dll", json.RootElement.GetProperty("precompiledReferences").EnumerateArray().Select(name => name.GetString()));
        }

        using JsonDocument package = JsonDocument.Parse(RepositoryFiles.Text(Package + "/package.json"));
        Assert.Equal("com.creaturegen", package.RootElement.GetProperty("name").GetString());
        Assert.Equal(typeof(CreatureGenerator).Assembly.GetName().Version!.ToString(3), package.RootElement.GetProperty("version").GetString());
        Assert.All(package.RootElement.GetProperty("samples").EnumerateArray(), one => Assert.True(Directory.Exists(SampleFiles.At(Package + "/" + one.GetProperty("path").GetString()))));
    }
}
