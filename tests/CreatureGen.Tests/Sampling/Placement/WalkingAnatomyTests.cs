using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>Bodies of nine animals keep their anatomy under the rules.</summary>
public sealed class WalkingAnatomyTests
{
    [Theory]
    [InlineData("canine", BodyPlan.Digitigrade, 0.62)]
    [InlineData("canine", BodyPlan.Digitigrade, 1.05)]
    [InlineData("feline", BodyPlan.Digitigrade, 0.8)]
    [InlineData("feline", BodyPlan.Plantigrade, 0.6)]
    [InlineData("bovine", BodyPlan.Unguligrade, 0.8)]
    [InlineData("bovine", BodyPlan.Unguligrade, 1.25)]
    [InlineData("bovine", BodyPlan.Columnar, 0.8)]
    [InlineData("reptile", BodyPlan.Plantigrade, 0.55)]
    [InlineData("reptile", BodyPlan.Sprawling, 0.25)]
    [InlineData("amphibian", BodyPlan.Sprawling, 0.25)]
    [InlineData("serpent", BodyPlan.Sprawling, 0.25)]
    [InlineData("fish", BodyPlan.Sprawling, 0.3)]
    public void Four_footed_animals_stay_four_footed(string animal, BodyPlan plan, double height)
    {
        WalkingPlacement placement = Spines.Place(BaseBodySpines.Measure(animal, height), SocketSets.Of(plan));
        Assert.Equal(new[] { 27, 41 }, Rings(placement));
        Assert.Equal(BalanceRemedy.None, placement.Balance!.Remedy);
        Assert.Null(placement.PlanChange);
    }

    [Theory]
    [InlineData("avian", 0.5, 0)]
    [InlineData("avian", 1.4, 0)]
    [InlineData("reptile", 0.9, 10)]
    [InlineData("fish", 0.8, 0)]
    public void Theropods_stand_on_one_pair_at_the_widest_of_their_hips(string animal, double height, double pitch)
    {
        SpineMeasure measure = BaseBodySpines.Measure(animal, height, pitch);
        WalkingPlacement placement = Spines.Place(measure, SocketSets.Of(BodyPlan.Theropod));
        Assert.Equal(new[] { 34 }, Rings(placement));
        Assert.Equal(WalkingRule.OnePairAtCentre, placement.Rule);
        Assert.True(placement.Balance!.Remedy <= BalanceRemedy.ShiftFeet);
    }

    [Theory]
    [InlineData("canine", 0.6, 60)]
    [InlineData("feline", 0.6, 60)]
    [InlineData("amphibian", 0.5, 50)]
    public void Upright_animals_stand_on_their_hips_and_have_arms(string animal, double height, double pitch)
    {
        WalkingPlacement placement = Spines.Place(BaseBodySpines.Measure(animal, height, pitch), SocketSets.Of(BodyPlan.Upright));
        Assert.Equal(new[] { 40 }, Rings(placement));
        Assert.Equal(26, placement.Arms!.Site.Ring);
        Assert.True(placement.Balance!.Remedy <= BalanceRemedy.ShiftFeet);
        Assert.InRange(placement.Legs[0].Shear, -0.05, 0.5);
    }

    [Theory]
    [InlineData(0.22)]
    [InlineData(0.28)]
    [InlineData(0.4)]
    public void Beetles_have_six_legs_by_either_rule(double height)
    {
        SocketSet set = SocketSets.Hexapod() with { Arms = null };
        WalkingPlacement placement = Spines.Place(BaseBodySpines.Measure("insect", height), set);
        Assert.Equal(new[] { 24, 28, 32 }, Rings(placement));
        Assert.Equal(height > 0.3, placement.Completed > 0);
        Assert.Null(placement.PlanChange);
    }

    [Fact]
    public void A_serpent_near_the_ground_gets_a_row_of_legs_over_its_whole_trunk()
    {
        WalkingPlacement placement = Spines.Place(BaseBodySpines.Measure("serpent", 0.2), SocketSets.Of(BodyPlan.ManyLegged));
        Assert.Equal(WalkingRule.AsManyAsFit, placement.Rule);
        int[] rings = Rings(placement);
        Assert.Equal(5, rings.Length);
        Assert.Equal(25, rings[0]);
        Assert.Equal(42, rings[4]);
    }

    [Fact]
    public void A_snake_has_no_legs_and_lacks_nothing()
    {
        WalkingPlacement placement = Spines.Place(BaseBodySpines.Measure("serpent", 0.1), SocketSets.Of(BodyPlan.Legless));
        Assert.Empty(placement.Legs);
        Assert.Null(placement.Arms);
        Assert.Null(placement.PlanChange);
        Assert.Equal(0, placement.RaiseBody);
    }

    [Fact]
    public void Every_walking_plan_has_its_places_in_order_and_others_are_refused()
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Digitigrade, BodyPlan.Unguligrade, BodyPlan.Plantigrade, BodyPlan.Columnar, BodyPlan.Upright, BodyPlan.Sprawling, BodyPlan.Theropod, BodyPlan.Hexapod, BodyPlan.ManyLegged, BodyPlan.Legless, BodyPlan.Centaur })
        {
            SocketSet set = SocketSets.Of(plan);
            Assert.Equal(plan, set.Plan);
            Assert.True(set.Legs.Count >= set.MinimumPairs);
            for (int i = 1; i < set.Legs.Count; i++)
            {
                Assert.True(set.Legs[i].Ring > set.Legs[i - 1].Ring);
            }
        }

        Assert.Throws<System.ArgumentOutOfRangeException>(() => SocketSets.Of(BodyPlan.Fish));
        Assert.Throws<System.ArgumentOutOfRangeException>(() => SocketSets.Quadruped(BodyPlan.Theropod));
    }

    [Fact]
    public void Girth_can_be_told_apart_for_front_and_hind_legs()
    {
        SocketSet set = SocketSets.Of(BodyPlan.Digitigrade);
        SocketSet hulk = set.WithGirth(1.3, 0.9);
        Assert.Equal(set.Legs[0].Girth * 1.3, hulk.Legs[0].Girth);
        Assert.Equal(set.Legs[1].Girth * 0.9, hulk.Legs[1].Girth);
        Assert.Equal(set.Arms!.Legs[0].Girth * 1.3, hulk.Arms!.Legs[0].Girth);
    }

    private static int[] Rings(WalkingPlacement placement)
    {
        var rings = new List<int>();
        foreach (LegPlacement leg in placement.Legs)
        {
            rings.Add(leg.Site.Ring);
        }

        return rings.ToArray();
    }
}
