using System;
using System.Buffers.Binary;
using System.IO;
using System.Linq;
using System.Text;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class GlbBlueprintTests
{
    private static readonly Creature Sample = SampleCreature.Build(SampleShape.Of(5));

    [Fact]
    public void The_blueprint_is_read_back_as_it_was()
    {
        for (ulong seed = 0; seed < 60; seed++)
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed * 0x9E3779B97F4A7C15UL, (LocomotionKind)(seed % 3));
            BlueprintReading reading = Read(GlbFile.Write(Sample with { Blueprint = blueprint }));
            Assert.Empty(reading.Problems);
            Assert.Equal(blueprint, reading.Blueprint);
        }
    }

    [Fact]
    public void Reading_does_not_go_beyond_the_json_and_leaves_the_stream_open()
    {
        byte[] bytes = GlbFile.Write(Sample);
        int end = 20 + (int)BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(12));
        using var stream = new MemoryStream([1, 2, 3, .. bytes]) { Position = 3 };
        Assert.NotNull(GlbReader.ReadBlueprint(stream).Blueprint);
        Assert.True(stream.CanRead);
        Assert.Equal(3 + end, stream.Position);
    }

    [Fact]
    public void A_stream_that_gives_one_byte_at_a_time_and_cannot_seek_will_do()
    {
        using var stream = new TrickleStream(GlbFile.Write(Sample));
        Assert.Equal(Sample.Blueprint, GlbReader.ReadBlueprint(stream).Blueprint);
    }

    [Fact]
    public void Files_that_are_no_glb_are_told_what_they_are()
    {
        AssertProblem("file = nothing; expected a GLB file, which begins with 67 6C 54 46 (\"glTF\")", []);
        AssertProblem("file = 7B 22; expected a GLB file, which begins with 67 6C 54 46 (\"glTF\")", "{\""u8.ToArray());
        AssertProblem("file = 89 50 4E 47; expected a GLB file, which begins with 67 6C 54 46 (\"glTF\")", [0x89, 0x50, 0x4E, 0x47, 0x0D, 0x0A]);
        AssertProblem("file = 4 bytes; expected at least the 20 bytes of the headers of the file and of its first chunk", "glTF"u8.ToArray());
        AssertProblem("version = 1; expected GLB version 2", Changed(4, 1));
        AssertProblem("first chunk = type 42 49 4E 00; expected 4A 53 4F 4E (\"JSON\")", Changed(16, 0x004E4942));
        AssertProblem("JSON chunk = 4294967295 bytes; expected at most 67108864 bytes", Changed(12, uint.MaxValue));
        AssertProblem("length = 100 bytes; expected at least the ", Changed(8, 100));
    }

    [Fact]
    public void A_file_that_was_cut_off_anywhere_is_reported()
    {
        byte[] bytes = GlbFile.Write(Sample);
        int end = 20 + (int)BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(12));
        for (int length = 0; length < end; length += 1 + (length / 40))
        {
            BlueprintReading reading = Read(bytes[..length]);
            Assert.Null(reading.Blueprint);
            Assert.Single(reading.Problems);
        }

        AssertProblem(FormattableString.Invariant($"JSON chunk = 80 bytes before the file ends; expected {end - 20} bytes, as its header says"), bytes[..100]);
        Assert.NotNull(Read(bytes[..end]).Blueprint);
    }

    [Fact]
    public void A_length_that_lies_costs_no_memory()
    {
        byte[] bytes = Glb("{}");
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(8), 60_000_020);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(12), 60_000_000);
        long before = GC.GetAllocatedBytesForCurrentThread();
        AssertProblem("JSON chunk = 4 bytes before the file ends; expected 60000000 bytes, as its header says", bytes);
        Assert.True(GC.GetAllocatedBytesForCurrentThread() - before < 1_000_000);
    }

    [Theory]
    [InlineData("", "JSON chunk = the end of the text; expected a value (line 1, column 1)")]
    [InlineData("{\"asset\":", "asset = the end of the text; expected a value")]
    [InlineData("{\"asset\":{}} x", "JSON chunk = x; expected the end of the text")]
    [InlineData("[]", "asset.extras.creaturegen.blueprint = nothing; expected a blueprint, which files written by CreatureGen have")]
    [InlineData("{}", "asset.extras.creaturegen.blueprint = nothing")]
    [InlineData("{\"asset\":{\"version\":\"2.0\",\"extras\":7}}", "asset.extras.creaturegen.blueprint = nothing")]
    [InlineData("{\"asset\":{\"extras\":{\"creaturegen\":{\"seed\":\"1\"}}}}", "asset.extras.creaturegen.blueprint = nothing")]
    [InlineData("{\"asset\":{\"extras\":{\"creaturegen\":{\"blueprint\":3}}}}", "asset.extras.creaturegen.blueprint = 3; expected an object")]
    [InlineData("{\"asset\":{\"extras\":{\"creaturegen\":{\"blueprint\":{\"version\":99}}}}}", "asset.extras.creaturegen.blueprint.version = 99; expected a whole number 1..")]
    public void Json_without_a_blueprint_is_reported(string json, string problem) => AssertProblem(problem, Glb(json));

    [Fact]
    public void What_is_wrong_with_the_blueprint_is_told_with_its_place_in_the_file()
    {
        string json = Json(GlbFile.Write(Sample));
        string broken = json.Replace("\"scale\":", "\"scale\":1e9,\"size\":", StringComparison.Ordinal);
        Assert.NotEqual(json, broken);
        BlueprintReading reading = Read(Glb(broken));
        Assert.Null(reading.Blueprint);
        Assert.Contains(reading.Problems, p => p.Path == "asset.extras.creaturegen.blueprint.scale" && p.Column > 1);
        Assert.Contains(reading.Problems, p => p.Path == "asset.extras.creaturegen.blueprint.size");
    }

    /// <summary>It took over a gigabyte: each number of the mesh became an object.</summary>
    [Fact]
    public void A_file_of_many_megabytes_of_json_costs_no_more_memory_than_its_text()
    {
        string json = Json(GlbFile.Write(Sample));
        string numbers = string.Join(',', Enumerable.Range(0, 1_500_000));
        byte[] large = Glb(json.Insert(1, "\"more\":[{\"a\":\"\\u00e9\",\"b\":[" + numbers + "],\"c\":[true,false,null,-1.5e-3]}],"));
        long before = GC.GetAllocatedBytesForCurrentThread();
        BlueprintReading reading = Read(large);
        long taken = GC.GetAllocatedBytesForCurrentThread() - before;
        Assert.Equal(Sample.Blueprint, reading.Blueprint);
        Assert.True(large.Length > 10_000_000);
        Assert.True(taken < large.Length + 1_000_000, $"{taken} bytes for a file of {large.Length}");
    }

    [Theory]
    [InlineData("{\"a\":[1,02]}", "a = 02; expected a number without leading zeros")]
    [InlineData("{\"a\":[1,}]}", "a = '}'; expected a value")]
    [InlineData("{\"a\":{\"b\" 1}}", "a = 1; expected ':'")]
    [InlineData("{\"a\":{b:1}}", "a = b; expected a name in quotation marks")]
    [InlineData("{\"a\":[nul]}", "a = nul; expected a value")]
    [InlineData("{\"a\":[truely]}", "a = truely; expected a value")]
    [InlineData("{\"a\":[1 2]}", "a = 2; expected ',' or ']'")]
    [InlineData("{\"a\":{\"b\":1;}}", "a = ';'; expected ',' or '}'")]
    [InlineData("{\"a\":\"\\x\"}", "a = '\\'; expected an escape sequence of JSON")]
    [InlineData("{\"a\":\"\\ud800\"}", "a = '\\'; expected both halves of a surrogate pair")]
    [InlineData("{\"a\":\"x", "a = the end of the text; expected '\"'")]
    [InlineData("{\"a\":{\"b", "a = the end of the text; expected '\"'")]
    public void What_is_passed_over_is_checked_all_the_same(string json, string problem) => AssertProblem(problem, Glb(json));

    [Fact]
    public void What_is_passed_over_lies_no_deeper_than_what_is_kept() =>
        AssertProblem("a = deeper nesting; expected at most 64 levels", Glb("{\"a\":" + new string('[', 100) + new string(']', 100) + "}"));

    [Fact]
    public void Damaged_files_never_crash_the_reader()
    {
        byte[] bytes = GlbFile.Write(Sample);
        int end = 20 + (int)BinaryPrimitives.ReadUInt32LittleEndian(bytes.AsSpan(12));
        var random = new RandomStream(3);
        for (int i = 0; i < 2000; i++)
        {
            byte[] damaged = bytes[..end];
            for (int k = random.Integer(1, 5); k > 0; k--)
            {
                damaged[random.Integer(0, i % 2 == 0 ? 24 : end)] = (byte)random.Integer(0, 256);
            }

            BlueprintReading reading = Read(damaged);
            Assert.Equal(reading.Blueprint is null, reading.Problems.Count > 0);
        }
    }

    [Fact]
    public void A_blueprint_that_no_text_can_hold_is_refused()
    {
        Creature creature = Sample with { Blueprint = Sample.Blueprint with { Scale = double.NaN } };
        var error = Assert.Throws<InvalidOperationException>(() => GlbFile.Write(creature));
        Assert.Contains("the blueprint", error.Message, StringComparison.Ordinal);
        Assert.Contains("scale = NaN", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Arguments_are_checked()
    {
        Assert.Throws<ArgumentNullException>("source", () => GlbReader.ReadBlueprint(null!));
        var closed = new MemoryStream();
        closed.Dispose();
        Assert.Throws<ArgumentException>("source", () => GlbReader.ReadBlueprint(closed));
    }

    private static BlueprintReading Read(byte[] bytes)
    {
        using var stream = new MemoryStream(bytes);
        return GlbReader.ReadBlueprint(stream);
    }

    private static void AssertProblem(string expected, byte[] bytes)
    {
        BlueprintReading reading = Read(bytes);
        Assert.Null(reading.Blueprint);
        Assert.StartsWith(expected, reading.Problems[0].ToString(), StringComparison.Ordinal);
    }

    private static byte[] Changed(int at, uint value)
    {
        byte[] bytes = GlbFile.Write(Sample);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(at), value);
        return bytes;
    }

    private static string Json(byte[] glb) => Encoding.UTF8.GetString(glb, 20, (int)BinaryPrimitives.ReadUInt32LittleEndian(glb.AsSpan(12)));

    /// <summary>A GLB of nothing but JSON.</summary>
    private static byte[] Glb(string json)
    {
        byte[] text = Encoding.UTF8.GetBytes(json.PadRight((json.Length + 3) / 4 * 4));
        byte[] bytes = new byte[20 + text.Length];
        "glTF"u8.CopyTo(bytes);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(4), 2);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(8), (uint)bytes.Length);
        BinaryPrimitives.WriteUInt32LittleEndian(bytes.AsSpan(12), (uint)text.Length);
        "JSON"u8.CopyTo(bytes.AsSpan(16));
        text.CopyTo(bytes, 20);
        return bytes;
    }

    /// <summary>Gives its bytes one by one.</summary>
    private sealed class TrickleStream(byte[] bytes) : MemoryStream(bytes)
    {
        public override bool CanSeek => false;

        public override int Read(byte[] buffer, int offset, int count) => base.Read(buffer, offset, Math.Min(1, count));

        public override int Read(Span<byte> buffer) => base.Read(buffer[..Math.Min(1, buffer.Length)]);
    }
}
