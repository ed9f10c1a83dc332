using System;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class BlueprintReadingTests
{
    private static readonly string Good = BlueprintJson.Write(Samples.Small);

    [Theory]
    [InlineData("\"scale\": 1.25", "\"scale\": 20.5", "scale = 20.5; expected 0.05..20 (line 7, column 12)")]
    [InlineData("\"scale\": 1.25", "\"scale\": 1e999", "scale = 1e999; expected 0.05..20 (line 7, column 12)")]
    [InlineData("\"scale\": 1.25", "\"scale\": \"big\"", "scale = \"big\"; expected 0.05..20 (line 7, column 12)")]
    [InlineData("\"scale\": 1.25", "\"scale\": null", "scale = null; expected 0.05..20 (line 7, column 12)")]
    [InlineData("\"scale\": 1.25", "\"scale\": [1.25]", "scale = an array; expected 0.05..20 (line 7, column 12)")]
    [InlineData("\"scale\": 1.25", "\"scale\": {}", "scale = an object; expected 0.05..20 (line 7, column 12)")]
    [InlineData("\"scale\": 1.25", "\"scale\": true", "scale = true; expected 0.05..20 (line 7, column 12)")]
    [InlineData("\"scale\": 1.25,", "", "scale = nothing; expected 0.05..20 (line 1, column 1)")]
    [InlineData("\"scale\": 1.25", "\"scale\": 1.25, \"size\": 2", "size = 2; expected no field of this name; there are version, algorithm, seed, kind, plan, scale, triangleBudget, body, head, tail, legs, wings, insectWings, fins, ears, features, manes, frills, coat, lineage, fork (line 7, column 26)")]
    [InlineData("\"kind\": \"flying\"", "\"kind\": \"Flying\"", "kind = \"Flying\"; expected one of walking, flying, swimming (line 5, column 11)")]
    [InlineData("\"kind\": \"flying\"", "\"kind\": 1", "kind = 1; expected one of walking, flying, swimming (line 5, column 11)")]
    [InlineData("\"kind\": \"flying\",", "", "kind = nothing; expected one of walking, flying, swimming (line 1, column 1)")]
    [InlineData("\"ring\": 39,", "\"ring\": 39.5,", "legs[1].socket.ring = 39.5; expected a whole number 1..52 (line 102, column 27)")]
    [InlineData("\"ring\": 39,", "\"ring\": 3000000000,", "legs[1].socket.ring = 3000000000; expected a whole number 1..52 (line 102, column 27)")]
    [InlineData("\"ring\": 39,", "\"ring\": 53,", "legs[1].socket.ring = 53; expected a whole number 1..52 (line 102, column 27)")]
    [InlineData("\"ring\": 39, \"segment\": 8, \"rows\": 4", "\"ring\": 39, \"segment\": 8, \"rows\": 3", "legs[1].socket.rows = 3; expected an even number 2..22 (line 102, column 53)")]
    [InlineData("\"face\": \"canine\"", "\"face\": \"unicorn\"", "body.blend.face = \"unicorn\"; expected one of canine, bovine, feline, reptile, avian, fish, insect, serpent, amphibian, beetle, ant, wasp, mantis, hopper, spider, centipede, butterfly, dragonfly, bee, moth, shark, ray, angler, turtle, plesiosaur, crocodile, seal, newt, eel, dolphin, puffer, swordfish, duck, raptor, ostrich, parrot, heron, owl, penguin, toucan, frog, cobra, lion, hyena, boar, horse, bison, camel, bear, rhino, rabbit, bat, pterosaur, ceratops, lizard, hedgehog, rooster (line 14, column 15)")]
    [InlineData("\"ears\": [", "\"ears\": [{}, {}, ", "ears = 3 elements; expected an array of 0..2 elements (line 149, column 11)")]
    [InlineData("\"fork\": 1.5", "\"fork\": 1.5, \"fork\": 1.5", "tail.fork = a second member of this name; expected one (line 80, column 57)")]
    public void A_wrong_field_is_reported_with_its_path_and_place(string good, string bad, string problem)
    {
        Assert.Equal(problem, Assert.Single(ReadChanged(good, bad).Problems).ToString());
    }

    [Theory]
    [InlineData("18446744073709551616")]
    [InlineData("99999999999999999999999")]
    [InlineData("-1")]
    [InlineData("+1")]
    [InlineData("007")]
    [InlineData("")]
    [InlineData(" 1")]
    [InlineData("1.0")]
    [InlineData("٣")]
    public void A_seed_is_digits_within_64_bits(string seed)
    {
        Problem problem = Assert.Single(ReadChanged("18446744073709551615", seed).Problems);
        Assert.Equal("seed", problem.Path);
        Assert.Equal("a string of the decimal digits of a number 0..18446744073709551615", problem.Expectation);
    }

    [Fact]
    public void A_seed_that_is_a_number_is_reported()
    {
        Assert.Equal("seed", Assert.Single(ReadChanged("\"18446744073709551615\"", "42").Problems).Path);
        Assert.Equal(0UL, ReadChanged("18446744073709551615", "0").GetBlueprint().Seed);
    }

    [Fact]
    public void All_problems_are_told_at_once_in_the_order_of_the_text()
    {
        string text = Good
            .Replace("\"scale\": 1.25", "\"scale\": -1", StringComparison.Ordinal)
            .Replace("\"opening\": 0.1", "\"opening\": 7", StringComparison.Ordinal)
            .Replace("\"droop\": 0", "\"drop\": 0", StringComparison.Ordinal)
            .Replace("\"patternSeed\": 0", "\"patternSeed\": -1", StringComparison.Ordinal);
        BlueprintReading reading = BlueprintJson.Read(text);
        Assert.Null(reading.Blueprint);
        Assert.Equal(new[] { "scale", "head.mouth.opening", "ears[0].droop", "ears[0].drop", "coat.patternSeed" }, reading.Problems.Select(problem => problem.Path));
        string message = Assert.Throws<InvalidOperationException>(reading.GetBlueprint).Message;
        Assert.All(reading.Problems, problem => Assert.Contains(problem.ToString(), message, StringComparison.Ordinal));
    }

    [Theory]
    [InlineData("999999", ", this text is for a newer version of the library")]
    [InlineData("1e300", ", this text is for a newer version of the library")]
    [InlineData("0", "")]
    [InlineData("1.5", "")]
    public void An_unknown_format_is_one_problem_whatever_the_rest_holds(string version, string reason)
    {
        string text = WithVersion(version).Replace("\"scale\"", "\"size\"", StringComparison.Ordinal);
        Assert.Equal($"version = {version}; expected {BlueprintFormat.Range}{reason} (line 2, column 14)", Assert.Single(BlueprintJson.Read(text).Problems).ToString());
    }

    [Theory]
    [InlineData("\"1\"")]
    [InlineData("null")]
    [InlineData("[1]")]
    public void A_format_that_is_no_number_is_reported(string version)
    {
        Assert.Equal("version", Assert.Single(BlueprintJson.Read(WithVersion(version)).Problems).Path);
    }

    [Fact]
    public void Numbers_may_be_written_in_any_way_that_means_the_same()
    {
        Assert.Equal(Samples.Small, ReadChanged("\"scale\": 1.25", "\"scale\": 12.50e-1").Blueprint);
        Assert.Equal(Samples.Small, ReadChanged("\"ring\": 39,", "\"ring\": 3.9e1,").Blueprint);
    }

    [Theory]
    [InlineData("", "blueprint = the end of the text; expected a value (line 1, column 1)")]
    [InlineData("[]", "blueprint = an array; expected an object (line 1, column 1)")]
    [InlineData("null", "blueprint = null; expected an object (line 1, column 1)")]
    [InlineData("{\"version\": 1", "blueprint = the end of the text; expected ',' or '}' (line 1, column 14)")]
    public void What_is_no_object_is_one_problem(string text, string problem)
    {
        Assert.Equal(problem, Assert.Single(BlueprintJson.Read(text).Problems).ToString());
    }

    [Fact]
    public void An_empty_object_lacks_every_field()
    {
        Assert.Equal(19, BlueprintJson.Read("{}").Problems.Count);
    }

    [Fact]
    public void Text_that_is_too_long_is_reported_unread()
    {
        string expected = "blueprint = a longer text; expected at most 4194304 bytes (line 1, column 1)";
        string padding = new(' ', BlueprintJson.MaximumBytes - Good.Length);
        Assert.Equal(Samples.Small, BlueprintJson.Read(Good + padding).Blueprint);
        Assert.Equal(expected, Assert.Single(BlueprintJson.Read(Good + padding + " ").Problems).ToString());
        Assert.Equal(expected, Assert.Single(BlueprintJson.Read(new MemoryStream(new byte[5 << 20])).Problems).ToString());
    }

    [Fact]
    public void Lists_without_end_and_deep_nesting_are_reported_and_not_followed()
    {
        string elements = string.Concat(Enumerable.Repeat("0,", 90_000)) + "0";
        Assert.Equal("ears = 90001 elements; expected an array of 0..2 elements", Sentence(ReadChanged("\"wings\": [", "\"ears\": [" + elements + "], \"wings\": [", "\"ears\": [\n", "\"unused\": [\n")));
        Assert.EndsWith("expected at most 100000 values (line 1, column 200000)", Assert.Single(BlueprintJson.Read("[" + string.Concat(Enumerable.Repeat("0,", 200_000))).Problems).ToString(), StringComparison.Ordinal);
        Assert.EndsWith("at most 64 levels (line 1, column 65)", Assert.Single(BlueprintJson.Read(new string('[', 1_000_000)).Problems).ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void No_more_than_a_thousand_problems_are_kept()
    {
        string unknown = string.Concat(Enumerable.Range(0, 5000).Select(i => $"\"x{i}\":0,"));
        Assert.Equal(ProblemList.Maximum, BlueprintJson.Read("{" + unknown + Good[1..]).Problems.Count);
    }

    [Fact]
    public void Parts_that_do_not_fit_together_are_reported_when_each_part_alone_is_good()
    {
        Problem problem = Assert.Single(ReadChanged("\"kind\": \"flying\"", "\"kind\": \"walking\"").Problems);
        Assert.Equal("plan = flapping; expected a plan of a walking creature", problem.ToString());
    }

    [Fact]
    public void Null_is_refused()
    {
        Assert.Throws<ArgumentNullException>(() => BlueprintJson.Read((string)null!));
        Assert.Throws<ArgumentNullException>(() => BlueprintJson.Read((Stream)null!));
    }

    private static BlueprintReading ReadChanged(params string[] replacements)
    {
        string text = Good;
        for (int i = 0; i < replacements.Length; i += 2)
        {
            Assert.Contains(replacements[i], text, StringComparison.Ordinal);
            text = text.Replace(replacements[i], replacements[i + 1], StringComparison.Ordinal);
        }

        BlueprintReading reading = BlueprintJson.Read(text);
        Assert.Equal(reading.Problems.Count == 0, reading.Blueprint is not null);
        return reading;
    }

    private static string Sentence(BlueprintReading reading)
    {
        string sentence = reading.Problems[0].ToString();
        return sentence[..sentence.IndexOf(" (line", StringComparison.Ordinal)];
    }

    private static string WithVersion(string version) => Good.Replace($"\"version\": {BlueprintJson.FormatVersion}", "\"version\": " + version, StringComparison.Ordinal);
}
