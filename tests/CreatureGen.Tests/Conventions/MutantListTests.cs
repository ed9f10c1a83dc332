using System;
using System.IO;
using System.Linq;
using Xunit;

namespace CreatureGen.Tests.Conventions;

/// <summary>The list of defects made by hand: what it changes has to be there, or a mutant is left out without anybody knowing.</summary>
public sealed class MutantListTests
{
    private const string Place = "tests/mutants/mutants.txt";

    [Fact]
    public void Each_mutant_changes_an_expression_that_is_once_in_its_file()
    {
        string[][] mutants = [.. RepositoryFiles.Text(Place).Split('\n').Where(line => line.Length > 0 && line[0] != '#').Select(line => line.Split(" ## "))];
        Assert.All(mutants, mutant => Assert.Equal(4, mutant.Length));
        Assert.Empty(mutants.Where(mutant => Times(mutant[1].Trim(), "src/CreatureGen/" + mutant[0].Trim()) != 1).Select(mutant => mutant[0] + ": " + mutant[1]));
        Assert.InRange(mutants.Length, 143, 1000);
    }

    private static int Times(string expression, string file) =>
        File.Exists(Path.Combine(RepositoryFiles.Root, file)) ? RepositoryFiles.Text(file).Split(expression, StringSplitOptions.None).Length - 1 : 0;
}
