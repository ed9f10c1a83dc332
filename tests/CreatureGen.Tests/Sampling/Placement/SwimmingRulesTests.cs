using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling.Placement;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Sampling.Placement;

/// <summary>The sentences of the rules for swimmers, one by one.</summary>
public sealed class SwimmingRulesTests
{
    private static readonly BodyPlan[] Plans = { BodyPlan.Fish, BodyPlan.Eel, BodyPlan.Whale, BodyPlan.Flipper };
    private static readonly SpineMeasure Body = BaseBodySpines.Measure("fish", 1);

    [Fact]
    public void The_number_of_dorsal_fins_is_random()
    {
        FinAnatomy shark = FinAnatomy.Fish with { Dorsals = new CountRange(0, 3), MidlineRows = new CountRange(4, 6) };
        var counts = new HashSet<int>();
        for (ulong seed = 0; seed < 200; seed++)
        {
            counts.Add(Fins(shark, seed, FinPlace.Dorsal).Count);
        }

        Assert.Equal(4, counts.Count);
    }

    [Fact]
    public void Dorsal_fins_of_random_outline_sit_on_random_bones_on_top_of_the_back_scaled_in_each_direction()
    {
        var bones = new HashSet<int>();
        var styles = new HashSet<FinStyle>();
        for (ulong seed = 0; seed < 300; seed++)
        {
            FinPlacement fin = Fins(FinAnatomy.Fish, seed, FinPlace.Dorsal)[0];
            Assert.Equal(31, fin.Socket.Segment);
            Assert.Equal(2, fin.Socket.Columns);
            Assert.Equal(0, fin.Socket.Rows % 2);
            Assert.Equal(Body.Bones[fin.Bone].Ring, fin.Socket.Ring + (0.5 * fin.Socket.Rows), 0.5);
            Assert.True(fin.Scale.X != fin.Scale.Y && fin.Scale.Y != fin.Scale.Z);
            bones.Add(fin.Bone);
            styles.Add(fin.Style);
        }

        Assert.True(bones.Count >= 9);
        Assert.Equal(7, styles.Count);
    }

    [Fact]
    public void The_scale_along_the_body_is_the_length_of_the_fins_root()
    {
        FinAnatomy fixedRows = FinAnatomy.Fish with { Dorsals = new CountRange(1, 1), MidlineRows = new CountRange(10, 10) };
        for (ulong seed = 0; seed < 100; seed++)
        {
            FinPlacement fin = Fins(fixedRows, seed, FinPlace.Dorsal)[0];
            Assert.Equal(10 * fin.Scale.Z, fin.Socket.Rows, 1.0);
        }
    }

    [Fact]
    public void A_fin_is_left_out_when_no_bone_is_free_of_crossing_the_others()
    {
        FinAnatomy crowded = FinAnatomy.Fish with { Dorsals = new CountRange(9, 9), MidlineRows = new CountRange(12, 12) };
        for (ulong seed = 0; seed < 100; seed++)
        {
            Assert.InRange(Fins(crowded, seed, FinPlace.Dorsal).Count, 1, 2);
        }

        var full = new SocketGrid();
        full.TryReserve(new SocketBlueprint(20, 31, 28, 2), 0);
        Assert.DoesNotContain(SwimmingRules.Place(Body, FinAnatomy.Fish, full, new Seed(1)).Fins, fin => fin.Place == FinPlace.Dorsal);
    }

    [Fact]
    public void Pectoral_fins_sit_left_and_right_at_the_places_of_the_plan()
    {
        for (ulong seed = 0; seed < 100; seed++)
        {
            foreach (BodyPlan plan in Plans)
            {
                FinAnatomy anatomy = FinAnatomy.Of(plan);
                List<FinPlacement> fins = Fins(anatomy, seed, FinPlace.Pectoral);
                Assert.InRange(fins.Count, anatomy.Pectorals.Min, anatomy.Pectorals.Max);
                Assert.All(fins, fin => Assert.Contains(anatomy.Flanks, site => SocketSizing.Centre(site.Ring, site.Segment, 4, 2) == fin.Socket));
            }

            Assert.Equal(new[] { 23, 39 }, Fins(FinAnatomy.Flipper, seed, FinPlace.Pectoral).Select(fin => fin.Socket.Ring).OrderBy(ring => ring));
        }
    }

