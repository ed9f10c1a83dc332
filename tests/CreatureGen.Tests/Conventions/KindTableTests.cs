using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Rigging;
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

        Assert.True(tables.Count >= 5, $"only {tables.Count} tables found");
        Assert.True(silent.Count == 0, "tables of kinds with a default; expected every kind, and an exception for others: " + string.Join(", ", silent));
    }

    [Fact]
    public void Every_kind_of_leg_is_one_file_and_whoever_asks_for_something_of_it_finds_it()
    {
        LimbArchetype[] kinds = Enum.GetValues<LimbArchetype>();
        Assert.Equal(kinds, LegKinds.All.ToArray().Select(kind => kind.Archetype));
        IReadOnlyList<string> files = RepositoryFiles.Below("src/CreatureGen/Anatomy/Legs", "*.cs");
        Assert.All(kinds, kind => Assert.Single(files, file => RepositoryFiles.Text(file).Contains($"        LimbArchetype.{kind},\n", StringComparison.Ordinal)));

        Action<LimbArchetype>[] tables =
        [
            kind => LegKinds.Of(kind),
            kind => LegGaitParameters.Of(kind),
            .. new[] { JointRole.Hip, JointRole.Knee, JointRole.Ankle, JointRole.Ball }.Select(role => (Action<LimbArchetype>)(kind => JointLimits.Leg(kind, role))),
        ];
        foreach (Action<LimbArchetype> table in tables)
        {
            Assert.All(kinds, kind => table(kind));
            Assert.Throws<ArgumentOutOfRangeException>(() => table((LimbArchetype)99));
        }
    }

    [Fact]
    public void Nobody_asks_whether_a_leg_is_of_one_kind_instead_of_what_it_is_like()
    {
        var asked = new List<string>();
        foreach (string path in RepositoryFiles.Below("src/CreatureGen", "*.cs"))
        {
            string text = RepositoryFiles.Text(path);
            asked.AddRange(Comparison().Matches(text).Select(match => $"{path}:{text[..match.Index].Count(letter => letter == '\n') + 1}"));
        }

        Assert.True(asked.Count == 0, "comparisons with single kinds of legs; expected a trait of LegKind: " + string.Join(", ", asked));
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

    [GeneratedRegex(@"(?:[=!]=|\b(?:is|or|not|case))\s+\(?(?:Anatomy\.)?LimbArchetype\.|\bLimbArchetype\.\w+ =>")]
    private static partial Regex Comparison();

    [GeneratedRegex(@"^\s*_ => (?!throw)", RegexOptions.Multiline)]
    private static partial Regex Default();
}
