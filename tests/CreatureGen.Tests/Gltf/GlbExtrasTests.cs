using System.Linq;
using System.Numerics;
using System.Text.Json;
using System;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Rigging;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbExtrasTests
{
    private static readonly Creature Sample = SampleCreature.Build(SampleShape.Of(6));

    [Fact]
    public void The_asset_says_where_the_creature_comes_from()
    {
        JsonElement asset = GlbFile.Of(Sample, new GltfOptions { Provenance = "{\"kind\":\"walking\"}" }).Json.GetProperty("asset");
        Assert.Equal("2.0", asset.GetProperty("version").GetString());
        Assert.Equal("CreatureGen", asset.GetProperty("generator").GetString());
        JsonElement own = asset.GetProperty("extras").GetProperty("creaturegen");
        Assert.Equal("18446744073709551609", own.GetProperty("seed").GetString());
        Assert.Equal(CreatureBlueprint.CurrentAlgorithm, own.GetProperty("algorithmVersion").GetInt32());
        Assert.Equal("{\"kind\":\"walking\"}", own.GetProperty("options").GetString());
        Assert.Equal(JsonValueKind.Object, own.GetProperty("blueprint").ValueKind);
    }

    [Fact]
    public void Without_provenance_there_are_no_options()
    {
        JsonElement own = GlbFile.Of(Sample).Json.GetProperty("asset").GetProperty("extras").GetProperty("creaturegen");
        Assert.False(own.TryGetProperty("options", out _));
    }

    [Fact]
    public void Provenance_may_hold_any_text()
    {
        const string Text = "\"quoted\" \\ \u0001\n é 漢 \U0001F98E </script>";
        JsonElement own = GlbFile.Of(Sample, new GltfOptions { Provenance = Text }).Json.GetProperty("asset").GetProperty("extras").GetProperty("creaturegen");
        Assert.Equal(Text, own.GetProperty("options").GetString());
    }

    [Fact]
    public void Capsules_are_in_the_extras_of_their_joints()
    {
        CapsuleCollider second = new(Sample.Bones[0].Joint, new Vector3(1, 2, 3), new Vector3(4, 5, 6), 0.5f);
        Creature creature = Sample with { Bones = [.. Sample.Bones, second] };
        JsonElement nodes = GlbFile.Of(creature).Json.GetProperty("nodes");
        for (int i = 0; i < creature.Skeleton.Joints.Count; i++)
        {
            CapsuleCollider[] expected = creature.Bones.Where(b => b.Joint == i).ToArray();
            JsonElement node = nodes[1 + i];
            JsonElement colliders = default;
            bool has = node.TryGetProperty("extras", out JsonElement extras) && extras.TryGetProperty("colliders", out colliders);
            Assert.Equal(expected.Length > 0, has);
            if (has)
            {
                AssertCapsules(expected, colliders.EnumerateArray().ToArray());
            }
        }
    }

    [Fact]
    public void The_root_joint_tells_of_the_whole_creature()
    {
        JsonElement extras = GlbFile.Of(Sample).Json.GetProperty("nodes")[1].GetProperty("extras");
        AssertCapsules([Sample.Body], [extras.GetProperty("body")]);
        Assert.Equal(Sample.StandingHeight, extras.GetProperty("standingHeight").GetSingle());
        Assert.Equal(Sample.DefaultSpeed, extras.GetProperty("defaultSpeed").GetSingle());
        JsonElement mass = extras.GetProperty("massProperties");
        Assert.Equal(Sample.Mass.Mass, mass.GetProperty("mass").GetSingle());
        Assert.Equal(Sample.Mass.Volume, mass.GetProperty("volume").GetSingle());
        Assert.Equal(Sample.Mass.Centre, Vector(mass, "centre"));
        Assert.Equal(Sample.Mass.InertiaDiagonal, Vector(mass, "inertiaDiagonal"));
        Assert.Equal(Sample.Mass.InertiaProducts, Vector(mass, "inertiaProducts"));
    }

    [Fact]
    public void Limbs_name_their_joints()
    {
        JsonElement[] limbs = GlbFile.Of(Sample).Json.GetProperty("nodes")[1].GetProperty("extras").GetProperty("limbs").EnumerateArray().ToArray();
        Assert.Equal(4, limbs.Length);
        for (int i = 0; i < limbs.Length; i++)
        {
            LimbChain limb = Sample.Limbs[i];
            Assert.Equal(Camel(limb.Kind.ToString()), limbs[i].GetProperty("kind").GetString());
            Assert.Equal(Camel(limb.Side.ToString()), limbs[i].GetProperty("side").GetString());
            Assert.Equal(limb.Pair, limbs[i].GetProperty("pair").GetInt32());
            Assert.Equal(limb.Joints.Select(j => Sample.Skeleton.Joints[j].Name), limbs[i].GetProperty("joints").EnumerateArray().Select(j => j.GetString()));
            Assert.Equal(limb.Pole, Vector(limbs[i], "pole"));
            Assert.Equal(limb.Contact, Vector(limbs[i], "contact"));
            Assert.Equal(limb.Stands, limbs[i].GetProperty("stands").GetBoolean());
        }
    }

    private static void AssertCapsules(CapsuleCollider[] expected, JsonElement[] actual)
    {
        Assert.Equal(expected.Length, actual.Length);
        for (int i = 0; i < expected.Length; i++)
        {
            Assert.Equal("capsule", actual[i].GetProperty("shape").GetString());
            Assert.Equal(expected[i].Radius, actual[i].GetProperty("radius").GetSingle());
            Assert.Equal(expected[i].Start, Vector(actual[i], "start"));
            Assert.Equal(expected[i].End, Vector(actual[i], "end"));
        }
    }

    private static string Camel(string name) => char.ToLowerInvariant(name[0]) + name[1..];

    private static Vector3 Vector(JsonElement element, string name)
    {
        float[] v = element.GetProperty(name).EnumerateArray().Select(x => x.GetSingle()).ToArray();
        Assert.Equal(3, v.Length);
        return new Vector3(v[0], v[1], v[2]);
    }
}
