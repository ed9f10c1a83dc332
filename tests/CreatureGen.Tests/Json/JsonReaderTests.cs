using System;
using System.Linq;
using System.Text;
using System.Text.Json;
using CreatureGen.Json;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Json;

public sealed class JsonReaderTests
{
    private const string Sample = """
        {
          "name": "w\u00f6lf \ud83e\udd8a \"é\"",
          "legs": [ { "girth": 1.5e-1 }, { "girth": -0 } ],
          "tame": true, "wild": false, "owner": null,
          "odd name": []
        }
        """;

    [Fact]
    public void Values_know_what_and_where_they_are()
    {
        JsonValue root = Read(Sample);
        Assert.Equal(JsonKind.Object, root.Kind);
        Assert.Equal("wölf 🦊 \"é\"", root["name"].Text);
        JsonValue girth = root["legs"][1]["girth"];
        Assert.Equal("legs[1].girth", girth.Path);
        Assert.Equal("line 3, column 45", girth.Position.ToString());
        Assert.Equal(0.15, root["legs"][0]["girth"].Number);
        Assert.True(root["tame"].IsTrue);
        Assert.False(root["wild"].IsTrue);
        Assert.Equal(JsonKind.Null, root["owner"].Kind);
        Assert.Equal("[\"odd name\"]", root["odd name"].Path);
        Assert.Equal(new[] { "name", "legs", "tame", "wild", "owner", "odd name" }, root.Members.Select(member => member.Name));
    }

    [Fact]
    public void Columns_count_characters_not_bytes()
    {
        Assert.Equal("line 1, column 8", Read("[\"é🦊\", 1]")[1].Position.ToString());
    }

    [Fact]
    public void What_is_not_there_is_named()
    {
        JsonValue root = Read(Sample);
        Assert.Contains("legs[2]", Assert.Throws<InvalidOperationException>(() => root["legs"][2]).Message, StringComparison.Ordinal);
        Assert.Contains("legs[0].length", Assert.Throws<InvalidOperationException>(() => root["legs"][0]["length"]).Message, StringComparison.Ordinal);
        Assert.False(root.TryGet("horns", out JsonValue? horns));
        Assert.Null(horns);
    }

    [Theory]
    [InlineData("", "line 1, column 1: the end of the text; expected a value")]
    [InlineData("  ", "line 1, column 3: the end of the text; expected a value")]
    [InlineData("{", "line 1, column 2: the end of the text; expected a name in quotation marks")]
    [InlineData("{\"a\"", "line 1, column 5: a: the end of the text; expected ':'")]
    [InlineData("{\"a\":", "line 1, column 6: a: the end of the text; expected a value")]
    [InlineData("{\"a\":1", "line 1, column 7: the end of the text; expected ',' or '}'")]
    [InlineData("{\"a\":1,}", "line 1, column 8: '}'; expected a name in quotation marks")]
    [InlineData("{a:1}", "line 1, column 2: a; expected a name in quotation marks")]
    [InlineData("[1,\n 2\n 3]", "line 3, column 2: 3; expected ',' or ']'")]
    [InlineData("[1,]", "line 1, column 4: [1]: ']'; expected a value")]
    [InlineData("[1]]", "line 1, column 4: ']'; expected the end of the text")]
    [InlineData("1 2", "line 1, column 3: 2; expected the end of the text")]
    [InlineData("NaN", "line 1, column 1: NaN; expected a value")]
    [InlineData("nul", "line 1, column 1: nul; expected a value")]
    [InlineData("nullx", "line 1, column 1: nullx; expected a value")]
    [InlineData("True", "line 1, column 1: True; expected a value")]
    [InlineData("-Infinity", "line 1, column 2: Infinity; expected a digit")]
    [InlineData("+1", "line 1, column 1: '+'; expected a value")]
    [InlineData(".5", "line 1, column 1: '.'; expected a value")]
    [InlineData("5.", "line 1, column 3: the end of the text; expected a digit")]
    [InlineData("1e", "line 1, column 3: the end of the text; expected a digit")]
    [InlineData("1e+", "line 1, column 4: the end of the text; expected a digit")]
    [InlineData("-", "line 1, column 2: the end of the text; expected a digit")]
    [InlineData("01", "line 1, column 1: 01; expected a number without leading zeros")]
    [InlineData("-012", "line 1, column 1: '-'; expected a number without leading zeros")]
    [InlineData("0x10", "line 1, column 2: x10; expected the end of the text")]
    [InlineData("'a'", "line 1, column 1: '''; expected a value")]
    [InlineData("// no\n1", "line 1, column 1: '/'; expected a value")]
    [InlineData("\"a", "line 1, column 3: the end of the text; expected '\"'")]
    [InlineData("\"a\nb\"", "line 1, column 3: control character U+000A; expected an escape sequence in place of a control character")]
    [InlineData("\"\\x\"", "line 1, column 2: '\\'; expected an escape sequence of JSON")]
    [InlineData("\"\\u12g4\"", "line 1, column 2: '\\'; expected an escape sequence of JSON")]
    [InlineData("\"\\u12", "line 1, column 2: '\\'; expected an escape sequence of JSON")]
    [InlineData("\"\\", "line 1, column 2: '\\'; expected an escape sequence of JSON")]
    [InlineData("\"\\ud800\"", "line 1, column 2: '\\'; expected both halves of a surrogate pair")]
    [InlineData("\"\\ud800\\u0041\"", "line 1, column 2: '\\'; expected both halves of a surrogate pair")]
    [InlineData("\"é\\udc00\"", "line 1, column 3: '\\'; expected both halves of a surrogate pair")]
    [InlineData("\u00a01", "line 1, column 1: byte 0xC2; expected a value")]
    public void Broken_text_is_reported_where_it_breaks(string text, string problem)
    {
        JsonReading reading = JsonReader.Read(text, JsonLimits.Document);
        Assert.Null(reading.Root);
        Assert.Equal(problem, Assert.Single(reading.Problems).ToString());
    }

