using System;
using System.IO;
using System.Linq;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed class PublicApiTests
{
    private const string Baseline = "tests/CreatureGen.Tests/Conventions/PublicApi.txt";

    /// <summary>Both builds of the library are held to the same text.</summary>
    [Fact]
    public void The_public_API_is_the_one_that_was_agreed()
    {
        string actual = PublicApiText.Of(typeof(CreatureGenerator).Assembly);
        string renewed = Path.Combine(AppContext.BaseDirectory, "PublicApi.txt");
        File.WriteAllText(renewed, actual);
        string[] agreed = RepositoryFiles.Text(Baseline).ReplaceLineEndings("\n").Split('\n');
        string[] offered = actual.Split('\n');
        string gone = string.Concat(agreed.Except(offered).Take(20).Select(l => "\n- " + l));
        string added = string.Concat(offered.Except(agreed).Take(20).Select(l => "\n+ " + l));
        Assert.True(agreed.SequenceEqual(offered), $"the public API differs from {Baseline}:{gone}{added}\nIf that is meant, copy {Path.GetRelativePath(RepositoryFiles.Root, renewed)} over it.");
    }
}
