using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Repairs;
using CreatureGen.Sampling;
using CreatureGen.Tests.Blueprints;
using CreatureGen.Tests.Conventions;
using Xunit;

namespace CreatureGen.Tests.Repairs;

public sealed class BlueprintRepairTests
{
    private const string Folder = "tests/CreatureGen.Tests/Repairs/broken";

    /// <summary>Blueprints that a fuzzer found: each field and each rule lets them pass, and their creatures do not stand, tip over or have torn skin. Every fifth is always tried.</summary>
    public static IEnumerable<TheoryDataRow<string>> Broken => RepositoryFiles.Below(Folder, "*.json").Select((path, i) => new TheoryDataRow<string>(path) { Explicit = i % 8 == 0 ? null : true });

    [Theory]
    [MemberData(nameof(Broken))]
    public void What_was_found_broken_is_told_and_repaired(string path)
    {
        CreatureBlueprint blueprint = BlueprintJson.Read(RepositoryFiles.Text(path)).Draft!;
        RepairReport report = BlueprintRepair.Repair(blueprint);
        Assert.True(report.IsSound, string.Join('\n', report.Violations));
        Assert.NotEmpty(report.Changes);
        Assert.Empty(BlueprintValidator.Validate(report.Blueprint));
        Assert.Equal(report.Blueprint, report.Creature.Blueprint);
        Assert.Equal(blueprint.Coat, report.Blueprint.Coat);
    }

    [Fact]
    public void A_sound_blueprint_is_left_as_it_is()
    {
        foreach (RequestedKind kind in new[] { RequestedKind.Walking, RequestedKind.Flying, RequestedKind.Swimming })
        {
            CreatureBlueprint sound = Sampled(11, kind);
            RepairReport report = BlueprintRepair.Repair(sound);
            Assert.Same(sound, report.Blueprint);
            Assert.Empty(report.Changes);
            Assert.True(report.IsSound);
        }
    }

    [Theory]
    [InlineData(3)]
    [InlineData(8, Explicit = true)]
    [InlineData(20, Explicit = true)]
    public void A_repair_gives_the_same_blueprint_every_time_and_needs_no_second(ulong seed)
    {
        CreatureBlueprint b = Sampled(seed, RequestedKind.Walking);
        CreatureBlueprint edited = b with { Body = b.Body with { Proportions = b.Body.Proportions with { Neck = 2.5, Tail = 2.5 } } };
        RepairReport once = BlueprintRepair.Repair(edited);
        Assert.True(once.IsSound);
        Assert.Equal(once.Blueprint, BlueprintRepair.Repair(edited).Blueprint);
        Assert.Equal(once.Changes, BlueprintRepair.Repair(edited).Changes);
        Assert.Same(once.Blueprint, BlueprintRepair.Repair(once.Blueprint).Blueprint);
    }

    [Fact]
    public void The_same_spikes_twice_become_spikes_once()
    {
        CreatureBlueprint b = Samples.Small;
        var twice = new ValueList<FeatureBlueprint>(b.Features.Concat(b.Features));
        Assert.Equal("features[1] = the same as features[0]; expected a part that differs from all others", Assert.Single(BlueprintValidator.Validate(b with { Features = twice })).ToString());
        RepairReport report = BlueprintRepair.Repair(b with { Features = twice });
        Assert.Equal(b.Features, report.Blueprint.Features);
        Assert.Contains(report.Changes, change => change.ToString() == "features: 2 elements became 1 element, equal parts lay in one another");
    }

    /// <summary>Antennae and further tails have joints on either side: on the midline left and right would be the same surface twice.</summary>
    [Theory]
    [InlineData(FeatureKind.Antenna, 0, 0.5)]
    [InlineData(FeatureKind.Tail, 16, 15.5)]
    public void A_pair_of_feelers_or_tails_stands_apart(FeatureKind kind, double segment, double repaired)
    {
        CreatureBlueprint animal = Sampled(11, RequestedKind.Walking);
        FeatureBlueprint part = LimbFields.Feature.Neutral with { Kind = kind, Ring = kind == FeatureKind.Tail ? 52 : 4, Segment = segment, Length = 0.3, Radius = 0.012, Upward = 0.6, Sideward = 0.4 };
        CreatureBlueprint b = animal with { Features = new ValueList<FeatureBlueprint>([part]) };
        string name = AnatomyChoices.Feature.NameOf(kind)!;
        Assert.Equal($"features[0].segment = {segment}; expected off the midline, since parts of kind {name} are pairs", Assert.Single(BlueprintValidator.Validate(b)).ToString());
        RepairReport report = BlueprintRepair.Repair(b);
        Assert.True(report.IsSound, string.Join('\n', report.Violations));
        Assert.Equal(repaired, report.Blueprint.Features[0].Segment);
        Assert.Empty(BlueprintValidator.Validate(b with { Features = new ValueList<FeatureBlueprint>([part with { Kind = FeatureKind.Horn }]) }));
    }

