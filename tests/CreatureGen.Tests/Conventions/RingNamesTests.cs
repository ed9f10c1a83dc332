using System;
using System.Linq;
using System.Text.RegularExpressions;
using Xunit;

namespace CreatureGen.Tests.Conventions;

public sealed partial class RingNamesTests
{
    [Fact]
    public void Rings_of_bodies_are_asked_for_by_the_names_of_their_stations()
    {
        string[] files = RepositoryFiles.Below("src/CreatureGen", "*.cs").Where(path => RepositoryFiles.Text(path).Contains("BodyShape", StringComparison.Ordinal) || path.Contains("Sampling/", StringComparison.Ordinal)).ToArray();
        Assert.True(files.Length > 30);
        string[] bare = files.SelectMany(path => BareRing().Matches(SourceText.CodeOf(RepositoryFiles.Text(path))).Select(match => $"{path}: {match.Value}")).ToArray();
        Assert.True(bare.Length == 0, "rings by their number; expected one of StationRing: " + string.Join(", ", bare));
    }

    [GeneratedRegex(@"\.(?:Arc|Width|Top|Bottom|Y|Z)\[\d+\]|\b[sS]hape\.(?:Up|Forward)\(\d+\)")]
    private static partial Regex BareRing();
}
