using System;
using System.Text.RegularExpressions;
using CreatureGen.Blueprints;
using CreatureGen.Json;
using CreatureGen.Tests.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Saves;

public sealed class BlueprintFormatTests
{
    [Fact]
    public void Text_of_format_1_had_one_number_for_format_and_algorithm()
    {
        string old = Without(BlueprintJson.Write(Samples.Small), "algorithm").Replace($"\"version\": {BlueprintJson.FormatVersion}", "\"version\": 1", StringComparison.Ordinal);
        old = Regex.Replace(old, ",\\s*\"(foot\": \"plain|style\": \"blade)\"", "");
        CreatureBlueprint read = BlueprintJson.Read(old).GetBlueprint();
        Assert.Equal(1, read.Algorithm);
        Assert.Equal(Samples.Small, read with { Algorithm = CreatureBlueprint.CurrentAlgorithm });
    }

    [Fact]
    public void The_algorithm_of_a_blueprint_is_kept_and_only_later_ones_are_refused()
    {
        CreatureBlueprint old = Samples.Small with { Algorithm = 1 };
        Assert.Equal(old, BlueprintJson.Read(BlueprintJson.Write(old)).Blueprint);
        CreatureBlueprint future = Samples.Small with { Algorithm = CreatureBlueprint.CurrentAlgorithm + 1 };
        Assert.StartsWith("algorithm = ", Assert.Single(BlueprintJson.Read(BlueprintJson.Write(future)).Problems).ToString(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData(1, "{}", 0.25, 0)]
    [InlineData(2, "{}", 0.25, 1)]
    [InlineData(2, "{\"young\": 3}", 3, 0)]
    [InlineData(1, "{\"young\": 3}", 0.25, 1)]
    public void A_field_younger_than_the_text_has_its_default_and_is_not_expected_there(int format, string text, double value, int problems)
    {
        var list = new ProblemList("");
        JsonValue source = JsonReader.Read(text, JsonLimits.Document).Root!;
        Assert.Equal(new Grown(value), FieldReader.Read(source, Grown.Fields, format, MissingField.Reported, list));
        Assert.Equal(problems, list.All.Count);
    }

    [Theory]
    [InlineData(1, 0.25, 0)]
    [InlineData(2, 0.25, 1)]
    public void The_same_holds_within_lists(int format, double value, int problems)
    {
        var list = new ProblemList("");
        JsonValue source = JsonReader.Read("{\"items\": [{}]}", JsonLimits.Document).Root!;
        Assert.Equal(new Grown(value), FieldReader.Read(source, Herd.Fields, format, MissingField.Reported, list).Items[0]);
        Assert.Equal(problems, list.All.Count);
    }

    private static string Without(string text, string field)
    {
        int start = text.IndexOf($"  \"{field}\"", StringComparison.Ordinal);
        return text.Remove(start, text.IndexOf('\n', start) + 1 - start);
    }

    /// <summary>A record with a field that came with format 2.</summary>
    private sealed record Grown(double Young)
    {
        public static readonly RecordDescription<Grown> Fields = new(
            new Grown(0.25),
            JsonLayout.Line,
            (visit, grown) => new Grown(visit.Since(2).Number("young", grown.Young, new NumberRange(0, 10))));
    }

    private sealed record Herd(ValueList<Grown> Items)
    {
        public static readonly RecordDescription<Herd> Fields = new(
            new Herd(ValueList<Grown>.Empty),
            JsonLayout.Line,
            (visit, herd) => new Herd(visit.List("items", herd.Items, new WholeRange(0, 3), Grown.Fields)));
    }
}
