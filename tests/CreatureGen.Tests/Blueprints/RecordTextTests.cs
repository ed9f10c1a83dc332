using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Reflection;
using System.Runtime.CompilerServices;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Blueprints;

public sealed class RecordTextTests
{
    [Theory]
    [InlineData("tr-TR")]
    [InlineData("ar-SA")]
    [InlineData("de-DE")]
    [InlineData("fa-IR")]
    public void Records_print_and_are_written_and_read_alike_in_every_culture(string culture)
    {
        CultureInfo before = CultureInfo.CurrentCulture;
        CreatureBlueprint original = Samples.Small with { Head = Samples.Small.Head with { Mouth = new MouthBlueprint(8, 0.5, -0.25, 0.1) } };
        string text = BlueprintJson.Write(original);
        string line = original.ToString();
        string list = new ValueList<double>(new[] { -1.5, 1000000.25 }).ToString();
        string problem = BlueprintJson.Read(text.Replace("-0.25", "-1.25", StringComparison.Ordinal)).Problems.Single().ToString();
        string options = CreatureOptions.Default.ToString();
        try
        {
            CultureInfo.CurrentCulture = CultureInfo.GetCultureInfo(culture);
            Assert.NotEqual("-1.5", (-1.5).ToString("0.0", CultureInfo.CurrentCulture));
            Assert.Equal(text, BlueprintJson.Write(original));
            Assert.Equal(line, original.ToString());
            Assert.Equal(list, new ValueList<double>(new[] { -1.5, 1000000.25 }).ToString());
            Assert.Equal(original, BlueprintJson.Read(text).Blueprint);
            Assert.Equal(problem, BlueprintJson.Read(text.Replace("-0.25", "-1.25", StringComparison.Ordinal)).Problems.Single().ToString());
            Assert.Equal(options, CreatureOptions.Default.ToString());
        }
        finally
        {
            CultureInfo.CurrentCulture = before;
        }
    }

    [Fact]
    public void A_record_prints_as_its_JSON_on_one_line()
    {
        Assert.Equal("""{ "width": 1, "height": 0.30000000000000004, "length": -2 }""", new LatticeSlice(1, 0.1 + 0.2, -2).ToString());
        Assert.Equal("""[{ "lightness": 0.5, "chroma": 0, "hue": 1 }]""", new ValueList<ColourBlueprint>(new[] { new ColourBlueprint(0.5, 0, 1) }).ToString());
        Assert.Equal("[]", ValueList<ColourBlueprint>.Empty.ToString());
        Assert.Equal(Samples.Small, BlueprintJson.Read(Samples.Small.ToString()).Blueprint);
        Assert.DoesNotContain('\n', Samples.Small.ToString());
    }

    [Fact]
    public void Printing_never_fails()
    {
        Assert.Equal("""{ "lightness": "NaN", "chroma": "-Infinity", "hue": 0 }""", new ColourBlueprint(double.NaN, double.NegativeInfinity, 0).ToString());
        Assert.Equal("""{ "name": "\\ud800", "torso": 0, "head": 1, "tail": 0 }""", new MixedBody("\ud800", 0, 1, 0).ToString());
        Assert.StartsWith("""{ "bumps": null, "muzzleSquareness": 1, "eyes": null, """, new HeadBlueprint(null!, 1, null!, null!, 0).ToString(), StringComparison.Ordinal);
        Assert.Contains("an undefined value", new TailBlueprint((Anatomy.TailStyle)77, 0, 0).ToString(), StringComparison.Ordinal);
    }

    [Fact]
    public void Every_record_of_a_blueprint_prints_itself()
    {
        IEnumerable<Type> records = typeof(CreatureBlueprint).Assembly.GetTypes()
            .Where(type => type.Namespace is "CreatureGen.Blueprints" or "CreatureGen.Sampling" && type.IsPublic && type.GetMethod("<Clone>$") is not null);
        Assert.Equal(33, records.Count());
        foreach (Type record in records)
        {
            MethodInfo print = record.GetMethod(nameof(ToString), Type.EmptyTypes)!;
            Assert.False(print.IsDefined(typeof(CompilerGeneratedAttribute), false), record.Name + " prints its numbers by culture");
        }
    }
}