    [Fact]
    public void An_upright_body_laid_level_is_raised_off_its_arms()
    {
        CreatureBlueprint b = BlueprintSampler.Sample(41, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 0, BodyPlans = new([new BodyPlanWeight(BodyPlan.Upright, 1000)]) });
        Assert.Equal(BodyPlan.Upright, b.Plan);
        CreatureBlueprint level = b with { Body = b.Body with { Posture = b.Body.Posture with { Torso = 0 } } };
        Assert.Contains(CreatureInspection.Inspect(CreatureAssembler.Assemble(level)), violation => violation.Invariant is "grounded" or "balanced");
        Assert.True(BlueprintRepair.Repair(level).IsSound);
    }

    [Fact]
    public void Six_legs_of_which_two_are_gone_become_another_plan()
    {
        CreatureBlueprint b = BlueprintSampler.Sample(28, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 0 });
        Assert.Equal((BodyPlan.Hexapod, 3), (b.Plan, b.Legs.Count));
        CreatureBlueprint four = b with { Legs = new ValueList<LegBlueprint>(b.Legs.Take(2)) };
        Assert.Contains("legs = 2 pairs of standing legs; expected at least 3 for the plan hexapod", BlueprintValidator.Validate(four).Select(problem => problem.ToString()));
        RepairReport report = BlueprintRepair.Repair(four);
        Assert.True(report.IsSound, string.Join('\n', report.Violations));
        Assert.Contains(report.Changes, change => change.Path == "plan" && change.From == "hexapod");
    }

    [Fact]
    public void Every_kind_of_problem_of_the_rules_is_cured_without_building()
    {
        CreatureBlueprint b = Samples.Small;
        CreatureBlueprint wrong = b with
        {
            Plan = BodyPlan.Eel,
            Scale = double.NaN,
            Head = b.Head with { Bumps = new([new HeadBump(8, 6, 1, 1, -0.9), new HeadBump(8, 6, 1, 1, -0.9)]), NostrilSize = 1e-9, Eyes = b.Head.Eyes with { Segment = 0, Ring = 50 } },
            Tail = b.Tail with { Size = 0 },
            Legs = new([b.Legs[0], b.Legs[0], b.Legs[1] with { Socket = new SocketBlueprint(51, 30, 22, 16) }]),
            Fins = new([b.Fins[0] with { Socket = b.Fins[0].Socket with { Segment = 3 } }, b.Fins[0] with { Place = FinPlace.Pectoral, Socket = new SocketBlueprint(20, 7, 4, 2) }]),
            Ears = new([b.Ears[0] with { Outward = 0, Upward = 0, Forward = 0 }]),
            Manes = new([b.Manes[0] with { Ring = 24, LastRing = 16 }]),
            Body = b.Body with { Shell = new ShellBlueprint(ShellStyle.Carapace, 50, 36, 6, 0.1) },
        };
        Assert.True(BlueprintValidator.Validate(wrong).Count > 8);
        var log = new RepairLog(wrong);
        PartRemedies.Apply(log);
        Assert.Empty(BlueprintValidator.Validate(log.Blueprint));
    }

    [Fact]
    public void Text_with_problems_still_gives_what_can_be_repaired()
    {
        string text = BlueprintJson.Write(Samples.Small).Replace("\"scale\": 1.25", "\"scale\": -3", StringComparison.Ordinal);
        BlueprintReading reading = BlueprintJson.Read(text);
        Assert.Null(reading.Blueprint);
        Assert.Equal(Samples.Small with { Scale = 1 }, reading.Draft);
        Assert.Null(BlueprintJson.Read("[]").Draft);
        Assert.Throws<ArgumentNullException>(() => BlueprintRepair.Repair(null!));
    }

    [Fact(Explicit = true)]
    public void Long_necks_and_tails_given_to_two_dozen_walkers_are_carried_after_repair()
    {
        int broken = 0;
        for (ulong seed = 1; seed <= 24; seed++)
        {
            CreatureBlueprint b = Sampled(seed, RequestedKind.Walking);
            CreatureBlueprint edited = b with { Body = b.Body with { Proportions = b.Body.Proportions with { Neck = 2 * b.Body.Proportions.Neck, Tail = 2 * b.Body.Proportions.Tail } } };
            RepairReport report = BlueprintRepair.Repair(edited);
            broken += report.Changes.Count > 0 ? 1 : 0;
            Assert.True(report.IsSound, $"{seed}: {string.Join(", ", report.Violations)}");
            Assert.True(report.Blueprint.Body.Proportions.Neck > 1.2 * b.Body.Proportions.Neck || report.Blueprint.Body.Proportions.Tail > 1.2 * b.Body.Proportions.Tail, $"{seed}: the edit is gone");
        }

        Assert.InRange(broken, 2, 24);
    }

    private static CreatureBlueprint Sampled(ulong seed, RequestedKind kind) => BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind, TriangleBudget = 6000, Strangeness = 0 });
}
