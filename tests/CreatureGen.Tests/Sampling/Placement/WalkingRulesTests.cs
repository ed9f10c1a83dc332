using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>What the thesis states as limits of its rules no longer happens.</summary>
public sealed class WalkingRulesTests
{
    [Fact]
    public void A_very_large_pair_at_one_end_no_longer_leaves_the_creature_unbalanced()
    {
        // Thick thighs at the rear take all the room; the bare rule stops there and the creature would fall on its nose.
        double[] widths = { 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.5 };
        SpineMeasure measure = Spines.Level(widths, 0.08, 0.75, massZ: -0.15, thickness: 0.9);
        SocketSet set = Spines.EveryBone(measure, archetype: LimbArchetype.Theropod);
        var thick = new List<LimbSocket>();
        foreach (LimbSocket socket in set.Legs)
        {
            thick.Add(socket with { Girth = 1, Bounds = new SocketBounds(2, 8, 2, 2, 0) });
        }

        set = set with { Legs = thick };
        (WalkingRule rule, List<int> sockets) = Spines.Choose(measure, set);
        Assert.Equal(WalkingRule.WidestAlone, rule);
        var alone = new LegField(measure, set, set.Legs, LegSize.Nominal, LegGirth.Nominal, 0);
        Assert.Equal(BalanceRemedy.AddPairOrTail, alone.Correct(sockets).Remedy);

        WalkingPlacement placement = Spines.Place(measure, set);
        Assert.Equal(WalkingRule.Counterweight, placement.Rule);
        Assert.Equal(LegGirth.Min, placement.Girth);
        Assert.Equal(2, placement.Legs.Count);
        Assert.True(placement.Balance!.Remedy <= BalanceRemedy.ShiftFeet);
    }

    [Fact]
    public void Where_not_even_slim_legs_find_room_one_pair_moves_under_the_centre_of_mass()
    {
        // Legs nearly twice as long as the body cannot pass one another, however slim.
        double[] widths = { 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.2, 0.5 };
        SpineMeasure measure = Spines.Level(widths, 0.1, 1.9, massZ: -0.1);
        SocketSet set = Spines.EveryBone(measure, archetype: LimbArchetype.Theropod);
        Assert.Equal(WalkingRule.WidestAlone, Spines.Choose(measure, set).Rule);
        WalkingPlacement placement = Spines.Place(measure, set);
        Assert.Equal(WalkingRule.OnePairUnderMass, placement.Rule);
        Assert.Single(placement.Legs);
        Assert.True(placement.Balance!.Remedy <= BalanceRemedy.ShiftFeet);
    }

    [Fact]
    public void A_creature_that_no_legs_could_balance_says_what_it_lacks()
    {
        SpineMeasure measure = Spines.Level(new[] { 0.2, 0.2, 0.2, 0.2, 0.2, 0.5 }, 0.1, 0.8, massZ: 1.5);
        WalkingPlacement placement = Spines.Place(measure, Spines.EveryBone(measure));
        Assert.Equal(BalanceRemedy.AddPairOrTail, placement.Balance!.Remedy);
        Assert.True(placement.Balance.Overhang > 0.5);
    }

    [Fact]
    public void A_widest_part_bent_close_to_the_ground_raises_the_body_instead_of_making_tiny_legs()
    {
        double[] widths = { 0.1, 0.1, 0.2, 0.2, 0.2, 0.2, 0.2, 0.1, 0.5, 0.1, 0.1 };
        double[] heights = { 0.9, 0.85, 0.8, 0.7, 0.6, 0.45, 0.35, 0.25, 0.15, 0.12, 0.1 };
        SpineMeasure measure = Spines.Bent(widths, 0.12, heights, 0.45);
        SocketSet set = Spines.EveryBone(measure) with { Stance = SocketSets.Quadruped(BodyPlan.Digitigrade).Stance };
        double least = set.Stance.MinimumLength * measure.BodyLength;
        WalkingPlacement placement = Spines.Place(measure, set);
        Assert.Equal(least - 0.15, placement.RaiseBody, 9);
        Assert.Contains(placement.Legs, leg => leg.Bone == 8);
        Assert.Null(placement.PlanChange);
        Assert.All(placement.Legs, leg => Assert.True(leg.Length >= least - 1e-9));
    }

