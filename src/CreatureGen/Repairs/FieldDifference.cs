using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Blueprints;
using CreatureGen.Json;

namespace CreatureGen.Repairs;

/// <summary>A field in which two blueprints differ.</summary>
/// <param name="Path">The field, as in the text of a blueprint.</param>
/// <param name="From">The value in the first.</param>
/// <param name="To">The value in the second.</param>
internal sealed record FieldDifference(string Path, string From, string To)
{
    private const string There = "there";
    private const string LeftOut = "left out";

    /// <summary>All fields in which two blueprints differ, in the order of their text. Lists of different lengths are one difference.</summary>
    public static IReadOnlyList<FieldDifference> Between(CreatureBlueprint first, CreatureBlueprint second)
    {
        var found = new List<FieldDifference>();
        Compare("", ValueOf(first), ValueOf(second), found);
        return found;
    }

    private static string Under(string path, string name) => path.Length > 0 ? path + "." + name : name;

    private static JsonValue ValueOf(CreatureBlueprint blueprint) => JsonReader.Read(blueprint.ToString(), JsonLimits.Document).Root!;

    private static void Compare(string path, JsonValue first, JsonValue second, List<FieldDifference> found)
    {
        if (first.Kind == JsonKind.Object)
        {
            foreach (JsonMember member in first.Members)
            {
                string own = Under(path, member.Name);
                if (second.TryGet(member.Name, out JsonValue? other))
                {
                    Compare(own, member.Value, other!, found);
                }
                else
                {
                    found.Add(new FieldDifference(own, There, LeftOut));
                }
            }

            foreach (JsonMember member in second.Members)
            {
                if (!first.TryGet(member.Name, out _))
                {
                    found.Add(new FieldDifference(Under(path, member.Name), LeftOut, There));
                }
            }
        }
        else if (first.Kind == JsonKind.Array && first.Items.Count == second.Items.Count)
        {
            for (int i = 0; i < first.Items.Count; i++)
            {
                Compare(path + "[" + i.ToString(CultureInfo.InvariantCulture) + "]", first.Items[i], second.Items[i], found);
            }
        }
        else if (first.Kind == JsonKind.Array)
        {
            found.Add(new FieldDifference(path, FieldChecker.CountOf(first.Items.Count), FieldChecker.CountOf(second.Items.Count)));
        }
        else if (!string.Equals(first.Text, second.Text, StringComparison.Ordinal))
        {
            found.Add(new FieldDifference(path, first.Text, second.Text));
        }
    }
}
