using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>The sentences of the rules for walkers, one by one, on spines whose outcome is known.</summary>
public sealed class LegRulesTests
{
    [Fact]
    public void The_hip_width_of_a_bone_is_the_distance_between_its_left_and_right_attachment_points()
    {
        // The foot of a pillar at the side stands half a hip width out, and a little more.
        SpineMeasure measure = Spines.Level(new[] { 0.2, 0.6, 0.2 }, 0.3, 0.4);
        foreach (SpineBone bone in measure.Bones)
        {
            var site = new LimbSocket((int)bone.Ring, 8, LimbArchetype.Column, 0.5, 0, 0, SocketBounds.Limb);
            LegPlacement leg = LegFitting.Stand(measure, site, LegSize.Nominal, LegGirth.Nominal);
            Assert.Equal(0.5 * bone.HipWidth, leg.Foot.X - (0.03 * leg.Length), 9);
        }
    }

    [Theory]
    [InlineData(2.99)]
    [InlineData(3.01)]
    [InlineData(8)]
    public void A_body_longer_than_three_times_its_height_gets_as_many_legs_as_fit(double lengths)
    {
        double[] widths = { 0.1, 0.2, 0.3, 0.4, 0.3, 0.2, 0.2, 0.1, 0.1, 0.1, 0.1 };
        SpineMeasure measure = Spines.Level(widths, 0.2, 2.2 / lengths);
        (WalkingRule rule, List<int> _) = Spines.Choose(measure, Spines.EveryBone(measure));
        Assert.Equal(lengths > 3, rule == WalkingRule.AsManyAsFit);
    }

    [Theory]
    [InlineData(0.299, false)]
    [InlineData(0.301, true)]
    [InlineData(0.4, true)]
    public void A_tube_whose_narrowest_hip_is_three_quarters_of_the_widest_gets_as_many_legs_as_fit(double narrowest, bool asMany)
    {
        SpineMeasure measure = Spines.Level(new[] { 0.35, 0.4, 0.35, 0.35, narrowest, 0.35 }, 0.2, 0.8);
        Assert.Equal(asMany, Spines.Choose(measure, Spines.EveryBone(measure)).Rule == WalkingRule.AsManyAsFit);
    }

    [Fact]
    public void As_many_as_fit_is_as_many_as_any_choice_of_places_could_hold()
    {
        foreach (double height in new[] { 0.1, 0.2, 0.3, 0.45, 0.7 })
        {
            SpineMeasure measure = Spines.Level(new[] { 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3 }, 0.21, height);
            SocketSet set = Spines.EveryBone(measure);
            var field = new LegField(measure, set, set.Legs, LegSize.Nominal, LegGirth.Nominal, 0);
            Assert.Equal(GreatestSet(field), LegRules.AsManyAsFit(field).Count);
        }
    }

    [Fact]
    public void A_long_body_near_the_ground_gets_many_small_legs_and_a_tall_tube_few_large_ones()
    {
        double[] tube = { 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3 };
        WalkingPlacement low = Spines.Place(Spines.Level(tube, 0.2, 0.15), Spines.EveryBone(Spines.Level(tube, 0.2, 0.15)));
        WalkingPlacement tall = Spines.Place(Spines.Level(tube, 0.2, 1.2), Spines.EveryBone(Spines.Level(tube, 0.2, 1.2)));
        Assert.True(low.Legs.Count >= 6);
        Assert.InRange(tall.Legs.Count, 2, 3);
        Assert.True(tall.Legs[0].Length > 4 * low.Legs[0].Length);
        Assert.True(tall.Legs[0].RootRadius > 2 * low.Legs[0].RootRadius);
    }

    [Fact]
    public void Many_legs_are_spread_evenly()
    {
        SpineMeasure measure = Spines.Level(new[] { 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3 }, 0.2, 0.5);
        WalkingPlacement placement = Spines.Place(measure, Spines.EveryBone(measure));
        Assert.Equal(5, placement.Legs.Count);
        for (int i = 0; i < 5; i++)
        {
            Assert.Equal(2 * i, placement.Legs[i].Bone);
        }
    }

    [Fact]
    public void Otherwise_legs_stand_at_the_widest_bone_and_at_the_next_widest_that_does_not_overlap()
    {
        SpineMeasure measure = Spines.Level(new[] { 0.2, 0.4, 0.39, 0.2, 0.1, 0.2, 0.2, 0.35, 0.38, 0.2 }, 0.15, 0.6);
        (WalkingRule rule, List<int> sockets) = Spines.Choose(measure, Spines.EveryBone(measure));
        Assert.Equal(WalkingRule.TwoWidest, rule);
        Assert.Equal(new[] { 1, 8 }, sockets);
    }

    [Fact]
    public void Of_equally_wide_bones_the_one_nearest_the_centre_is_the_widest()
    {
        SpineMeasure measure = Spines.Level(new[] { 0.4, 0.1, 0.1, 0.4, 0.1, 0.1, 0.1, 0.1, 0.4 }, 0.15, 0.6);
        Assert.Equal(3, Spines.Choose(measure, Spines.EveryBone(measure)).Sockets[0]);
    }

