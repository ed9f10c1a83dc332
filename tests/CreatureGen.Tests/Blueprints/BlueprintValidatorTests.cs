using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using Xunit;
using CreatureGen.Species;

namespace CreatureGen.Tests.Blueprints;

public sealed class BlueprintValidatorTests
{
    [Fact]
    public void What_the_sampler_draws_is_valid()
    {
        Assert.All(Samples.Drawn(500), blueprint => Assert.Empty(BlueprintValidator.Validate(blueprint)));
    }

    [Fact]
    public void The_neutral_and_the_small_creature_are_valid()
    {
        Assert.Empty(BlueprintValidator.Validate(CreatureFields.Creature.Neutral));
        Assert.Empty(BlueprintValidator.Validate(Samples.Small));
        BlueprintValidator.ThrowIfInvalid(Samples.Small);
    }

    [Fact]
    public void Neutral_records_are_within_their_own_ranges()
    {
        Assert.True(FieldChecker.Accepts(LimbFields.Leg.Neutral, LimbFields.Leg));
        Assert.True(FieldChecker.Accepts(LimbFields.Wing.Neutral, LimbFields.Wing));
        Assert.True(FieldChecker.Accepts(LimbFields.InsectWing.Neutral, LimbFields.InsectWing));
        Assert.True(FieldChecker.Accepts(LimbFields.Fin.Neutral, LimbFields.Fin));
        Assert.True(FieldChecker.Accepts(LimbFields.Ear.Neutral, LimbFields.Ear));
        Assert.True(FieldChecker.Accepts(LimbFields.Feature.Neutral, LimbFields.Feature));
        Assert.True(FieldChecker.Accepts(HeadFields.Bump.Neutral, HeadFields.Bump));
    }

    [Fact]
    public void All_fields_out_of_range_are_told_at_once()
    {
        CreatureBlueprint small = Samples.Small;
        CreatureBlueprint wrong = small with
        {
            Algorithm = 0,
            Scale = double.NaN,
            Legs = small.Legs.With(1, small.Legs[1] with { Toes = 0, Thickness = 0 }),
            Body = small.Body with { Slices = new ValueList<LatticeSlice>(small.Body.Slices.Skip(1)), Posture = small.Body.Posture with { TailBend = 0.3, NeckBend = -0.6 } },
            Coat = small.Coat with { Iris = null!, PatternKind = (PatternKind)(-1) },
            Wings = null!,
        };
        Assert.Equal(
            new[]
            {
                $"algorithm = 0; expected a whole number 1..{CreatureBlueprint.CurrentAlgorithm}",
                "scale = NaN; expected 0.05..20",
                "body.posture.neckBend = -0.6; expected -0.5817764173314431..0.5817764173314431",
                "body.posture.tailBend = 0.3; expected -0.29088820866572157..0.29088820866572157",
                "body.slices = 10 elements; expected an array of 11 elements",
                "legs[1].thickness = 0; expected 0.005..1",
                "legs[1].toes = 0; expected a whole number 1..8",
                "wings = null; expected an array of 0..4 elements",
                "coat.iris = null; expected an object",
                "coat.patternKind = an undefined value; expected one of plain, spots, stripes, bands, patches, mottle, saddle, rosettes, giraffe, turing",
            },
            Sentences(wrong));
    }

    [Fact]
    public void Teeth_and_nostrils_are_none_or_have_an_area()
    {
        HeadBlueprint head = Samples.Small.Head;
        Assert.Empty(Sentences(Samples.Small with { Head = head with { NostrilSize = 0, Mouth = head.Mouth with { Teeth = 0 } } }));
        Assert.Equal(
            ["head.nostrilSize = 0.002; expected 0 for none, or at least 0.01", "head.mouth.teeth = 0.009; expected 0 for none, or at least 0.01"],
            Sentences(Samples.Small with { Head = head with { NostrilSize = 0.002, Mouth = head.Mouth with { Teeth = 0.009 } } }));
    }