    [Fact]
    public void A_lone_surrogate_in_a_string_is_reported_where_it_stands()
    {
        JsonProblem problem = Assert.Single(JsonReader.Read("[1,\n\"é\ud800\"]", JsonLimits.Document).Problems);
        Assert.Equal("line 2, column 3: half of a surrogate pair; expected whole characters", problem.ToString());
    }

    [Theory]
    [InlineData(new byte[] { 0x80 })]
    [InlineData(new byte[] { 0xC0, 0xAF })]
    [InlineData(new byte[] { 0xC1, 0xBF })]
    [InlineData(new byte[] { 0xC3 })]
    [InlineData(new byte[] { 0xC3, 0x28 })]
    [InlineData(new byte[] { 0xE0, 0x9F, 0xBF })]
    [InlineData(new byte[] { 0xED, 0xA0, 0x80 })]
    [InlineData(new byte[] { 0xF0, 0x8F, 0xBF, 0xBF })]
    [InlineData(new byte[] { 0xF4, 0x90, 0x80, 0x80 })]
    [InlineData(new byte[] { 0xF5, 0x80, 0x80, 0x80 })]
    [InlineData(new byte[] { 0xFF })]
    public void What_is_not_UTF_8_is_reported(byte[] bytes)
    {
        byte[] text = [(byte)'"', .. bytes, (byte)'"'];
        JsonProblem problem = Assert.Single(JsonReader.Read(text, JsonLimits.Document).Problems);
        Assert.Equal(FormattableString.Invariant($"line 1, column 2: byte 0x{bytes[0]:X2}; expected UTF-8"), problem.ToString());
    }

    [Fact]
    public void A_byte_order_mark_is_passed_over()
    {
        Assert.Equal(7, JsonReader.Read([0xEF, 0xBB, 0xBF, (byte)'7'], JsonLimits.Document).Root!.Number);
    }

    [Theory]
    [InlineData(2)]
    [InlineData(20)]
    public void A_name_that_is_there_twice_is_reported_and_its_first_value_kept(int others)
    {
        string text = "{\"a\":1," + string.Concat(Enumerable.Range(0, others).Select(i => $"\"n{i}\":0,")) + "\"a\":2}";
        JsonReading reading = JsonReader.Read(text, JsonLimits.Document);
        Assert.Equal("a", Assert.Single(reading.Problems).Path);
        Assert.Equal(1, reading.Root!["a"].Number);
        Assert.Equal(others + 1, reading.Root.Members.Count);
        Assert.True(reading.Root.TryGet("n0", out _));
    }

