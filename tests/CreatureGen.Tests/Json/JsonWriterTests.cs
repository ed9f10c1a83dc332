using System;
using System.Text;
using System.Text.Json;
using CreatureGen.Json;
using Xunit;

namespace CreatureGen.Tests.Json;

public sealed class JsonWriterTests
{
    [Fact]
    public void Compact_text_has_no_white_space()
    {
        Assert.Equal("""{"name":"wolf","sizes":[1,2.5,-3],"empty":{},"none":[],"tame":false,"owner":null}""", Sample(JsonLayout.Compact));
    }

    [Fact]
    public void A_line_is_spaced_for_the_eye()
    {
        Assert.Equal("""{ "name": "wolf", "sizes": [1, 2.5, -3], "empty": {}, "none": [], "tame": false, "owner": null }""", Sample(JsonLayout.Line));
    }

    [Fact]
    public void Indented_text_ends_lines_with_line_feeds_alone()
    {
        Assert.Equal(
            "{\n  \"name\": \"wolf\",\n  \"sizes\": [\n    1,\n    2.5,\n    -3\n  ],\n  \"empty\": {},\n  \"none\": [],\n  \"tame\": false,\n  \"owner\": null\n}",
            Sample(JsonLayout.Indented));
    }

    [Fact]
    public void A_line_object_stays_on_one_line_of_indented_text()
    {
        JsonWriter writer = new JsonWriter(JsonLayout.Indented).BeginArray();
        writer.BeginLineObject().Name("a").Number(1).Name("b").BeginArray().Number(2).Number(3).EndArray().EndObject();
        writer.BeginLineArray().BeginObject().EndObject().EndArray().EndArray();
        Assert.Equal("[\n  { \"a\": 1, \"b\": [2, 3] },\n  [{}]\n]", writer.ToString());
    }

    [Fact]
    public void The_framework_reads_the_same_values_in_every_layout()
    {
        foreach (JsonLayout layout in new[] { JsonLayout.Compact, JsonLayout.Line, JsonLayout.Indented })
        {
            using JsonDocument document = JsonDocument.Parse(Sample(layout));
            Assert.Equal("wolf", document.RootElement.GetProperty("name").GetString());
            Assert.Equal(2.5, document.RootElement.GetProperty("sizes")[1].GetDouble());
        }
    }

    [Fact]
    public void Text_is_escaped_only_where_it_must_be()
    {
        string awkward = "\"\\/\b\f\n\r\t\u0000\u001f\u007f é ß \u2028 日本 🦊";
        string json = new JsonWriter(JsonLayout.Compact).Text(awkward).ToString();
        Assert.Equal("\"\\\"\\\\/\\b\\f\\n\\r\\t\\u0000\\u001f\u007f é ß \u2028 日本 🦊\"", json);
        Assert.Equal(awkward, JsonDocument.Parse(json).RootElement.GetString());
    }

    [Fact]
    public void Half_of_a_surrogate_pair_is_refused()
    {
        Assert.Throws<ArgumentException>(() => Writer().Text("\ud800"));
        Assert.Throws<ArgumentException>(() => Writer().Text("a\udc00b"));
        Assert.Throws<ArgumentException>(() => Writer().BeginObject().Name("\ud83d\ud83d\ude00"));
    }

    [Fact]
    public void Bytes_are_the_text_in_UTF_8_without_a_mark()
    {
        JsonWriter writer = new JsonWriter(JsonLayout.Compact).BeginArray().Text("é🦊").Number(0.1f).EndArray();
        byte[] expected = Encoding.UTF8.GetBytes("[\"é🦊\",0.1]");
        Assert.Equal(expected, writer.Utf8.ToArray());
    }

    [Fact]
    public void Numbers_that_JSON_has_not_are_refused()
    {
        Assert.Throws<ArgumentException>(() => new JsonWriter(JsonLayout.Compact).Number(double.NaN));
        Assert.Throws<ArgumentException>(() => new JsonWriter(JsonLayout.Compact).Number(float.PositiveInfinity));
    }

    [Fact]
    public void Calls_that_give_no_JSON_are_refused()
    {
        Assert.Throws<InvalidOperationException>(() => Writer().BeginObject().Number(1));
        Assert.Throws<InvalidOperationException>(() => Writer().BeginArray().Name("a"));
        Assert.Throws<InvalidOperationException>(() => Writer().Name("a"));
        Assert.Throws<InvalidOperationException>(() => Writer().BeginObject().Name("a").Name("b"));
        Assert.Throws<InvalidOperationException>(() => Writer().BeginObject().Name("a").EndObject());
        Assert.Throws<InvalidOperationException>(() => Writer().BeginObject().EndArray());
        Assert.Throws<InvalidOperationException>(() => Writer().EndArray());
        Assert.Throws<InvalidOperationException>(() => Writer().Number(1).Number(2));
        Assert.Throws<InvalidOperationException>(() => Writer().BeginObject().Utf8.ToArray());
        Assert.Throws<InvalidOperationException>(() => Writer().Utf8.ToArray());
        Assert.Throws<ArgumentNullException>(() => Writer().Text(null!));
    }

    [Fact]
    public void Nesting_stops_where_a_reader_would()
    {
        JsonWriter writer = Writer();
        for (int i = 0; i < JsonLimits.MaximumDepth; i++)
        {
            writer.BeginArray();
        }

        Assert.Throws<InvalidOperationException>(() => writer.BeginArray());
        for (int i = 0; i < JsonLimits.MaximumDepth; i++)
        {
            writer.EndArray();
        }

        Assert.Empty(JsonReader.Read(writer.Utf8.ToArray(), JsonLimits.Document).Problems);
    }

    private static JsonWriter Writer() => new(JsonLayout.Compact);

    private static string Sample(JsonLayout layout) => new JsonWriter(layout)
        .BeginObject()
        .Name("name").Text("wolf")
        .Name("sizes").BeginArray().Number(1).Number(2.5).Number(-3).EndArray()
        .Name("empty").BeginObject().EndObject()
        .Name("none").BeginArray().EndArray()
        .Name("tame").Boolean(false)
        .Name("owner").Null()
        .EndObject()
        .ToString();
}
