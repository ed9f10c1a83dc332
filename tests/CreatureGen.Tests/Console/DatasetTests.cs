using System;
using System.IO;
using System.Linq;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Text;
using System.Text.Json;
using System.Text.RegularExpressions;
using CreatureGen.Console;
using CreatureGen.Creatures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using Xunit;

namespace CreatureGen.Tests.Console;

public sealed class DatasetTests
{
    private const string Line = "generate --seeds 7,9 --no-picture --textures none --triangles 6000 --dataset 2 --picture-size 40x32 --out set";

    [Fact]
    public void A_data_set_has_for_each_view_a_picture_and_arrays_of_its_size_and_for_each_creature_poses_and_labels()
    {
        using var run = new ConsoleRun();
        Assert.Equal(ExitCode.Done, run.Run(Line.Split(' ')));
        foreach (string seed in new[] { "7", "9" })
        {
            using JsonDocument labels = JsonDocument.Parse(File.ReadAllBytes(run.At($"set/creature-{seed}-labels.json")));
            int joints = labels.RootElement.GetProperty("joints").GetArrayLength();
            Assert.Equal(2, labels.RootElement.GetProperty("views").GetArrayLength());
            foreach (JsonElement view in labels.RootElement.GetProperty("views").EnumerateArray())
            {
                byte[] png = run.Bytes("set/" + view.GetProperty("view").GetString());
                Assert.Equal([40, 32], [png[19], png[23]]);
                float[] depths = MemoryMarshal.Cast<byte, float>(Array(run, view.GetProperty("depth").GetString()!, "<f4", "32,40,")).ToArray();
                ushort[] parts = MemoryMarshal.Cast<byte, ushort>(Array(run, view.GetProperty("parts").GetString()!, "<u2", "32,40,")).ToArray();
                Half[] normals = MemoryMarshal.Cast<byte, Half>(Array(run, view.GetProperty("normals").GetString()!, "<f2", "32,40,3,")).ToArray();
                Assert.InRange(parts.Count(part => part > 0), 100, 32 * 40);
                Assert.InRange(parts.Max(), 2, joints);
                for (int i = 0; i < depths.Length; i++)
                {
                    float length = new Vector3((float)normals[3 * i], (float)normals[(3 * i) + 1], (float)normals[(3 * i) + 2]).Length();
                    Assert.Equal(parts[i] > 0, depths[i] > 0);
                    Assert.Equal(parts[i] > 0 ? 1f : 0f, length, 2e-3f);
                }

                // Joints are inside the creature: somewhere near most of them something is seen.
                JsonElement[] projected = view.GetProperty("joints").EnumerateArray().ToArray();
                Assert.Equal(joints, projected.Length);
                int seen = projected.Count(joint => parts[(Math.Clamp((int)joint[1].GetSingle(), 0, 31) * 40) + Math.Clamp((int)joint[0].GetSingle(), 0, 39)] > 0);
                Assert.InRange(seen, joints / 2, joints);
            }

            int frames = labels.RootElement.GetProperty("clips").EnumerateArray().Sum(clip => clip.GetProperty("frames").GetInt32());
            Assert.True(frames > 60);
            float[] poses = MemoryMarshal.Cast<byte, float>(Array(run, $"creature-{seed}-poses.npy", "<f4", FormattableString.Invariant($"{frames},{joints},7,"))).ToArray();
            Assert.All(Enumerable.Range(0, frames * joints), i => Assert.Equal(1f, new Vector4(poses[7 * i], poses[(7 * i) + 1], poses[(7 * i) + 2], poses[(7 * i) + 3]).Length(), 1e-3f));
        }

        Assert.Equal(ExitCode.Done, run.Run("verify", "--manifest", "set", "--grow"));
    }

