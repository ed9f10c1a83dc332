using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Anatomy;
using CreatureGen.Motion.Flying;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
using CreatureGen.Sampling.Placement;
using Xunit;

namespace CreatureGen.Tests.Conventions;

/// <summary>Who adds a kind of limb or of ornament is told of every table that does not know it yet.</summary>
public sealed partial class KindTableTests
{
    private static readonly string[] kinds = [nameof(LimbKind), nameof(LimbArchetype), nameof(FeatureKind)];

    [Fact]
    public void No_table_of_kinds_has_a_silent_default()
    {
        var tables = new List<string>();
        var silent = new List<string>();
        foreach (string path in RepositoryFiles.Below("src/CreatureGen", "*.cs"))
        {
            string text = RepositoryFiles.Text(path);
            foreach (Match start in Switch().Matches(text))
            {
                string table = Block(text, start.Index + start.Length);
                if (kinds.Any(kind => Regex.IsMatch(table, $@"^\s*{kind}\.\w+[^=\n]*=>", RegexOptions.Multiline)))
                {
                    string place = $"{path}:{text[..start.Index].Count(letter => letter == '\n') + 1}";
                    tables.Add(place);
                    if (Default().IsMatch(table))
                    {
                        silent.Add(place);
                    }
                }
            }
        }

        Assert.True(tables.Count >= 8, $"only {tables.Count} tables found");
        Assert.True(silent.Count == 0, "tables of kinds with a default; expected every kind, and an exception for others: " + string.Join(", ", silent));
    }

    [Fact]
    public void Every_table_of_legs_knows_every_built_form()
    {
        Action<LimbArchetype>[] tables =
        [
            form => LegPosture.Tucked(form),
            form => LegPosture.Hanging(form),
            form => LegPosture.Reaching(form),
            form => LegBuild.Of(form),
            form => LegGaitParameters.Of(form),
            .. new[] { JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball }.Select(role => (Action<LimbArchetype>)(form => JointLimits.Leg(form, role))),
        ];
        foreach (Action<LimbArchetype> table in tables)
        {
            Assert.All(Enum.GetValues<LimbArchetype>(), form => table(form));
            Assert.Throws<ArgumentOutOfRangeException>(() => table((LimbArchetype)99));
        }
    }

    /// <summary>What is between the brace before a place and the one that closes it.</summary>
    private static string Block(string text, int begin)
    {
        int depth = 1;
        int end = begin;
        while (depth > 0)
        {
            depth += text[end] == '{' ? 1 : text[end] == '}' ? -1 : 0;
            end++;
        }

        return text[begin..end];
    }

    [GeneratedRegex(@"\bswitch\s*\{")]
    private static partial Regex Switch();

    [GeneratedRegex(@"^\s*_ => (?!throw)", RegexOptions.Multiline)]
    private static partial Regex Default();
}
