using System;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Anatomy;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed partial class SpeciesNamesTests
{
    /// <summary>Where names are listed, and where words of other things are spelled like an animal ("fish" is a plan too).</summary>
    private static readonly string[] registers = ["Species/Catalogue/", "Anatomy/BaseBodyNames.cs", "Blueprints/AnatomyChoices.cs"];

    [Fact]
    public void No_code_outside_the_catalogue_knows_a_species_by_name()
    {
        string[] files = RepositoryFiles.Below("src", "*.cs").Where(path => !registers.Any(path.Contains)).ToArray();
        Assert.True(files.Length > 300);
        string[] found = files
            .SelectMany(path => Literal().Matches(RepositoryFiles.Text(path)).Select(match => match.Groups[1].Value).Where(word => BaseBodyNames.All.Contains(word, StringComparer.Ordinal)).Select(word => $"{path}: \"{word}\""))
            .ToArray();
        Assert.True(found.Length == 0, "a species is asked for its traits, not for its name: " + string.Join(", ", found));
    }

    [GeneratedRegex("\"([a-z]+)\"")]
    private static partial Regex Literal();
}