    [Theory]
    [InlineData(0.301, true)]
    [InlineData(0.299, false)]
    public void The_next_widest_bone_must_have_three_quarters_of_the_width(double second, bool two)
    {
        SpineMeasure measure = Spines.Level(new[] { second, 0.1, 0.1, 0.2, 0.2, 0.4, 0.2, 0.2, 0.1, 0.1 }, 0.15, 0.55);
        Assert.Equal(two ? WalkingRule.TwoWidest : WalkingRule.OnePairAtCentre, Spines.Choose(measure, Spines.EveryBone(measure)).Rule);
    }

    [Theory]
    [InlineData(2, false)]
    [InlineData(3, true)]
    [InlineData(4, true)]
    [InlineData(5, true)]
    [InlineData(6, true)]
    [InlineData(7, true)]
    [InlineData(8, false)]
    public void One_pair_within_two_bones_of_the_centre_stays_alone_like_a_tyrannosaur(int widest, bool alone)
    {
        double[] widths = { 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15 };
        widths[widest] = 0.4;
        SpineMeasure measure = Spines.Level(widths, 0.15, 0.6);
        Assert.Equal(5, measure.CentreBone);
        (WalkingRule rule, List<int> sockets) = Spines.Choose(measure, Spines.EveryBone(measure));
        Assert.Equal(alone ? WalkingRule.OnePairAtCentre : WalkingRule.Counterweight, rule);
        Assert.Equal(alone ? 1 : 2, sockets.Count);
        Assert.Equal(widest, sockets[0]);
    }

    [Theory]
    [InlineData(0, 6)]
    [InlineData(10, 4)]
    public void A_pair_at_one_end_is_balanced_by_legs_at_the_nearest_free_bone_on_the_other_side(int widest, int nearest)
    {
        double[] widths = { 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15 };
        widths[widest] = 0.4;
        SpineMeasure measure = Spines.Level(widths, 0.15, 0.6);
        (WalkingRule rule, List<int> sockets) = Spines.Choose(measure, Spines.EveryBone(measure));
        Assert.Equal(WalkingRule.Counterweight, rule);
        Assert.Equal(new[] { widest, nearest }, sockets);
    }

    [Fact]
    public void A_nearest_bone_that_does_not_balance_gives_way_to_the_first_that_does()
    {
        double[] widths = { 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.4 };
        SpineMeasure measure = Spines.Level(widths, 0.15, 0.6, massZ: -0.15 * 2);
        Assert.Equal(new[] { 10, 1 }, Spines.Choose(measure, Spines.EveryBone(measure)).Sockets);
    }

    [Fact]
    public void When_no_bone_on_the_other_side_balances_the_nearest_is_taken()
    {
        double[] widths = { 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.15, 0.4 };
        SpineMeasure measure = Spines.Level(widths, 0.15, 0.6, massZ: 3);
        Assert.Equal(new[] { 10, 4 }, Spines.Choose(measure, Spines.EveryBone(measure)).Sockets);
    }

    [Fact]
    public void Each_chosen_bone_is_served_by_the_nearest_place_of_the_anatomy()
    {
        // The widest bones are 4 (ring 31) and 9 (ring 41); the places are at rings 28 and 39.
        SpineMeasure measure = Spines.Level(new[] { 0.1, 0.1, 0.1, 0.2, 0.4, 0.2, 0.1, 0.1, 0.1, 0.38, 0.1 }, 0.15, 0.55);
        var places = new[]
        {
            new LimbSocket(28, 8, LimbArchetype.UnguligradeFore, 0.2, 0, 0, SocketBounds.Limb),
            new LimbSocket(39, 8, LimbArchetype.UnguligradeHind, 0.2, 0, 0, SocketBounds.Limb),
        };
        (WalkingRule rule, List<int> sockets) = Spines.Choose(measure, Spines.Free(places));
        Assert.Equal(WalkingRule.TwoWidest, rule);
        Assert.Equal(new[] { 0, 1 }, sockets);
    }

    [Fact]
    public void Whatever_the_body_no_two_chosen_pairs_overlap()
    {
        var stream = new RandomStream(21);
        for (int n = 0; n < 1500; n++)
        {
            SpineMeasure measure = Spines.Random(stream);
            SocketSet set = Spines.Free(SocketSets.ManyLegged().Legs);
            var field = new LegField(measure, set, set.Legs, LegSize.Nominal, LegGirth.Nominal, 0);
            List<int> sockets = LegRules.Choose(field).Sockets;
            foreach (int a in sockets)
            {
                foreach (int b in sockets)
                {
                    Assert.False(a != b && LegSweep.Crosses(field[a], field[b]));
                }
            }
        }
    }

    private static int GreatestSet(LegField field)
    {
        int greatest = 0;
        for (int subset = 0; subset < 1 << field.Count; subset++)
        {
            int count = 0;
            bool clear = true;
            for (int i = 0; i < field.Count && clear; i++)
            {
                if ((subset >> i & 1) == 0)
                {
                    continue;
                }

                count++;
                for (int j = 0; j < i && clear; j++)
                {
                    clear = (subset >> j & 1) == 0 || !LegSweep.Crosses(field[i], field[j]);
                }
            }

            greatest = clear ? Math.Max(greatest, count) : greatest;
        }

        return greatest;
    }
}
