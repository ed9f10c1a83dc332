using System;
using System.IO;
using System.Linq;
using System.Text;
using System.Text.Json;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Json;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class BlueprintJsonTests
{
    [Fact]
    public void What_is_read_equals_what_was_written_and_gives_the_same_text()
    {
        foreach (CreatureBlueprint blueprint in Samples.Drawn(300))
        {
            string text = BlueprintJson.Write(blueprint);
            BlueprintReading reading = BlueprintJson.Read(text);
            Assert.Empty(reading.Problems);
            Assert.Equal(blueprint, reading.Blueprint);
            Assert.Equal(blueprint.GetHashCode(), reading.GetBlueprint().GetHashCode());
            Assert.Equal(text, BlueprintJson.Write(reading.GetBlueprint()));
        }
    }

    [Fact]
    public void Any_numbers_within_the_ranges_survive_writing_and_reading()
    {
        RandomStream random = new Seed(5).Stream();
        for (int i = 0; i < 300; i++)
        {
            CreatureBlueprint blueprint = RandomFields.Draw(CreatureFields.Creature, random);
            var problems = new ProblemList("");
            FieldChecker.Check(blueprint, CreatureFields.Creature, problems);
            JsonValue root = JsonReader.Read(BlueprintJson.Write(blueprint), JsonLimits.Document).Root!;
            CreatureBlueprint read = FieldReader.Read(root, CreatureFields.Creature, BlueprintFormat.Current, MissingField.Reported, problems);
            Assert.Empty(problems.All);
            Assert.Equal(blueprint, read);
        }
    }

    [Fact]
    public void The_text_of_a_small_creature_is_pinned()
    {
        Assert.Equal(GoldenText.Small, BlueprintJson.Write(Samples.Small));
    }

    [Fact]
    public void A_stream_gets_the_same_text_in_UTF_8_without_a_mark()
    {
        var stream = new MemoryStream();
        BlueprintJson.Write(Samples.Small, stream);
        Assert.Equal(Encoding.UTF8.GetBytes(BlueprintJson.Write(Samples.Small)), stream.ToArray());
        stream.Position = 0;
        Assert.Equal(Samples.Small, BlueprintJson.Read(stream).Blueprint);
    }

    [Fact]
    public void A_stream_that_gives_a_byte_at_a_time_is_read_to_its_end()
    {
        Assert.Equal(Samples.Small, BlueprintJson.Read(new DripStream(Encoding.UTF8.GetBytes(BlueprintJson.Write(Samples.Small)))).Blueprint);
    }

    [Fact]
    public void The_text_is_JSON_to_the_framework_too()
    {
        using JsonDocument document = JsonDocument.Parse(BlueprintJson.Write(Samples.Small));
        JsonElement leg = document.RootElement.GetProperty("legs")[1];
        Assert.Equal(1.0 / 3, leg.GetProperty("thickness").GetDouble());
        Assert.Equal(39, leg.GetProperty("socket").GetProperty("ring").GetInt32());
        Assert.Equal("18446744073709551615", document.RootElement.GetProperty("seed").GetString());
    }

    [Fact]
    public void Order_of_fields_and_white_space_do_not_matter()
    {
        using JsonDocument document = JsonDocument.Parse(BlueprintJson.Write(Samples.Small));
        string reversed = "{" + string.Join(" ,\r\n\t", document.RootElement.EnumerateObject().Reverse().Select(member => member.ToString())) + "}";
        Assert.Equal(Samples.Small, BlueprintJson.Read(reversed).Blueprint);
    }

    [Fact]
    public void One_number_is_edited_in_memory_and_kept()
    {
        CreatureBlueprint original = Samples.Small;
        CreatureBlueprint edited = original with { Legs = original.Legs.With(1, original.Legs[1] with { FootSize = 1.75 }) };
        Assert.NotEqual(original, edited);
        Assert.Empty(BlueprintValidator.Validate(edited));
        CreatureBlueprint read = BlueprintJson.Read(BlueprintJson.Write(edited)).GetBlueprint();
        Assert.Equal(edited, read);
        Assert.Equal(original, read with { Legs = read.Legs.With(1, read.Legs[1] with { FootSize = 1 }) });
    }

    [Fact]
    public void One_number_is_edited_in_the_text_and_read()
    {
        string text = BlueprintJson.Write(Samples.Small).Replace("\"scale\": 1.25", "\"scale\": 3", StringComparison.Ordinal);
        Assert.Equal(Samples.Small with { Scale = 3 }, BlueprintJson.Read(text).Blueprint);
    }

    [Fact]
    public void Negative_zero_becomes_zero()
    {
        string text = BlueprintJson.Write(Samples.Small with { Tail = Samples.Small.Tail with { Fork = -0.0 } });
        Assert.Contains("\"fork\": 0,", text, StringComparison.Ordinal);
        CreatureBlueprint read = BlueprintJson.Read(text.Replace("\"fork\": 0,", "\"fork\": -0.0,", StringComparison.Ordinal)).GetBlueprint();
        Assert.False(double.IsNegative(read.Tail.Fork));
    }

    [Fact]
    public void What_no_text_can_hold_is_refused_with_its_place()
    {
        CreatureBlueprint small = Samples.Small;
        AssertRefused(small with { Legs = small.Legs.With(1, small.Legs[1] with { Shear = double.NaN }) }, "legs[1].shear = NaN; expected -2..2");
        AssertRefused(small with { Scale = double.PositiveInfinity }, "scale = Infinity; expected 0.05..20");
        AssertRefused(small with { Head = null! }, "head = null; expected an object");
        AssertRefused(small with { Ears = null! }, "ears = null; expected an array of 0..2 elements");
        AssertRefused(small with { Plan = (BodyPlan)99 }, "plan = an undefined value; expected one of digitigrade, ");
        CreatureBlueprint WithBlend(string name) => small with { Body = small.Body with { Blend = small.Body.Blend with { Skin = name } } };
        AssertRefused(WithBlend(null!), "body.blend.skin = null; expected one of canine, ");
        AssertRefused(WithBlend("\ud800"), "body.blend.skin = \"\\ud800\"; expected one of canine, ");
        Assert.Throws<ArgumentNullException>(() => BlueprintJson.Write(null!));
        Assert.Throws<ArgumentNullException>(() => BlueprintJson.Write(small, null!));
    }

    private static void AssertRefused(CreatureBlueprint blueprint, string problem)
    {
        ArgumentException refusal = Assert.Throws<ArgumentException>(() => BlueprintJson.Write(blueprint));
        Assert.StartsWith("the blueprint cannot be written:\n" + problem, refusal.Message, StringComparison.Ordinal);
    }

    private sealed class DripStream(byte[] bytes) : MemoryStream(bytes)
    {
        public override int Read(byte[] buffer, int offset, int count) => base.Read(buffer, offset, Math.Min(count, 1));
    }
}
