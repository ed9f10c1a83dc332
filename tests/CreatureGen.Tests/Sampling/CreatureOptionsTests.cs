using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class CreatureOptionsTests
{
    [Fact]
    public void The_defaults_are_those_of_the_documentation()
    {
        var options = new CreatureOptions();
        Assert.Equal(RequestedKind.Any, options.Kind);
        Assert.Equal((0.5, 2.0), (options.MinScale, options.MaxScale));
        Assert.Equal((0, 16), (options.MinLegPairs, options.MaxLegPairs));
        Assert.Empty(options.BodyPlans);
        Assert.Empty(options.BaseBodies);
        Assert.Equal(PaletteMood.Any, options.Palette);
        Assert.Equal(OrnamentLevel.Normal, options.Ornaments);
        Assert.Equal(20000, options.TriangleBudget);
        Assert.Equal(CreatureOptions.Default, options);
        Assert.Empty(options.Validate());
        options.ThrowIfInvalid();
    }

    [Fact]
    public void Options_with_the_same_values_are_equal()
    {
        CreatureOptions Make() => new() { Kind = RequestedKind.Flying, BodyPlans = Plans((BodyPlan.Buzzing, 2)), BaseBodies = Bodies(("fish", 0)) };
        Assert.Equal(Make(), Make());
        Assert.Equal(Make().GetHashCode(), Make().GetHashCode());
        Assert.NotEqual(Make(), Make() with { BodyPlans = Plans((BodyPlan.Buzzing, 3)) });
    }

    [Fact]
    public void The_ends_of_the_ranges_are_allowed()
    {
        Assert.Empty(new CreatureOptions { MinScale = 0.05, MaxScale = 20, MinLegPairs = 16, MaxLegPairs = 16, TriangleBudget = 6000 }.Validate());
        Assert.Empty(new CreatureOptions { MinScale = 0.05, MaxScale = 0.05, MinLegPairs = 0, MaxLegPairs = 0, TriangleBudget = 100000 }.Validate());
        Assert.Empty(new CreatureOptions { BodyPlans = Plans((BodyPlan.Eel, 1000), (BodyPlan.Fish, 0)) }.Validate());
    }

    [Fact]
    public void All_problems_are_told_at_once()
    {
        var options = new CreatureOptions
        {
            Kind = (RequestedKind)9,
            MinScale = 0.01,
            MaxScale = double.NaN,
            MinLegPairs = 17,
            MaxLegPairs = -1,
            BodyPlans = Plans((BodyPlan.Eel, -1), ((BodyPlan)99, 1)),
            BaseBodies = Bodies(("dragon", double.PositiveInfinity)),
            Palette = (PaletteMood)(-1),
            Ornaments = (OrnamentLevel)4,
            TriangleBudget = 5999,
        };
        string[] expected =
        {
            "kind = an undefined value; expected one of any, walking, flying, swimming",
            "minScale = 0.01; expected 0.05..20",
            "maxScale = NaN; expected 0.05..20",
            "minLegPairs = 17; expected a whole number 0..16",
            "maxLegPairs = -1; expected a whole number 0..16",
            "bodyPlans[0].weight = -1; expected 0..1000",
            "bodyPlans[1].plan = an undefined value; expected one of digitigrade, unguligrade, plantigrade, columnar, upright, sprawling, theropod, hexapod, manyLegged, legless, centaur, flapping, buzzing, fish, eel, whale, flipper",
            "baseBodies[0].name = \"dragon\"; expected one of " + string.Join(", ", BaseBodyNames.All),
            "baseBodies[0].weight = Infinity; expected 0..1000",
            "palette = an undefined value; expected one of any, natural, vivid, pale, dark",
            "ornaments = an undefined value; expected one of none, sparse, normal, rich",
            "triangleBudget = 5999; expected a whole number 6000..100000",
            "minLegPairs = 17; expected at most maxLegPairs, which is -1",
        };
        Assert.Equal(expected, Sentences(options));
        ArgumentException exception = Assert.Throws<ArgumentException>(options.ThrowIfInvalid);
        Assert.StartsWith("the options are not valid:\n" + string.Join("\n", expected), exception.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Least_and_greatest_must_not_cross()
    {
        Assert.Equal("minScale = 3; expected at most maxScale, which is 2", Assert.Single(Sentences(new CreatureOptions { MinScale = 3 })));
        Assert.Equal("minLegPairs = 3; expected at most maxLegPairs, which is 2", Assert.Single(Sentences(new CreatureOptions { MinLegPairs = 3, MaxLegPairs = 2 })));
    }

    [Fact]
    public void A_plan_or_a_base_body_is_weighed_once()
    {
        Assert.Equal(
            "bodyPlans[2].plan = eel; expected each plan once; bodyPlans[0] has it too",
            Assert.Single(Sentences(new CreatureOptions { BodyPlans = Plans((BodyPlan.Eel, 1), (BodyPlan.Fish, 1), (BodyPlan.Eel, 1)) })));
        Assert.Equal(
            "baseBodies[1].name = \"fish\"; expected each name once; baseBodies[0] has it too",
            Assert.Single(Sentences(new CreatureOptions { BaseBodies = Bodies(("fish", 1), ("fish", 2)) })));
    }

    [Theory]
    [InlineData(RequestedKind.Flying, new[] { BodyPlan.Flapping, BodyPlan.Buzzing }, true)]
    [InlineData(RequestedKind.Flying, new[] { BodyPlan.Flapping, BodyPlan.Eel }, false)]
    [InlineData(RequestedKind.Swimming, new[] { BodyPlan.Fish, BodyPlan.Eel, BodyPlan.Whale, BodyPlan.Flipper }, true)]
    [InlineData(RequestedKind.Any, new[] { BodyPlan.Flapping, BodyPlan.Buzzing }, false)]
    [InlineData(RequestedKind.Walking, new[] { BodyPlan.Flapping, BodyPlan.Buzzing }, false)]
    public void Some_plan_of_the_kind_must_be_left(RequestedKind kind, BodyPlan[] excluded, bool nothingLeft)
    {
        var options = new CreatureOptions { Kind = kind, BodyPlans = Plans(excluded.Select(plan => (plan, 0.0)).ToArray()) };
        Assert.Equal(
            nothingLeft ? new[] { "bodyPlans = all excluded; expected at least one plan with a weight above 0, for this kind of creature" } : [],
            Sentences(options));
    }

    [Fact]
    public void Something_must_be_left_to_draw()
    {
        (BodyPlan, double)[] plans = Enum.GetValues<BodyPlan>().Select(plan => (plan, 0.0)).ToArray();
        (string, double)[] bodies = BaseBodyNames.All.Select(name => (name, 0.0)).ToArray();
        Assert.Equal(
            new[] { "bodyPlans = all excluded; expected at least one plan with a weight above 0", "baseBodies = all excluded; expected at least one base body with a weight above 0" },
            Sentences(new CreatureOptions { BodyPlans = Plans(plans), BaseBodies = Bodies(bodies) }));
        Assert.Empty(Sentences(new CreatureOptions { BodyPlans = Plans(plans[1..]), BaseBodies = Bodies(bodies[1..]) }));
    }

    [Fact]
    public void Lists_that_are_null_or_too_long_are_reported()
    {
        BodyPlanWeight[] many = Enumerable.Repeat(new BodyPlanWeight(BodyPlan.Eel, 0), 18).ToArray();
        Assert.Equal(
            new[] { "bodyPlans = 18 elements; expected an array of 0..17 elements", "baseBodies = null; expected an array of 0..57 elements" },
            Sentences(new CreatureOptions { BodyPlans = new ValueList<BodyPlanWeight>(many), BaseBodies = null! }));
    }

    private static string[] Sentences(CreatureOptions options) => options.Validate().Select(problem => problem.ToString()).ToArray();

    [Fact]
    public void Only_some_plans_give_creatures_of_no_others()
    {
        CreatureOptions options = CreatureOptions.Default with { BodyPlans = BodyPlanWeight.Only(BodyPlan.Hexapod, BodyPlan.Eel) };
        var found = new HashSet<BodyPlan>();
        for (ulong seed = 0; seed < 60; seed++)
        {
            found.Add(BlueprintSampler.Sample(seed, options).Plan);
        }

        Assert.Equal(new HashSet<BodyPlan> { BodyPlan.Hexapod, BodyPlan.Eel }, found);
        Assert.Empty(options.Validate());
    }

    [Fact]
    public void Only_no_plans_at_all_is_refused()
    {
        Assert.Contains("expected at least one", Assert.Throws<ArgumentException>(() => BodyPlanWeight.Only()).Message);
        Assert.Throws<ArgumentNullException>(() => BodyPlanWeight.Only(null!));
    }

    private static ValueList<BodyPlanWeight> Plans(params (BodyPlan Plan, double Weight)[] plans) => new(plans.Select(plan => new BodyPlanWeight(plan.Plan, plan.Weight)));

    private static ValueList<BaseBodyWeight> Bodies(params (string Name, double Weight)[] bodies) => new(bodies.Select(body => new BaseBodyWeight(body.Name, body.Weight)));
}
