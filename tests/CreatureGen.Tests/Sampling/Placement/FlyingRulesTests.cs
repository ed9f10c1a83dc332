using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>The sentences of the rules for fliers, one by one.</summary>
public sealed class FlyingRulesTests
{
    private static readonly SpineMeasure Body = Spines.Level(new[] { 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3, 0.3 }, 0.1, 1, thickness: 0.3);

    [Fact]
    public void Buzzing_wings_sit_on_a_random_bone_of_the_front_half_scaled_in_each_direction()
    {
        var bones = new HashSet<int>();
        for (ulong seed = 0; seed < 200; seed++)
        {
            WingPlacement wing = Assert.Single(Place(WingMotion.Buzzing, 1, new FlyingLegs(0, LegArrangement.Spread), seed).Wings);
            bones.Add(wing.Bone);
            Assert.Equal(Body.Bones[wing.Bone].Ring, wing.Ring);
            Assert.Null(wing.Socket);
            Assert.True(wing.Scale.X != wing.Scale.Y && wing.Scale.Y != wing.Scale.Z && wing.Scale.X != wing.Scale.Z);
        }

        Assert.Equal(5, bones.Count);
        Assert.All(bones, bone => Assert.InRange(bone, 0, 4));
    }

    [Fact]
    public void A_second_buzzing_pair_stays_in_the_front_half_clear_of_the_first()
    {
        for (ulong seed = 0; seed < 200; seed++)
        {
            IReadOnlyList<WingPlacement> wings = Place(WingMotion.Buzzing, 2, new FlyingLegs(0, LegArrangement.Spread), seed).Wings;
            Assert.Equal(2, wings.Count);
            Assert.True(wings[1].Ring - wings[0].Ring >= FlyingRules.WingRingGap);
            Assert.InRange(wings[1].Bone, 0, 4);
        }
    }

    [Fact]
    public void Flapping_wings_sit_left_and_right_at_the_shoulders_scaled_uniformly()
    {
        var scales = new HashSet<double>();
        for (ulong seed = 0; seed < 50; seed++)
        {
            WingPlacement wing = Assert.Single(Place(WingMotion.Flapping, 1, new FlyingLegs(0, LegArrangement.Spread), seed).Wings);
            Assert.Equal(new SocketBlueprint(25, 4, 4, 4), wing.Socket);
            Assert.Equal(Body.BoneAt(27), wing.Bone);
            Assert.True(wing.Scale.X == wing.Scale.Y && wing.Scale.Y == wing.Scale.Z);
            scales.Add(wing.Scale.X);
        }

        Assert.Equal(50, scales.Count);
    }

    [Fact]
    public void There_are_none_to_eight_pairs_of_legs_clustered_or_not()
    {
        var stream = new RandomStream(4);
        var seen = new HashSet<FlyingLegs>();
        for (int n = 0; n < 1000; n++)
        {
            FlyingLegs legs = FlyingRules.DrawLegs(stream);
            Assert.InRange(legs.Pairs, 0, 8);
            seen.Add(legs);
        }

        Assert.Equal(18, seen.Count);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(8)]
    public void A_long_thin_body_carries_as_many_pairs_as_it_asks_for(int pairs)
    {
        for (ulong seed = 0; seed < 50; seed++)
        {
            Assert.Equal(pairs, Place(WingMotion.Buzzing, 1, new FlyingLegs(pairs, LegArrangement.Clustered), seed).Legs.Count);
            Assert.Equal(pairs, Place(WingMotion.Buzzing, 1, new FlyingLegs(pairs, LegArrangement.Spread), seed).Legs.Count);
        }
    }

    [Fact]
    public void The_more_legs_the_smaller_they_are()
    {
        for (int pairs = 2; pairs <= 8; pairs++)
        {
            Assert.True(FlyingRules.LegFactor(pairs) < FlyingRules.LegFactor(pairs - 1));
            FlyingPlacement fewer = Place(WingMotion.Buzzing, 1, new FlyingLegs(pairs - 1, LegArrangement.Clustered), 3);
            FlyingPlacement more = Place(WingMotion.Buzzing, 1, new FlyingLegs(pairs, LegArrangement.Clustered), 3);
            Assert.True(more.Legs[0].Length < fewer.Legs[0].Length);
            Assert.True(more.LegFactor < fewer.LegFactor);
            Assert.All(more.Legs, leg => Assert.Equal(more.Legs[0].Length, leg.Length, 12));
        }

        Assert.Equal(1, 4 * FlyingRules.LegFactor(4) * FlyingRules.LegFactor(4), 12);
    }

    [Fact]
    public void Clustered_legs_start_at_a_random_bone_of_the_front_half_and_gather_around_it()
    {
        var firsts = new HashSet<int>();
        for (ulong seed = 0; seed < 200; seed++)
        {
            firsts.Add(Assert.Single(Place(WingMotion.Buzzing, 1, new FlyingLegs(1, LegArrangement.Clustered), seed).Legs).Bone);
            IReadOnlyList<LegPlacement> legs = Place(WingMotion.Buzzing, 1, new FlyingLegs(3, LegArrangement.Clustered), seed).Legs;
            Assert.Contains(legs, leg => leg.Bone <= 4);

            // No free place is left between the legs of a cluster.
            for (int i = 1; i < legs.Count; i++)
            {
                foreach (LimbSocket site in FlierLegAnatomy.Insect.Sockets)
                {
                    if (site.Ring > legs[i - 1].Site.Ring && site.Ring < legs[i].Site.Ring)
                    {
                        LegPlacement between = LegFitting.Hang(Body, site, FlierLegAnatomy.Insect.Size, legs[0].Length, legs[0].Length / (0.55 * Body.BodyLength));
                        Assert.True(LegSweep.Crosses(between, legs[i - 1]) || LegSweep.Crosses(between, legs[i]));
                    }
                }
            }
        }

        Assert.Equal(5, firsts.Count);
    }

