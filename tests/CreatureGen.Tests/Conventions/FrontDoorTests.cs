using System;
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

    [GeneratedRegex(@"^using (CreatureGen[\w.]*);", RegexOptions.Multiline)]
    private static partial Regex UsingLine();
}