    [Fact]
    public void A_number_beyond_a_double_is_kept_as_text_and_infinite()
    {
        JsonValue value = Read("1e999");
        Assert.Equal(double.PositiveInfinity, value.Number);
        Assert.Equal("1e999", value.ToString());
    }

    [Theory]
    [InlineData("[", "]")]
    [InlineData("{\"a\":", "}")]
    public void Nesting_has_a_limit(string open, string close)
    {
        string deepest = Repeat(open, JsonLimits.MaximumDepth - 1) + "[]" + Repeat(close, JsonLimits.MaximumDepth - 1);
        Assert.Empty(JsonReader.Read(deepest, JsonLimits.Document).Problems);
        JsonReading reading = JsonReader.Read(Repeat(open, 100_000), JsonLimits.Document);
        Assert.EndsWith("deeper nesting; expected at most 64 levels", Assert.Single(reading.Problems).ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Length_and_number_of_values_have_limits()
    {
        var limits = new JsonLimits(10, 3);
        Assert.Empty(JsonReader.Read("[1,2]     ", limits).Problems);
        Assert.Equal("line 1, column 1: a longer text; expected at most 10 bytes", Assert.Single(JsonReader.Read("[1,2]      ", limits).Problems).ToString());
        Assert.Equal("line 1, column 1: a longer text; expected at most 10 bytes", Assert.Single(JsonReader.Read(new byte[11], limits).Problems).ToString());
        Assert.Equal("line 1, column 6: [2]: more values; expected at most 3 values", Assert.Single(JsonReader.Read("[1,2,3]", limits).Problems).ToString());
    }

    [Fact]
    public void Messages_stay_short_whatever_the_text_is()
    {
        string name = new('n', 1_000_000);
        JsonReading reading = JsonReader.Read("{\"" + name + "\":{\"a\":1,\"a\":2,\"b\":" + name + "}}", JsonLimits.Document);
        Assert.Equal(2, reading.Problems.Count);
        Assert.All(reading.Problems, problem => Assert.True(problem.ToString().Length < 250));
    }

    [Fact]
    public void Every_truncation_of_good_text_is_reported()
    {
        byte[] text = Encoding.UTF8.GetBytes(Sample);
        for (int length = 0; length < text.Length; length++)
        {
            JsonReading reading = JsonReader.Read(text.AsSpan(0, length), JsonLimits.Document);
            Assert.Null(reading.Root);
            Assert.Single(reading.Problems);
        }
    }

    [Fact]
    public void Text_is_taken_or_refused_as_the_framework_does()
    {
        byte[] good = Encoding.UTF8.GetBytes(Sample);
        RandomStream random = new Seed(4).Stream();
        int refused = 0;
        for (int i = 0; i < 20_000; i++)
        {
            byte[] text = (byte[])good.Clone();
            for (int flips = random.Integer(1, 4); flips > 0; flips--)
            {
                text[random.Integer(0, text.Length)] = random.Chance(0.5) ? (byte)random.Integer(0, 256) : good[random.Integer(0, good.Length)];
            }

            JsonReading reading = JsonReader.Read(text, JsonLimits.Document);
            bool framework = IsTakenByFramework(text);
            Assert.True(framework == (reading.Root != null), Encoding.Latin1.GetString(text));
            refused += framework ? 0 : 1;
        }

        Assert.InRange(refused, 5_000, 19_000);
    }

    private static bool IsTakenByFramework(byte[] text)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(text);
            Visit(document.RootElement);
            return true;
        }
        catch (Exception exception) when (exception is JsonException or InvalidOperationException)
        {
            return false;
        }

        // The framework looks into strings only when they are asked for.
        static void Visit(JsonElement element)
        {
            if (element.ValueKind == JsonValueKind.String)
            {
                element.GetString();
            }
            else if (element.ValueKind == JsonValueKind.Array)
            {
                element.EnumerateArray().ToList().ForEach(Visit);
            }
            else if (element.ValueKind == JsonValueKind.Object)
            {
                element.EnumerateObject().ToList().ForEach(member => { _ = member.Name; Visit(member.Value); });
            }
        }
    }

    private static JsonValue Read(string text)
    {
        JsonReading reading = JsonReader.Read(text, JsonLimits.Document);
        Assert.Empty(reading.Problems);
        return reading.Root!;
    }

    private static string Repeat(string text, int count) => string.Concat(Enumerable.Repeat(text, count));
}
