using System;
using System.Globalization;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Repairs;

namespace CreatureGen.Lab.Runtime;

/// <summary>Blueprints with numbers of five digits: an address holds them whole, and nobody sees the difference. Children are born with such numbers, so that their addresses bring back the very same creature.</summary>
internal static class ShortNumbers
{
    public static CreatureBlueprint Of(CreatureBlueprint blueprint)
    {
        CreatureBlueprint? rounded = BlueprintJson.Read(Rewrite(BlueprintJson.Write(blueprint), Shorten)).Blueprint;
        if (rounded == null)
        {
            return blueprint;
        }

        RepairReport report = BlueprintRepair.Repair(rounded);
        return report.Changes.Count == 0 && report.IsSound ? rounded : blueprint;
    }

    /// <summary>The same text without the blanks that only people need.</summary>
    public static string WithoutBlanks(string json) => Rewrite(json, static number => number);

    /// <summary>Goes through JSON text: strings stay, blanks go, numbers are rewritten.</summary>
    private static string Rewrite(string json, Func<string, string> number)
    {
        var text = new StringBuilder(json.Length);
        for (int i = 0; i < json.Length;)
        {
            char c = json[i];
            int end = i + 1;
            if (c == '"')
            {
                while (json[end] != '"')
                {
                    end += json[end] == '\\' ? 2 : 1;
                }

                end++;
                text.Append(json, i, end - i);
            }
            else if (c == '-' || char.IsAsciiDigit(c))
            {
                while (end < json.Length && (char.IsAsciiDigit(json[end]) || json[end] is '.' or 'e' or 'E' or '-' or '+'))
                {
                    end++;
                }

                text.Append(number(json[i..end]));
            }
            else if (!char.IsWhiteSpace(c))
            {
                text.Append(c);
            }

            i = end;
        }

        return text.ToString();
    }

    private static string Shorten(string number) => number.Contains('.', StringComparison.Ordinal)
        ? double.Parse(number, CultureInfo.InvariantCulture).ToString("G5", CultureInfo.InvariantCulture)
        : number;
}
