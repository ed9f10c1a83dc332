using System;
using System.Collections.Generic;
using System.Linq;
using System.Text.RegularExpressions;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Footsteps;

/// <summary>What a foot remembers is told apart: its plan, where it is on its way, and what its leg made of that.</summary>
public sealed partial class FootTests
{
    /// <summary>Who swims has feet of its own that nobody plans.</summary>
    private const string Swims = "PaddlePose.cs";

    [Theory]
    [InlineData("Plan", "FootPlanner.Aim.cs", "FootPlanner.Places.cs", "FootPlanner.cs", "FootRelease.cs")]
    [InlineData("Path", "FootPoser.cs", "WalkingMode.Pose.cs")]
    [InlineData("Leg", "LegPace.cs", "LegPoser.cs", "LegRoom.cs")]
    public void Each_part_of_a_foot_has_its_own_writers(string part, params string[] writers)
    {
        var found = new List<string>();
        foreach (string path in RepositoryFiles.Below("src/CreatureGen/Motion", "*.cs"))
        {
            string file = path[(path.LastIndexOf('/') + 1)..];
            found.AddRange(Written().Matches(RepositoryFiles.Text(path)).Where(write => write.Groups[1].Value == part && !IsBeginning(part, write.Groups[2].Value)).Select(_ => file));
        }

        Assert.Equal(writers.Order(StringComparer.Ordinal), found.Where(file => file != Swims).Distinct().Order(StringComparer.Ordinal));
    }

    /// <summary>Where a hip is before it was ever posed.</summary>
    private static bool IsBeginning(string part, string field) => part == "Leg" && field == "Hip";

    [GeneratedRegex(@"\b(?:foot|[fF]eet\[\w+\])\.(Plan|Path|Leg)\.(\w+)(?:\.\w+)? (?:[-+*/]?=) ")]
    private static partial Regex Written();
}
