using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Numerics;
using System.Text.Json;
using System.Threading.Tasks;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Geometry;
using CreatureGen.Gltf;
using CreatureGen.Rigging;
using CreatureGen.Skinning;
using Xunit;

namespace CreatureGen.Tests.Gltf;

/// <summary>Compares what a reader that shares no code with the writer finds in the files with what was to be written.</summary>
public sealed class IndependentReaderTests(CreatureFolder folder)
{
    [Fact(Explicit = true)]
    public async Task Another_reader_finds_what_was_written()
    {
        (int exitCode, string output, string errors) = await GltfTools.RunAsync("read.mjs", folder.Path, TestContext.Current.CancellationToken);
        Assert.True(exitCode == 0, errors);
        JsonElement[] read = output.Split('\n', StringSplitOptions.RemoveEmptyEntries).Select(line => JsonDocument.Parse(line).RootElement).ToArray();
        Assert.Equal(2 * ((3 * CreatureFiles.OfEachKind) + 2), folder.Files.Count);
        Assert.Equal(folder.Files.Select(f => f.Name), read.Select(r => r.GetProperty("file").GetString()));
        for (int i = 0; i < read.Length; i++)
        {
            CompareAsset(folder.Files[i], read[i]);
            CompareJoints(folder.Files[i].Creature, read[i]);
            CompareSockets(folder.Files[i].Creature, read[i]);
            CompareMesh(folder.Files[i], read[i]);
        }
    }

    private static void CompareAsset(CreatureFile file, JsonElement read)
    {
        Assert.Equal(0, read.GetProperty("warnings").GetArrayLength());
        Assert.Equal(file.Creature.Blueprint.Seed.ToString(CultureInfo.InvariantCulture), read.GetProperty("seed").GetString());
        Assert.Equal(CreatureBlueprint.CurrentAlgorithm, read.GetProperty("algorithmVersion").GetInt32());
        Assert.Equal(BlueprintFormat.Current, read.GetProperty("blueprintVersion").GetInt32());
        Assert.Equal(file.Options.Provenance, read.GetProperty("options").GetString());
        Assert.Equal(["Creature", "Root"], Texts(read, "roots"));
        Assert.Equal("Root", read.GetProperty("skeleton").GetString());
        Assert.Equal(file.Creature.Mass.Mass, read.GetProperty("mass").GetSingle());
    }

    private static void CompareJoints(Creature creature, JsonElement read)
    {
        IReadOnlyList<Joint> joints = creature.Skeleton.Joints;
        JsonElement[] found = read.GetProperty("joints").EnumerateArray().ToArray();
        Assert.Equal(joints.Select(j => j.Name), found.Select(j => j.GetProperty("name").GetString()));
        Assert.Equal(joints.Select(j => j.Parent < 0 ? null : joints[j.Parent].Name), found.Select(j => j.GetProperty("parent").GetString()));
        for (int i = 0; i < found.Length; i++)
        {
            Assert.Equal(Numbers(joints[i].LocalPosition), Singles(found[i], "translation"));
            Assert.Equal([1f, 1f, 1f], Singles(found[i], "scale"));
            Assert.Equal(creature.Bones.Count(b => b.Joint == i), found[i].GetProperty("colliders").GetInt32());
            float[] rotation = Singles(found[i], "rotation");
            Assert.Equal(joints[i].LocalRotation.X, rotation[0], 1e-7f);
            Assert.Equal(joints[i].LocalRotation.Y, rotation[1], 1e-7f);
            Assert.Equal(joints[i].LocalRotation.Z, rotation[2], 1e-7f);
            Assert.Equal(joints[i].LocalRotation.W, rotation[3], 1e-7f);
        }

        Assert.InRange(read.GetProperty("bindError").GetDouble(), 0, 1e-5);
        JsonElement[] limbs = read.GetProperty("limbs").EnumerateArray().ToArray();
        Assert.Equal(creature.Limbs.Select(l => JsonNamingPolicy.CamelCase.ConvertName(l.Kind.ToString())), limbs.Select(l => l.GetProperty("kind").GetString()));
        Assert.Equal(creature.Limbs.Select(l => string.Join(' ', l.Joints.Select(j => joints[j].Name))), limbs.Select(l => string.Join(' ', Texts(l, "joints"))));
    }

    private static void CompareSockets(Creature creature, JsonElement read)
    {
        JsonElement[] found = read.GetProperty("sockets").EnumerateArray().ToArray();
        Assert.Equal(creature.AttachmentPoints.Select(p => p.Name), found.Select(s => s.GetProperty("name").GetString()));
        for (int i = 0; i < found.Length; i++)
        {
            AttachmentPoint point = creature.AttachmentPoints[i];
            Assert.Equal(creature.Skeleton.Joints[point.Joint].Name, found[i].GetProperty("parent").GetString());
            Assert.Equal(0, found[i].GetProperty("children").GetInt32());
            Assert.Equal(point.Width, found[i].GetProperty("width").GetSingle());
            float[] place = Singles(found[i], "translation");
            Assert.True(Vector3.Distance(point.Position, new Vector3(place[0], place[1], place[2])) < 1e-5f);
        }
    }