    [Theory]
    [InlineData(2)]
    [InlineData(4)]
    [InlineData(6)]
    public void Legs_that_are_not_clustered_are_evenly_spaced(int pairs)
    {
        IReadOnlyList<LegPlacement> legs = Place(WingMotion.Buzzing, 1, new FlyingLegs(pairs, LegArrangement.Spread), 5).Legs;
        double stretch = (39 - 22) * 0.05;
        for (int i = 0; i < pairs; i++)
        {
            double even = Body.At(22).Along + (stretch * (i + 0.5) / pairs);
            Assert.Equal(even, legs[i].Along, 0.025 + 1e-9);
        }
    }

    [Fact]
    public void When_no_bone_is_free_for_all_there_are_fewer_and_larger_legs()
    {
        FlyingPlacement bird = FlyingRules.Place(Body, WingMotion.Flapping, 1, new FlyingLegs(8, LegArrangement.Spread), FlierLegAnatomy.Bird, new SocketGrid(), new Seed(2));
        LegPlacement leg = Assert.Single(bird.Legs);
        Assert.Equal(37, leg.Site.Ring);
        Assert.InRange(bird.LegFactor, 0.9, 1.1);
        FlyingPlacement dragon = FlyingRules.Place(Body, WingMotion.Flapping, 1, new FlyingLegs(2, LegArrangement.Spread), FlierLegAnatomy.Dragon, new SocketGrid(), new Seed(2));
        Assert.Equal(2, dragon.Legs.Count);
        Assert.InRange(dragon.Legs[0].Site.Ring, 24, 28);
        Assert.InRange(dragon.Legs[1].Site.Ring, 38, 41);
    }

    [Fact]
    public void Legs_and_wings_never_cross_one_another_nor_what_was_there_before()
    {
        var stream = new RandomStream(6);
        FlierLegAnatomy[] anatomies = { FlierLegAnatomy.Bird, FlierLegAnatomy.Dragon, FlierLegAnatomy.Insect };
        for (int n = 0; n < 1500; n++)
        {
            SpineMeasure measure = Spines.Random(stream);
            var grid = new SocketGrid();
            grid.TryReserve(new SocketBlueprint(stream.Integer(20, 40), stream.Integer(4, 10), 4, 4), 0);
            int before = grid.TakenCells;
            WingMotion motion = stream.Chance(0.5) ? WingMotion.Buzzing : WingMotion.Flapping;
            FlyingPlacement placement = FlyingRules.Place(measure, motion, 1, FlyingRules.DrawLegs(stream), anatomies[n % 3], grid, new Seed((ulong)n));
            Assert.Equal(before, grid.TakenCells);
            foreach (WingPlacement wing in placement.Wings)
            {
                Assert.True(wing.Socket is null || grid.TryReserve(wing.Socket, 1));
            }

            for (int i = 0; i < placement.Legs.Count; i++)
            {
                Assert.True(grid.TryReserve(placement.Legs[i].Socket, placement.Legs[i].Site.Bounds.Pad));
                for (int j = 0; j < i; j++)
                {
                    Assert.False(LegSweep.Crosses(placement.Legs[i], placement.Legs[j]));
                    Assert.True(placement.Legs[j].Along < placement.Legs[i].Along);
                }
            }
        }
    }

    [Fact]
    public void The_same_seed_gives_the_same_limbs_and_legs_do_not_depend_on_wings()
    {
        FlyingPlacement a = Place(WingMotion.Buzzing, 2, new FlyingLegs(4, LegArrangement.Clustered), 12);
        FlyingPlacement b = Place(WingMotion.Buzzing, 2, new FlyingLegs(4, LegArrangement.Clustered), 12);
        Assert.Equal(a.Legs, b.Legs);
        Assert.Equal(a.Wings, b.Wings);
        Assert.Equal(a.Legs, Place(WingMotion.Buzzing, 1, new FlyingLegs(4, LegArrangement.Clustered), 12).Legs);
    }

    [Fact]
    public void Impossible_numbers_of_pairs_are_errors()
    {
        Assert.Throws<ArgumentOutOfRangeException>(() => Place(WingMotion.Buzzing, 1, new FlyingLegs(9, LegArrangement.Spread), 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Place(WingMotion.Buzzing, 1, new FlyingLegs(-1, LegArrangement.Spread), 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Place(WingMotion.Flapping, 2, new FlyingLegs(1, LegArrangement.Spread), 1));
        Assert.Throws<ArgumentOutOfRangeException>(() => Place(WingMotion.Buzzing, 0, new FlyingLegs(1, LegArrangement.Spread), 1));
    }

    private static FlyingPlacement Place(WingMotion motion, int wings, FlyingLegs legs, ulong seed) =>
        FlyingRules.Place(Body, motion, wings, legs, FlierLegAnatomy.Insect, new SocketGrid(), new Seed(seed));
}
