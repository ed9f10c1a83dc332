using System;
using System.Collections.Generic;
using System.IO;
using CreatureGen.Console.Arguments;
using CreatureGen.Inspection;

namespace CreatureGen.Console.Text;

/// <summary>How different creatures are, as text and as JSON. The names of the JSON are a contract.</summary>
internal static class VarietyText
{
    private const int ShownPairs = 5;

    /// <summary>Writes it for people.</summary>
    public static void Write(TextWriter output, VarietyReport report, IReadOnlyList<Specimen> added)
    {
        output.WriteLine(FormattableString.Invariant($"creatures                        {report.Count}"));
        output.WriteLine(FormattableString.Invariant($"with a double                    {100 * report.TwinFraction:0.0} %"));
        output.WriteLine(FormattableString.Invariant($"groups of doubles and singles    {report.Clusters}"));
        output.WriteLine(FormattableString.Invariant($"combinations of body, plan, limbs, effective {report.EffectiveCombinations:0}"));
        output.WriteLine(FormattableString.Invariant($"  with heads                     {report.EffectiveWithHeads:0}"));
        output.WriteLine(FormattableString.Invariant($"of no animal's name              {100 * report.ChimeraFraction:0.0} %"));
        for (int i = 0; i < Math.Min(ShownPairs, report.Nearest.Count); i++)
        {
            LikePair pair = report.Nearest[i];
            output.WriteLine(FormattableString.Invariant($"most alike: {added[pair.First].Name} and {added[pair.Second].Name}, {pair.Likeness:0.00}"));
        }
    }

    /// <summary>Writes it for programs.</summary>
    public static void WriteJson(TextWriter output, VarietyReport report, IReadOnlyList<Specimen> added) => output.Write(JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteNumber("count", report.Count);
        json.WriteNumber("twinShare", report.TwinFraction);
        json.WriteNumber("effectiveCombinations", report.EffectiveCombinations);
        json.WriteNumber("effectiveWithHeads", report.EffectiveWithHeads);
        json.WriteNumber("chimeraShare", report.ChimeraFraction);
        json.WriteNumber("clusters", report.Clusters);
        json.WriteStartArray("nearest");
        foreach (LikePair pair in report.Nearest)
        {
            json.WriteStartObject();
            json.WriteString("first", SeedText.Of(added[pair.First].Seed));
            json.WriteString("second", SeedText.Of(added[pair.Second].Seed));
            json.WriteNumber("likeness", pair.Likeness);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }));
}