    private static void CompareMesh(CreatureFile file, JsonElement read)
    {
        CreatureMesh mesh = LodStack.Of(file.Creature.Mesh, file.Options).Mesh;
        Assert.Equal(["COLOR_0", "JOINTS_0", "NORMAL", "POSITION", "TEXCOORD_0", "WEIGHTS_0"], Texts(read, "attributes"));
        Assert.Equal(mesh.Positions.Length, read.GetProperty("vertices").GetInt32());
        Vector3[] positions = mesh.Positions.ToArray();
        Assert.Equal(Numbers(positions.Aggregate(Vector3.Min)), Singles(read, "min"));
        Assert.Equal(Numbers(positions.Aggregate(Vector3.Max)), Singles(read, "max"));
        SkinWeights[] skin = mesh.Weights.ToArray();
        bool manyJoints = file.Creature.Skeleton.Joints.Count > 255;
        AssertDigest("Float32Array", positions.Select(Doubles), read.GetProperty("position"));
        AssertDigest("Float32Array", mesh.Normals.ToArray().Select(Doubles), read.GetProperty("normal"));
        AssertDigest("Float32Array", mesh.Texcoords.ToArray().Select(t => new double[] { t.X, t.Y }), read.GetProperty("texcoord"));
        AssertDigest("Uint16Array", mesh.Colours.ToArray().Select(c => new[] { Fraction(c.X), Fraction(c.Y), Fraction(c.Z), 65535.0 }), read.GetProperty("colour"));
        AssertDigest(manyJoints ? "Uint16Array" : "Uint8Array", skin.Select(w => new double[] { w.Joint0, w.Joint1, w.Joint2, w.Joint3 }), read.GetProperty("joint"));
        AssertDigest("Float32Array", skin.Select(w => Doubles(InfluenceWriter.SumToOne(w.Weights))), read.GetProperty("weight"));
        Assert.True(read.GetProperty("colour").GetProperty("normalized").GetBoolean());
        JsonElement[] parts = read.GetProperty("parts").EnumerateArray().ToArray();
        Assert.Equal(mesh.Parts.Select(p => p.Material.ToString()), parts.Select(p => p.GetProperty("material").GetString()));
        Assert.Equal(mesh.Parts.Select(p => p.Material.ToString()).Distinct(), Texts(read, "materials"));
        for (int i = 0; i < parts.Length; i++)
        {
            int[] corners = mesh.Triangles.Slice(mesh.Parts[i].FirstIndex, mesh.Parts[i].IndexCount).ToArray();
            AssertDigest(mesh.Positions.Length > 65535 ? "Uint32Array" : "Uint16Array", corners.Select(c => new double[] { c }), parts[i].GetProperty("index"));
            Assert.Equal(mesh.Parts[i].Material == MaterialKind.Membrane, parts[i].GetProperty("doubleSided").GetBoolean());
            Assert.Equal("OPAQUE", parts[i].GetProperty("alphaMode").GetString());
            Assert.Equal([1f, 1f, 1f, 1f], Singles(parts[i], "baseColour"));
            Assert.Equal(0.0, parts[i].GetProperty("metallic").GetDouble());
        }
    }

    /// <summary>Counts and sums, in the order and precision in which the other reader takes them.</summary>
    private static void AssertDigest(string stored, IEnumerable<double[]> elements, JsonElement digest)
    {
        int count = 0;
        double[] sum = [];
        double[] woven = [];
        foreach (double[] element in elements)
        {
            sum = count == 0 ? new double[element.Length] : sum;
            woven = count == 0 ? new double[element.Length] : woven;
            for (int k = 0; k < element.Length; k++)
            {
                sum[k] += element[k];
                woven[k] += ((count % 251) + 1) * element[k];
            }

            count++;
        }

        Assert.Equal(stored, digest.GetProperty("stored").GetString());
        Assert.Equal(count, digest.GetProperty("count").GetInt32());
        Assert.Equal(sum, GlbFile.Array(digest, "sum"));
        Assert.Equal(woven, GlbFile.Array(digest, "woven"));
    }

    private static double Fraction(float x) => Math.Floor((x * 65535.0) + 0.5);

    private static double[] Doubles(Vector3 v) => [v.X, v.Y, v.Z];

    private static double[] Doubles(Vector4 v) => [v.X, v.Y, v.Z, v.W];

    private static float[] Numbers(Vector3 v) => [v.X, v.Y, v.Z];

    private static float[] Singles(JsonElement element, string name) => element.GetProperty(name).EnumerateArray().Select(x => x.GetSingle()).ToArray();

    private static string[] Texts(JsonElement element, string name) => element.GetProperty(name).EnumerateArray().Select(x => x.GetString()!).ToArray();
}