    [Fact]
    public void Places_that_no_raise_could_serve_are_left_to_higher_ones()
    {
        double[] widths = { 0.1, 0.1, 0.3, 0.3, 0.1, 0.1, 0.1, 0.1, 0.5, 0.1, 0.1 };
        double[] heights = { 0.9, 0.85, 0.8, 0.7, 0.6, 0.45, 0.35, 0.0, -0.3, -0.3, -0.3 };
        SpineMeasure measure = Spines.Bent(widths, 0.12, heights, 0.45, massZ: -0.4);
        SocketSet set = Spines.EveryBone(measure) with { Stance = SocketSets.Quadruped(BodyPlan.Digitigrade).Stance };
        WalkingPlacement placement = Spines.Place(measure, set);
        Assert.NotEmpty(placement.Legs);
        Assert.All(placement.Legs, leg => Assert.True(leg.Bone < 8 && leg.Length >= (set.Stance.MinimumLength * measure.BodyLength) - 1e-9));
    }

    [Fact]
    public void A_body_on_the_ground_changes_its_plan_instead()
    {
        WalkingPlacement dog = Spines.Place(BaseBodySpines.Measure("canine", -0.3), SocketSets.Of(BodyPlan.Digitigrade));
        Assert.Empty(dog.Legs);
        Assert.Null(dog.Balance);
        Assert.Equal(WalkingRule.NoLegs, dog.Rule);
        Assert.Equal(BodyPlan.Sprawling, dog.PlanChange);
    }

    [Fact]
    public void Legs_too_long_to_pass_each_other_lower_the_body_of_a_quadruped()
    {
        SpineMeasure measure = BaseBodySpines.Measure("canine", 1.9);
        WalkingPlacement dog = Spines.Place(measure, SocketSets.Of(BodyPlan.Digitigrade));
        Assert.Equal(2, dog.Legs.Count);
        Assert.True(dog.RaiseBody < 0);
        Assert.False(LegSweep.Crosses(dog.Legs[0], dog.Legs[1]));
    }

    [Fact]
    public void The_size_of_legs_decides_whether_a_neighbouring_bone_is_free()
    {
        // One spine, one set of places; only the length of the legs differs.
        double[] widths = { 0.1, 0.1, 0.4, 0.1, 0.1, 0.38, 0.1, 0.1 };
        SpineMeasure low = Spines.Level(widths, 0.15, 0.45, bodyHeight: 1);
        SpineMeasure high = Spines.Level(widths, 0.15, 1.1, bodyHeight: 1);
        Assert.Equal(WalkingRule.TwoWidest, Spines.Choose(low, Spines.EveryBone(low)).Rule);
        Assert.Equal(new[] { 2, 5 }, Spines.Choose(low, Spines.EveryBone(low)).Sockets);
        Assert.DoesNotContain(5, Spines.Choose(high, Spines.EveryBone(high)).Sockets);
    }

    [Fact]
    public void Moving_the_body_along_the_ground_moves_its_feet_and_changes_nothing_else()
    {
        SpineMeasure here = Spines.Random(new RandomStream(77));
        var bones = new List<SpineBone>();
        foreach (SpineBone bone in here.Bones)
        {
            bones.Add(bone with { Z = bone.Z + 8 });
        }

        var there = new SpineMeasure(bones, here.BodyLength, here.BodyHeight, here.CentreBone, here.CentreOfMass with { Z = here.CentreOfMass.Z + 8 });
        SocketSet set = Spines.Free(SocketSets.ManyLegged().Legs);
        WalkingPlacement a = Spines.Place(here, set);
        WalkingPlacement b = Spines.Place(there, set);
        Assert.NotEmpty(a.Legs);
        Assert.Equal(a.Rule, b.Rule);
        Assert.Equal(a.Legs.Count, b.Legs.Count);
        for (int i = 0; i < a.Legs.Count; i++)
        {
            Assert.Equal(a.Legs[i].Site, b.Legs[i].Site);
            Assert.Equal(a.Legs[i].Foot.Z + 8, b.Legs[i].Foot.Z, 9);
        }
    }

    [Fact]
    public void Exactly_one_random_number_is_drawn()
    {
        foreach (BodyPlan plan in new[] { BodyPlan.Legless, BodyPlan.Theropod, BodyPlan.Centaur })
        {
            var stream = new RandomStream(9);
            WalkingRules.Place(BaseBodySpines.Measure("reptile", 0.9), SocketSets.Of(plan), LegSize.Nominal, stream);
            var other = new RandomStream(9);
            other.Uniform();
            Assert.Equal(other.NextUInt64(), stream.NextUInt64());
        }
    }

    [Fact]
    public void Impossible_sizes_are_errors() =>
        Assert.Throws<ArgumentOutOfRangeException>(() => WalkingRules.Place(BaseBodySpines.Measure("canine", 0.8), SocketSets.Of(BodyPlan.Digitigrade), LegSize.Nominal with { Girth = double.NaN }, new RandomStream(1)));
}