    [Fact]
    public void Most_fish_have_their_first_paired_fins_close_behind_the_head()
    {
        int behindHead = 0;
        for (ulong seed = 0; seed < 500; seed++)
        {
            behindHead += Fins(FinAnatomy.Fish, seed, FinPlace.Pectoral).Any(fin => fin.Socket.Ring < 24) ? 1 : 0;
        }

        Assert.InRange(behindHead, 450, 500);
    }

    [Fact]
    public void The_tail_has_an_outline_of_the_plan_and_a_size_in_each_direction()
    {
        var styles = new HashSet<TailStyle>();
        for (ulong seed = 0; seed < 100; seed++)
        {
            TailPlacement tail = SwimmingRules.Place(Body, FinAnatomy.Fish, new SocketGrid(), new Seed(seed)).Tail;
            styles.Add(tail.Style);
            Assert.InRange(tail.Scale.X, 0.8, 1.2);
            Assert.True(tail.Scale.X != tail.Scale.Y && tail.Scale.Y != tail.Scale.Z);
            Assert.Equal(TailStyle.Fluke, SwimmingRules.Place(Body, FinAnatomy.Whale, new SocketGrid(), new Seed(seed)).Tail.Style);
        }

        Assert.True(styles.SetEquals(FinAnatomy.Fish.Tails.Select(choice => choice.Style)));
        Assert.True(styles.Count >= 6);
    }

    [Fact]
    public void Fins_never_cross_and_stay_between_neck_and_tail_fin()
    {
        var stream = new RandomStream(15);
        for (int n = 0; n < 1000; n++)
        {
            SpineMeasure measure = Spines.Random(stream);
            FinAnatomy anatomy = FinAnatomy.Of(Plans[n % 4]) with { Dorsals = new CountRange(0, 4), Ventrals = new CountRange(0, 2) };
            var occupied = new SocketGrid();
            SwimmingPlacement placement = SwimmingRules.Place(measure, anatomy, occupied, new Seed((ulong)n));
            Assert.Equal(0, occupied.TakenCells);
            foreach (FinPlacement fin in placement.Fins)
            {
                Assert.True(occupied.TryReserve(fin.Socket, 1));
                Assert.True(fin.Place == FinPlace.Pectoral || (fin.Socket.Ring >= 22 && fin.Socket.Ring + fin.Socket.Rows <= 47));
            }
        }
    }

    [Fact]
    public void The_same_seed_gives_the_same_fins_and_one_kind_does_not_depend_on_another()
    {
        SwimmingPlacement a = SwimmingRules.Place(Body, FinAnatomy.Fish, new SocketGrid(), new Seed(8));
        SwimmingPlacement b = SwimmingRules.Place(Body, FinAnatomy.Fish, new SocketGrid(), new Seed(8));
        Assert.Equal(a.Fins, b.Fins);
        Assert.Equal(a.Tail, b.Tail);
        FinAnatomy bare = FinAnatomy.Fish with { Dorsals = new CountRange(0, 0) };
        Assert.Equal(Fins(FinAnatomy.Fish, 8, FinPlace.Pectoral), Fins(bare, 8, FinPlace.Pectoral));
    }

    [Fact]
    public void Only_swimming_plans_have_fins() => Assert.Throws<ArgumentOutOfRangeException>(() => FinAnatomy.Of(BodyPlan.Theropod));

    private static List<FinPlacement> Fins(FinAnatomy anatomy, ulong seed, FinPlace place) =>
        SwimmingRules.Place(Body, anatomy, new SocketGrid(), new Seed(seed)).Fins.Where(fin => fin.Place == place).ToList();
}
