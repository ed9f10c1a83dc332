using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Rigging;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

/// <summary>What a creature may be put together of beyond what its plan asks for.</summary>
public sealed class GrammarTests
{
    private const ulong First = 9_600_000;

    private static CreatureBlueprint[] Strange(RequestedKind kind, int count) =>
        Enumerable.Range(0, count).Select(i => BlueprintSampler.Sample(First + (ulong)i, CreatureOptions.Default with { Kind = kind, Strangeness = 1 })).ToArray();

    [Fact]
    public void Strange_walkers_have_further_legs_eyes_and_tails_and_feet_and_tails_of_every_family()
    {
        CreatureBlueprint[] all = Strange(RequestedKind.Walking, 500);
        int Standing(CreatureBlueprint b) => b.Legs.Count(leg => leg.Stance == LegStance.Standing);
        BodyPlan[] four = [BodyPlan.Digitigrade, BodyPlan.Unguligrade, BodyPlan.Plantigrade, BodyPlan.Columnar, BodyPlan.Sprawling];
        Assert.Contains(all, b => four.Contains(b.Plan) && Standing(b) == 3);
        Assert.Contains(all, b => four.Contains(b.Plan) && Standing(b) == 4);
        Assert.Contains(all, b => b.Features.Any(part => part.Kind == FeatureKind.Tail));
        Assert.Contains(all, b => b.Features.Any(part => part.Kind == FeatureKind.Eye && part.Segment == 0));
        Assert.Contains(all, b => b.Features.Any(part => part.Kind == FeatureKind.Eye && part.Length > 2 * part.Radius));
        Assert.Contains(all, b => b.Features.Count(part => part.Kind == FeatureKind.Eye) >= 3);
        Assert.Contains(all, b => b.Head.Eyes.IsSingle);
        Assert.Equal(AnatomyChoices.Foot.Count, all.SelectMany(b => b.Legs).Select(leg => leg.Foot).Distinct().Count());
        TailStyle[] tails = [TailStyle.Whip, TailStyle.Paddle, TailStyle.Club, TailStyle.Prehensile, TailStyle.Stinger];
        Assert.All(tails, tail => Assert.Contains(all, b => b.Tail.Style == tail));
    }

    [Fact]
    public void Swimmers_have_six_families_of_fins_and_more_on_flanks_backs_and_tails()
    {
        CreatureBlueprint[] all = Strange(RequestedKind.Swimming, 400);
        HashSet<FinStyle> On(FinPlace place) => all.SelectMany(b => b.Fins).Where(fin => fin.Place == place).Select(fin => fin.Style).ToHashSet();
        Assert.True(On(FinPlace.Pectoral).Count >= 6);
        Assert.True(On(FinPlace.Dorsal).Count >= 6);
        Assert.True(all.Select(b => b.Tail.Style).Distinct().Count() >= 6);
    }

    [Fact]
    public void No_flier_tips_over_its_feet_for_a_long_open_jaw()
    {
        // A crocodile's head on a toucan: what its jaws enclose weighs a third of its length ahead of its feet.
        CreatureBlueprint b = BlueprintSampler.Sample(1990, CreatureOptions.Default with { Kind = RequestedKind.Flying });
        Assert.True(b.Head.Mouth.Opening > 0.3, $"{b.Head.Mouth.Opening}");
        Assert.Empty(CreatureInspection.Inspect(CreatureAssembler.Assemble(b)));
    }