    [Theory]
    [InlineData(BodyPlan.Hexapod, 3)]
    [InlineData(BodyPlan.Flipper, 2)]
    public void A_plan_needs_all_its_pairs_of_limbs(BodyPlan plan, int pairs)
    {
        CreatureBlueprint whole = BlueprintSampler.Sample(5, CreatureOptions.Default with { BodyPlans = BodyPlanWeight.Only(plan), Strangeness = 0 });
        CreatureBlueprint without = plan == BodyPlan.Hexapod
            ? whole with { Legs = new ValueList<LegBlueprint>(whole.Legs.Take(pairs - 1)) }
            : whole with { Fins = new ValueList<FinBlueprint>(whole.Fins.Where((fin, at) => fin.Place != FinPlace.Pectoral || at != whole.Fins.Select(f => f.Place).ToList().LastIndexOf(FinPlace.Pectoral))) };
        Assert.Contains(Sentences(without), s => s.Contains($"at least {pairs} for the plan {AnatomyChoices.Plan.NameOf(plan)}", StringComparison.Ordinal));
    }

    [Fact]
    public void The_ends_of_a_range_belong_to_it()
    {
        CreatureBlueprint small = Samples.Small;
        Assert.Empty(Sentences(small with { Scale = 0.05 }));
        Assert.Empty(Sentences(small with { Scale = 20 }));
        Assert.Equal("scale = 0.049999999999999996; expected 0.05..20", Assert.Single(Sentences(small with { Scale = Math.BitDecrement(0.05) })));
        Assert.Equal("scale = 20.000000000000004; expected 0.05..20", Assert.Single(Sentences(small with { Scale = Math.BitIncrement(20) })));
    }

    [Fact]
    public void A_plan_belongs_to_one_kind()
    {
        var plans = new Dictionary<LocomotionKind, BodyPlan[]>
        {
            [LocomotionKind.Flying] = [BodyPlan.Flapping, BodyPlan.Buzzing],
            [LocomotionKind.Swimming] = [BodyPlan.Fish, BodyPlan.Eel, BodyPlan.Whale, BodyPlan.Flipper],
        };
        plans[LocomotionKind.Walking] = Enum.GetValues<BodyPlan>().Except(plans.Values.SelectMany(plan => plan)).ToArray();
        foreach (LocomotionKind kind in plans.Keys)
        {
            foreach (BodyPlan plan in Enum.GetValues<BodyPlan>())
            {
                Assert.Equal(plans[kind].Contains(plan), !Sentences(Samples.Small with { Kind = kind, Plan = plan }).Any(problem => problem.StartsWith("plan = ", StringComparison.Ordinal)));
            }
        }

        Assert.Equal("plan = eel; expected a plan of a walking creature", Assert.Single(Sentences(Samples.Small with { Kind = LocomotionKind.Walking, Plan = BodyPlan.Eel })));
    }

    [Fact]
    public void Fliers_have_the_wings_they_fly_by()
    {
        Assert.Equal(
            "wings = 0 pairs of wings; expected at least 1 for the plan flapping",
            Assert.Single(Sentences(Samples.Small with { Wings = ValueList<WingBlueprint>.Empty })));
        Assert.Equal(
            "insectWings = 0 pairs of thin wings; expected at least 1 for the plan buzzing",
            Assert.Single(Sentences(Samples.Small with { Plan = BodyPlan.Buzzing, InsectWings = ValueList<InsectWingBlueprint>.Empty })));
    }

    [Fact]
    public void Hollows_must_not_turn_the_head_inside_out()
    {
        CreatureBlueprint With(params HeadBump[] bumps) => Samples.Small with { Head = Samples.Small.Head with { Bumps = new ValueList<HeadBump>(bumps) } };
        var hollow = new HeadBump(8, 6, 1, 1, -0.6);
        Assert.Empty(Sentences(With(hollow)));
        Assert.Equal("head.bumps = -0.19999999999999996 of the section's size at ring 8, segment 6; expected at least 0.1", Assert.Single(Sentences(With(hollow, hollow))));
        Assert.Empty(Sentences(With(hollow, hollow, hollow with { Amount = 1 })));
        Assert.Empty(Sentences(With(hollow, hollow with { Segment = 11 }, hollow with { Ring = 3 })));
    }

