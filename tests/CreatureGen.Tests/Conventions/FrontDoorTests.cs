using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using OnScreen;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed partial class FrontDoorTests
{
    [Fact]
    public void A_program_on_screen_needs_four_namespaces_of_the_library()
    {
        string[] used = UsingLine().Matches(RepositoryFiles.Text("tests/CreatureGen.Tests/Conventions/ProgramOnScreen.cs")).Select(m => m.Groups[1].Value).ToArray();
        Assert.InRange(used.Length, 1, 4);
        (float way, bool drawn) = ProgramOnScreen.Run(101, 120);
        Assert.True(way > 0.1f && drawn, FormattableString.Invariant($"{way} m"));
    }

    [Fact]
    public void The_table_of_doors_counts_the_public_types_of_each_namespace_once()
    {
        Dictionary<string, int> counts = Counts();
        List<(string Names, int Count)> rows = Rows();
        string[] listed = rows.SelectMany(row => Spaces(row.Names)).ToArray();
        Assert.Equal(counts.Keys.Order(StringComparer.Ordinal), listed.Order(StringComparer.Ordinal));
        string[] wrong = rows.Where(row => row.Names.StartsWith("CreatureGen", StringComparison.Ordinal))
            .Select(row => (row, real: Spaces(row.Names).Sum(space => counts[space])))
            .Where(both => both.row.Count != both.real)
            .Select(both => $"{both.row.Names} has {both.real}, not {both.row.Count}")
            .ToArray();
        Assert.True(wrong.Length == 0, "docs/architecture.md: " + string.Join("; ", wrong));
    }

    [Fact]
    public void A_program_on_screen_has_at_most_a_hundred_and_twenty_types_before_it()
    {
        List<(string Names, int Count)> rows = Rows();
        int sum = rows.FindIndex(row => row.Names.StartsWith('*'));
        int before = rows.Take(sum).Sum(row => row.Count);
        Assert.Equal(before, rows[sum].Count);
        Assert.InRange(before, 1, 120);
        string program = RepositoryFiles.Text("tests/CreatureGen.Tests/Conventions/ProgramOnScreen.cs");
        Assert.All(UsingLine().Matches(program), used => Assert.Contains(used.Groups[1].Value, rows.Take(sum).SelectMany(row => Spaces(row.Names))));
    }

    /// <summary>Public types by namespace, those inside others too.</summary>
    private static Dictionary<string, int> Counts() =>
        typeof(CreatureGenerator).Assembly.GetExportedTypes().GroupBy(type => type.Namespace!).ToDictionary(group => group.Key, group => group.Count(), StringComparer.Ordinal);

    private static List<(string Names, int Count)> Rows() =>
        DoorRow().Matches(RepositoryFiles.Text("docs/architecture.md")).Select(m => (m.Groups[1].Value, int.Parse(m.Groups[2].Value, CultureInfo.InvariantCulture))).ToList();

    private static IEnumerable<string> Spaces(string names) => names.Split(", ").Where(name => name.StartsWith("CreatureGen", StringComparison.Ordinal));

    [GeneratedRegex(@"^\| (CreatureGen[\w., ]*|\*of all[^|]*\*) \|[^|]*\| (\d+) \|$", RegexOptions.Multiline)]
    private static partial Regex DoorRow();

    [GeneratedRegex(@"^using (CreatureGen[\w.]*);", RegexOptions.Multiline)]
    private static partial Regex UsingLine();
}