    [Theory]
    [InlineData(9780010, WingStyle.Bat)]
    [InlineData(9780002, WingStyle.Dragon)]
    [InlineData(9780011, WingStyle.Pterosaur)]
    [InlineData(9780051, WingStyle.GlidingLizard)]
    [InlineData(9780028, WingStyle.FlyingFish)]
    public void Membranes_run_along_the_flank_to_the_hip(ulong seed, WingStyle style)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = 0 });
        WingBlueprint wing = creature.Blueprint.Wings[0];
        Assert.Equal(style, wing.Style);
        CreatureMesh mesh = creature.Mesh;
        Vector3[] skin = Enumerable.Range(0, mesh.Positions.Length)
            .Where(v => mesh.Positions[v].X > 0 && creature.Skeleton.Joints[mesh.Weights[v].Joint0].Role == JointRole.Wing)
            .Select(v => mesh.Positions[v]).ToArray();
        float inner = skin.Min(p => p.X) + (0.12f * (skin.Max(p => p.X) - skin.Min(p => p.X)));
        float depth = skin.Where(p => p.X < inner).Max(p => p.Z) - skin.Where(p => p.X < inner).Min(p => p.Z);
        Assert.True(depth > 0.5 * wing.Chord * creature.Blueprint.Scale, $"{depth / (wing.Chord * creature.Blueprint.Scale)}");
    }

    [Fact]
    public void On_land_nothing_else_stands_along_a_back_with_a_fin()
    {
        foreach (CreatureBlueprint b in Strange(RequestedKind.Walking, 400).Where(b => b.Fins.Any(fin => fin.Place == FinPlace.Dorsal)))
        {
            Assert.DoesNotContain(b.Features, part => part.Segment < 3 && part.Ring is > 16 and < 46);
            Assert.Equal(ShellStyle.None, b.Body.Shell.Style);
        }
    }

    [Fact]
    public void Legs_of_swimmers_trail_behind_their_hips()
    {
        CreatureBlueprint[] legged = [.. Strange(RequestedKind.Swimming, 60).Where(b => b.Legs.Count > 0).Take(8)];
        Assert.True(legged.Length >= 4);
        foreach (Creature creature in legged.Select(CreatureAssembler.Assemble))
        {
            foreach (LimbChain leg in creature.Limbs.Where(limb => limb.Kind == LimbKind.Leg))
            {
                float[] along = [.. leg.Joints.Skip(1).Select(joint => creature.Skeleton.ModelPositions[joint].Z)];
                Assert.Equal(along.OrderByDescending(z => z), along);
            }
        }
    }

    [Fact]
    public void Feet_of_swimmers_are_farther_out_than_their_elbows_so_that_these_do_not_hide_them_from_the_front()
    {
        CreatureBlueprint[] legged = [.. Strange(RequestedKind.Swimming, 60).Where(b => b.Legs.Count > 0).Take(8)];
        Assert.True(legged.Length >= 4);
        foreach (Creature creature in legged.Select(CreatureAssembler.Assemble))
        {
            foreach (LimbChain leg in creature.Limbs.Where(limb => limb.Kind == LimbKind.Leg && limb.Side == Side.Left))
            {
                float elbow = creature.Skeleton.ModelPositions[leg.Joints[2]].X;
                float foot = creature.Skeleton.ModelPositions[leg.Joints[^1]].X;
                Assert.True(foot > elbow, FormattableString.Invariant($"{creature.Blueprint.Seed}: a foot at {foot} m, an elbow at {elbow} m"));
            }
        }
    }

    [Theory]
    [InlineData(BodyPlan.Digitigrade)]
    [InlineData(BodyPlan.Plantigrade)]
    public void Plans_of_four_legs_may_be_asked_for_with_six_and_eight(BodyPlan plan)
    {
        CreatureOptions six = CreatureOptions.Default with { Kind = RequestedKind.Walking, MinLegPairs = 3, MaxLegPairs = 4, BodyPlans = new ValueList<BodyPlanWeight>([.. AnatomyChoices.Plan.Values.Select(p => new BodyPlanWeight(p, p == plan ? 1 : 0))]) };
        CreatureBlueprint sampled = BlueprintSampler.Sample(First, six);
        Assert.Equal(plan, sampled.Plan);
        Assert.InRange(sampled.Legs.Count, 3, 4);
    }

    public static TheoryData<FootStyle> Feet => new(AnatomyChoices.Foot.Values);

    [Theory]
    [MemberData(nameof(Feet))]
    public void Every_family_of_feet_stands_under_every_plan(FootStyle foot)
    {
        BodyPlan[] plans = [BodyPlan.Digitigrade, BodyPlan.Unguligrade, BodyPlan.Plantigrade, BodyPlan.Sprawling, BodyPlan.Theropod, BodyPlan.Upright];
        foreach (BodyPlan plan in plans)
        {
            var options = CreatureOptions.Default with { Kind = RequestedKind.Walking, BodyPlans = new ValueList<BodyPlanWeight>(AnatomyChoices.Plan.Values.Select(p => new BodyPlanWeight(p, p == plan ? 1 : 0))) };
            CreatureBlueprint blueprint = BlueprintSampler.Sample(First, options);
            blueprint = blueprint with { Legs = new ValueList<LegBlueprint>(blueprint.Legs.Select(leg => leg with { Foot = foot })) };
            Assert.Empty(CreatureInspection.Inspect(CreatureAssembler.Assemble(blueprint)));
        }
    }

    public static TheoryData<TailStyle> Tails => new(AnatomyChoices.Tail.Values);

    [Theory]
    [MemberData(nameof(Tails))]
    public void Every_family_of_tails_closes_a_swimmer(TailStyle tail)
    {
        foreach (ulong seed in new[] { First, First + 1, First + 2 })
        {
            CreatureBlueprint blueprint = BlueprintSampler.Sample(seed, LocomotionKind.Swimming);
            blueprint = blueprint with { Tail = new TailBlueprint(tail, 0.25, 0.8) };
            Assert.Empty(CreatureInspection.Inspect(CreatureAssembler.Assemble(blueprint)));
        }
    }

    [Fact]
    public void Tails_of_swimmers_point_back_and_do_not_hang()
    {
        foreach (CreatureBlueprint b in Enumerable.Range(0, 120).Select(i => BlueprintSampler.Sample(First + (ulong)i, LocomotionKind.Swimming)))
        {
            BodyShape shape = BodyShaper.Shape(b.Plan, b.Body, b.Head, b.Tail);
            double fall = (shape.Y[44] - shape.Y[54]) / (shape.Z[44] - shape.Z[54]);
            Assert.True(Math.Abs(fall) < 0.45, $"{b.Seed}: {fall:0.00}");
        }
    }
}