    /// <summary>The index is what a reader of the set opens; a set made in shards gets its index, to the byte, from the merge.</summary>
    [Fact(Explicit = true)]
    public void The_index_names_every_file_of_every_creature_by_what_is_in_it()
    {
        using var run = new ConsoleRun();
        string[] line = Line.Replace("40x32", "16x16", StringComparison.Ordinal).Split(' ');
        Assert.Equal(ExitCode.Done, run.Run(line));
        string[] index = File.ReadAllLines(run.At("set/index.jsonl"));
        Assert.Equal(2, index.Length);
        foreach ((string text, string seed) in index.Zip(["7", "9"]))
        {
            using JsonDocument creature = JsonDocument.Parse(text);
            Assert.Equal(seed, creature.RootElement.GetProperty("seed").GetString());
            Assert.Equal($"creature-{seed}.glb", creature.RootElement.GetProperty("glb").GetString());
            Assert.Equal([$"creature-{seed}-depth-0.npy", $"creature-{seed}-depth-1.npy"], creature.RootElement.GetProperty("depth").EnumerateArray().Select(path => path.GetString()));
            string[] named = creature.RootElement.EnumerateObject().SelectMany(part => part.Value.ValueKind == JsonValueKind.Array ? part.Value.EnumerateArray() : Enumerable.Repeat(part.Value, 1)).Select(value => value.ToString()).Where(value => value.Contains('.', StringComparison.Ordinal)).ToArray();
            Assert.Equal(Directory.GetFiles(run.At("set"), $"creature-{seed}*").Select(path => Path.GetFileName(path)).Order(StringComparer.Ordinal), named.Order(StringComparer.Ordinal));
        }

        foreach (string shard in new[] { "0/2", "1/2" })
        {
            Assert.Equal(ExitCode.Done, run.Run([.. line[..^1], "shards", "--shard", shard]));
        }

        Assert.False(File.Exists(run.At("shards/index.jsonl")));
        Assert.Equal(ExitCode.Done, run.Run("merge", "shards"));
        Assert.Equal(run.Bytes("set/index.jsonl"), run.Bytes("shards/index.jsonl"));
        Assert.Equal(ExitCode.Done, run.Run([.. line, "--resume"]));
        Assert.Equal(run.Bytes("shards/index.jsonl"), run.Bytes("set/index.jsonl"));
    }

    /// <summary>Against a naive reference: the triangle's plane, met by the ray through the pixel's middle.</summary>
    [Fact]
    public void Maps_tell_the_distance_of_the_triangle_that_they_name()
    {
        Creature creature = CreatureGenerator.Generate(7);
        RenderMesh mesh = RenderMesh.From(creature);
        Camera camera = Camera.Fit(View.ThreeQuarter, mesh.Bounds, 1f);
        const int size = 64;
        SurfaceMaps maps = SurfaceMaps.Find(mesh, camera, size, size);
        double tangent = Math.Tan(camera.FieldOfViewDegrees * Math.PI / 360);
        int seen = 0;
        for (int i = 0; i < maps.Triangles.Length; i++)
        {
            if (maps.Triangles[i] < 0)
            {
                Assert.Equal(0f, maps.Depths[i]);
                continue;
            }

            Vector3 a = mesh.Positions[mesh.Triangles[3 * maps.Triangles[i]]];
            Vector3 b = mesh.Positions[mesh.Triangles[(3 * maps.Triangles[i]) + 1]];
            Vector3 c = mesh.Positions[mesh.Triangles[(3 * maps.Triangles[i]) + 2]];
            Vector3 normal = Vector3.Cross(b - a, c - a);
            Vector3 ray = camera.Forward + (camera.Right * (float)((((i % size) + 0.5) / size * 2 - 1) * tangent)) - (camera.Up * (float)((((i / size) + 0.5) / size * 2 - 1) * tangent));
            float distance = Vector3.Dot(a - camera.Eye, normal) / Vector3.Dot(ray, normal);
            float edge = MathF.Max((b - a).Length(), MathF.Max((c - b).Length(), (a - c).Length()));
            Assert.InRange(maps.Depths[i], distance - edge - 1e-3f, distance + edge + 1e-3f);
            seen++;
        }

        Assert.InRange(seen, size * size / 10, size * size);
        Assert.Equal(maps.Triangles.ToArray(), SurfaceMaps.Find(mesh, camera, size, size, 3).Triangles.ToArray());
        Assert.Throws<ArgumentOutOfRangeException>(() => SurfaceMaps.Find(mesh, camera, 0, size));
    }

    /// <summary>The content of an array file, whose header must say what is expected.</summary>
    private static byte[] Array(ConsoleRun run, string name, string type, string shape)
    {
        byte[] file = run.Bytes("set/" + name);
        Assert.Equal([0x93, (byte)'N', (byte)'U', (byte)'M', (byte)'P', (byte)'Y', 1, 0], file[..8]);
        int start = 10 + file[8] + (file[9] << 8);
        Assert.Equal(0, start % 64);
        string header = Encoding.ASCII.GetString(file, 10, start - 10);
        Assert.EndsWith("\n", header, StringComparison.Ordinal);
        Assert.Contains($"'descr': '{type}', 'fortran_order': False, 'shape': ({shape})", header, StringComparison.Ordinal);
        int count = Regex.Matches(shape, @"\d+").Aggregate(1, (product, side) => product * int.Parse(side.Value, System.Globalization.CultureInfo.InvariantCulture));
        Assert.Equal(start + (count * (type[2] - '0')), file.Length);
        return file[start..];
    }
}
