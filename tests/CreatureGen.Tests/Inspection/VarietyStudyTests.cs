using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Inspection.Variety;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Inspection;

public sealed class VarietyStudyTests
{
    private static readonly int[] cubeFaces = [0, 1, 2, 2, 1, 3, 4, 6, 5, 5, 6, 7, 0, 4, 1, 1, 4, 5, 2, 3, 6, 6, 3, 7, 0, 2, 4, 4, 2, 6, 1, 5, 3, 3, 5, 7];

    [Fact]
    public void A_box_is_like_itself_at_any_size_and_place_and_unlike_a_flat_one()
    {
        var cube = new Silhouette(Box(1, 1, 1), cubeFaces);
        Assert.Equal(1, cube.Likeness(new Silhouette(Box(3, 3, 3).Select(p => p + new Vector3(5, -2, 1)).ToArray(), cubeFaces)));

        // Half as wide: the same from the side, half the area from the front and from above.
        Assert.InRange(cube.Likeness(new Silhouette(Box(0.5f, 1, 1), cubeFaces)), 0.64, 0.69);
    }

    [Fact]
    public void Twice_the_same_creature_is_a_double_and_one_combination()
    {
        var study = new VarietyStudy();
        Creature creature = CreatureGenerator.Generate(12);
        study.Add(creature);
        Assert.Equal((1, 0.0, 1.0, 1), (study.Report().Count, study.Report().TwinFraction, study.Report().EffectiveCombinations, study.Report().Clusters));
        study.Add(creature);
        VarietyReport report = study.Report();
        Assert.Equal((2, 1.0, 1.0, 1), (report.Count, report.TwinFraction, report.EffectiveCombinations, report.Clusters));
        Assert.Equal(new LikePair(0, 1, 1), Assert.Single(report.Nearest));
    }

    [Fact]
    public void Nothing_has_been_added_to_an_empty_study() => Assert.Equal(0, new VarietyStudy().Report().Count);

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying, Explicit = true)]
    [InlineData(RequestedKind.Swimming, Explicit = true)]
    public void Of_two_dozen_creatures_hardly_any_has_a_double_and_a_third_has_no_name(RequestedKind kind)
    {
        VarietyReport report = StudyOf(kind, 0.6);
        Assert.InRange(report.TwinFraction, 0, 0.09);
        Assert.InRange(report.ChimeraFraction, 0.35, 1);
        Assert.True(report.EffectiveCombinations > 20, $"{report.EffectiveCombinations}");
    }

    [Theory(Explicit = true)]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void Of_two_hundred_creatures_four_at_most_have_a_double(RequestedKind kind) =>
        Assert.InRange(StudyOf(kind, 0.6, 9_962_000, 200).TwinFraction, 0, 0.02);

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void At_full_strangeness_few_can_be_named(RequestedKind kind)
    {
        IEnumerable<CreatureBlueprint> drawn = Enumerable.Range(7_300_000, 400).Select(seed => BlueprintSampler.Sample((ulong)seed, CreatureOptions.Default with { Kind = kind, Strangeness = 1 }));
        Assert.InRange(drawn.Count(b => ChimeraDistance.Of(b) >= ChimeraDistance.Nameless), 320, 400);
    }

    [Fact]
    public void Without_strangeness_all_creatures_are_animals() => Assert.Equal(0, StudyOf(RequestedKind.Walking, 0).ChimeraFraction);

    private static VarietyReport StudyOf(RequestedKind kind, double strangeness, ulong first = 7_300_000, int count = 24)
    {
        var study = new VarietyStudy();
        for (ulong seed = first; seed < first + (ulong)count; seed++)
        {
            study.Add(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind, Strangeness = strangeness, TriangleBudget = 6000 }));
        }

        return study.Report();
    }

    private static Vector3[] Box(float x, float y, float z) =>
        Enumerable.Range(0, 8).Select(i => new Vector3((i & 1) * x, ((i >> 1) & 1) * y, (i >> 2) * z)).ToArray();
}
