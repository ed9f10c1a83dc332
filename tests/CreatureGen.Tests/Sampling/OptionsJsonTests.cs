using System;
using System.IO;
using System.Text;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Json;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using CreatureGen.Tests.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class OptionsJsonTests
{
    private static readonly CreatureOptions Sample = new()
    {
        Kind = RequestedKind.Swimming,
        MinScale = 0.75,
        MaxLegPairs = 3,
        BodyPlans = new ValueList<BodyPlanWeight>(new[] { new BodyPlanWeight(BodyPlan.Eel, 0.5), new BodyPlanWeight(BodyPlan.Whale, 0) }),
        BaseBodies = new ValueList<BaseBodyWeight>(new[] { new BaseBodyWeight("fish", 4) }),
        Palette = PaletteMood.Vivid,
        Ornaments = OrnamentLevel.Rich,
    };

    [Fact]
    public void The_text_is_pinned()
    {
        Assert.Equal(
            """
            {
              "kind": "swimming",
              "minScale": 0.75,
              "maxScale": 2,
              "minLegPairs": 0,
              "maxLegPairs": 3,
              "bodyPlans": [
                { "plan": "eel", "weight": 0.5 },
                { "plan": "whale", "weight": 0 }
              ],
              "baseBodies": [
                { "name": "fish", "weight": 4 }
              ],
              "strangeness": 0.6,
              "palette": "vivid",
              "ornaments": "rich",
              "triangleBudget": 20000
            }

            """,
            OptionsJson.Write(Sample));
    }

    [Fact]
    public void What_is_read_equals_what_was_written()
    {
        Assert.Equal(Sample, OptionsJson.Read(OptionsJson.Write(Sample)).Options);
        var stream = new MemoryStream();
        OptionsJson.Write(Sample, stream);
        stream.Position = 0;
        Assert.Equal(Sample, OptionsJson.Read(stream).GetOptions());
        Assert.Equal(Sample, OptionsJson.Read(Sample.ToString()).Options);
    }

    [Fact]
    public void Any_values_within_the_ranges_survive_writing_and_reading()
    {
        RandomStream random = new Seed(11).Stream();
        for (int i = 0; i < 300; i++)
        {
            CreatureOptions options = RandomFields.Draw(OptionsFields.Options, random);
            JsonValue root = JsonReader.Read(OptionsJson.Write(options), JsonLimits.Document).Root!;
            var problems = new ProblemList("");
            Assert.Equal(options, FieldReader.Read(root, OptionsFields.Options, BlueprintFormat.Current, MissingField.Reported, problems));
            Assert.Empty(problems.All);
            OptionsReading reading = OptionsJson.Read(OptionsJson.Write(options));
            Assert.Equal(options.Validate(), reading.Problems);
        }
    }

    [Fact]
    public void Text_names_only_what_it_asks_for()
    {
        Assert.Equal(CreatureOptions.Default, OptionsJson.Read("{}").Options);
        Assert.Equal(new CreatureOptions { Kind = RequestedKind.Flying, MaxScale = 8 }, OptionsJson.Read("""{ "kind": "flying", "maxScale": 8 }""").Options);
    }

    [Theory]
    [InlineData("""{ "kind": "digging" }""", "kind = \"digging\"; expected one of any, walking, flying, swimming (line 1, column 11)")]
    [InlineData("""{ "maxscale": 8 }""", "maxscale = 8; expected no field of this name; there are kind, minScale, maxScale, minLegPairs, maxLegPairs, bodyPlans, baseBodies, strangeness, palette, ornaments, triangleBudget, individual (line 1, column 15)")]
    [InlineData("""{ "bodyPlans": [{ "weight": 0 }] }""", "bodyPlans[0].plan = nothing; expected one of digitigrade, unguligrade, plantigrade, columnar, upright, sprawling, theropod, hexapod, manyLegged, legless, centaur, flapping, buzzing, fish, eel, whale, flipper (line 1, column 17)")]
    [InlineData("""{ "baseBodies": [{ "name": "fish" }] }""", "baseBodies[0].weight = nothing; expected 0..1000 (line 1, column 18)")]
    [InlineData("""{ "minScale": 3 }""", "minScale = 3; expected at most maxScale, which is 2")]
    [InlineData("""{ "triangleBudget": 20000.5 }""", "triangleBudget = 20000.5; expected a whole number 6000..100000 (line 1, column 21)")]
    [InlineData("7", "options = 7; expected an object (line 1, column 1)")]
    [InlineData("{", "options = the end of the text; expected a name in quotation marks (line 1, column 2)")]
    public void Wrong_text_is_reported(string text, string problem)
    {
        OptionsReading reading = OptionsJson.Read(text);
        Assert.Null(reading.Options);
        Assert.Equal(problem, Assert.Single(reading.Problems).ToString());
        Assert.Contains(problem, Assert.Throws<InvalidOperationException>(reading.GetOptions).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Every_truncation_is_reported()
    {
        string text = OptionsJson.Write(Sample);
        for (int length = 0; length < text.Length - 1; length++)
        {
            Assert.Single(OptionsJson.Read(text[..length]).Problems);
        }
    }

    [Fact]
    public void Text_that_is_too_long_is_reported_unread()
    {
        string text = "{}" + new string(' ', OptionsJson.MaximumBytes - 1);
        Assert.Equal("options = a longer text; expected at most 1048576 bytes (line 1, column 1)", Assert.Single(OptionsJson.Read(text).Problems).ToString());
        Assert.NotNull(OptionsJson.Read(new MemoryStream(Encoding.UTF8.GetBytes(text[..^1]))).Options);
    }

    [Fact]
    public void What_no_text_can_hold_is_refused()
    {
        ArgumentException refusal = Assert.Throws<ArgumentException>(() => OptionsJson.Write(Sample with { MinScale = double.NaN, BaseBodies = null! }));
        Assert.StartsWith("the options cannot be written:\nminScale = NaN; expected 0.05..20\nbaseBodies = null; ", refusal.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => OptionsJson.Write(null!));
        Assert.Throws<ArgumentNullException>(() => OptionsJson.Read((string)null!));
    }

    [Fact]
    public void Every_value_of_the_enumerations_has_a_name()
    {
        foreach (RequestedKind kind in Enum.GetValues<RequestedKind>())
        {
            Assert.Equal(kind, OptionsJson.Read(OptionsJson.Write(new CreatureOptions { Kind = kind })).GetOptions().Kind);
        }

        foreach (PaletteMood palette in Enum.GetValues<PaletteMood>())
        {
            Assert.Equal(palette, OptionsJson.Read(OptionsJson.Write(new CreatureOptions { Palette = palette })).GetOptions().Palette);
        }

        foreach (OrnamentLevel level in Enum.GetValues<OrnamentLevel>())
        {
            Assert.Equal(level, OptionsJson.Read(OptionsJson.Write(new CreatureOptions { Ornaments = level })).GetOptions().Ornaments);
        }
    }
}