    [Fact]
    public void A_shaped_tail_has_a_size()
    {
        Assert.Equal(
            "tail.size = 0.005; expected at least 0.01 for a tail that is not plain",
            Assert.Single(Sentences(Samples.Small with { Tail = new TailBlueprint(TailStyle.Fan, 0.005, 0) })));
        Assert.Empty(Sentences(Samples.Small with { Tail = new TailBlueprint(TailStyle.Plain, 0, 0) }));
    }

    [Fact]
    public void A_pectoral_fin_has_a_width()
    {
        FinBlueprint fin = LimbFields.Fin.Neutral with { Place = FinPlace.Pectoral, Socket = new SocketBlueprint(33, 9, 4, 2), Width = 0 };
        CreatureBlueprint With(FinBlueprint added) => Samples.Small with { Fins = new ValueList<FinBlueprint>(Samples.Small.Fins.Append(added)) };
        Assert.Equal("fins[1].width = 0; expected at least 0.05 for a pectoral fin", Assert.Single(Sentences(With(fin))));
        Assert.Empty(Sentences(With(fin with { Width = 0.05 })));
    }

    [Fact]
    public void A_direction_points_somewhere()
    {
        CreatureBlueprint small = Samples.Small;
        EarBlueprint ear = small.Ears[0] with { Outward = 0.01, Upward = 0, Forward = 0 };
        FeatureBlueprint spike = small.Features[0] with { Outward = 0, Upward = 0, Forward = 0, Sideward = 0 };
        Assert.Equal(
            new[]
            {
                "ears[0].outward = 0.01; expected with the other components a direction at least 0.1 long",
                "features[0].outward = 0; expected with the other components a direction at least 0.1 long",
            },
            Sentences(small with { Ears = small.Ears.With(0, ear), Features = small.Features.With(0, spike) }));
        Assert.Empty(Sentences(small with { Ears = small.Ears.With(0, ear with { Forward = -0.2 }), Features = small.Features.With(0, spike with { Sideward = -1 }) }));
    }

    [Fact]
    public void The_exception_tells_all_problems()
    {
        CreatureBlueprint wrong = Samples.Small with { Scale = 0, Tail = null! };
        ArgumentException exception = Assert.Throws<ArgumentException>(() => BlueprintValidator.ThrowIfInvalid(wrong));
        Assert.StartsWith("the blueprint is not valid:\nscale = 0; expected 0.05..20\ntail = null; expected an object", exception.Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentNullException>(() => BlueprintValidator.Validate(null!));
    }

    [Fact]
    public void A_blueprint_of_nothing_but_null_is_reported()
    {
        var nothing = new CreatureBlueprint(1, 0, 0, 0, 1, 20000, null!, null!, null!, null!, null!, null!, null!, null!, null!, null!, null!, null!);
        Assert.Equal(12, BlueprintValidator.Validate(nothing).Count);
        CreatureBlueprint hollow = Samples.Small with
        {
            Body = new BodyBlueprint(null!, null!, null!, null!, 0, null!, null!, null!),
            Head = new HeadBlueprint(null!, 2, null!, null!, 0),
            Legs = Samples.Small.Legs.With(0, Samples.Small.Legs[0] with { Socket = null! }),
        };
        Assert.Equal(11, BlueprintValidator.Validate(hollow).Count);
    }

    [Fact]
    public void Known_names_are_those_of_the_base_bodies()
    {
        Assert.Equal(SpeciesCatalogue.All.Select(species => species.Body), BaseBodyNames.All);
    }

    [Fact]
    public void Any_record_in_range_or_out_of_it_is_validated_without_an_exception()
    {
        RandomStream random = new Seed(7).Stream();
        for (int i = 0; i < 500; i++)
        {
            IReadOnlyList<Problem> problems = BlueprintValidator.Validate(RandomFields.Draw(CreatureFields.Creature, random));
            Assert.All(problems, problem => Assert.NotEqual("", problem.Path));
        }
    }

    private static string[] Sentences(CreatureBlueprint blueprint) => BlueprintValidator.Validate(blueprint).Select(problem => problem.ToString()).ToArray();
}
