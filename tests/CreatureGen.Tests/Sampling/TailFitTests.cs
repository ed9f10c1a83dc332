using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Bodies;
using CreatureGen.Blueprints;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Parents;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class TailFitTests
{
    private const ulong First = 12700001;
    private const int Count = 120;

    /// <summary>Thickest abdomen in trunks, how high the end of a tail that rolls up is over its root in lengths of it (.89 without the rule), and least fall of a flier's tail for each unit that it goes back.</summary>
    private const double ThickestAbdomen = 0.84;
    private const double HighestRolled = 0.4;
    private const double LeastFlown = 0.05;

    /// <summary>Thickest end of a tail as the tables give it, two thirds along it, and thickest tip in its thickest section (.67 and .34 of the first without the rule), and least fall of an abdomen for each unit that it goes back (level ones without it).</summary>
    private const double ThickestEnd = 0.6;
    private const double ThickestTip = 0.25;
    private const double LeastAbdomen = 0.14;

    /// <summary>Least fall of a tail with a tuft or a club for each unit that it goes back (the first one without the rule rises by .38).</summary>
    private const double LeastWeighted = 0.12;

    /// <summary>The same of a swimmer's with flukes (the least tenth is below .005 without the rule).</summary>
    private const double LeastSunk = 0.08;

    /// <summary>Least tail of a swimmer that is driven by it, in trunks: what the lattice leaves of the rule's .5 (.16 without).</summary>
    private const double LeastDriven = 0.4;

    /// <summary>The same of one that rows, least slope and steepest of a fluke, degrees: steeper ones are tents from behind, those that rise bowls.</summary>
    private const double LeastRowing = 0.38;
    private const double RisingFluke = 0;
    private const double FallingFluke = 20;

    private static readonly ValueList<LatticeSlice> even = new(Enumerable.Repeat(new LatticeSlice(1, 1, 1), 11));

    [Fact]
    public void A_birds_tail_without_feathers_comes_to_a_point()
    {
        ValueList<LatticeSlice> slices = TailFit.Point(Mixed("parrot", 0.6), even);
        Assert.Equal(even.Take(8), slices.Take(8));
        Assert.Equal(new LatticeSlice(0.35, 0.35, 1), slices[10]);
        Assert.True(slices[8].Width > slices[9].Width && slices[9].Width > slices[10].Width);
    }

    [Fact]
    public void The_tail_of_a_mixed_swimmer_runs_out()
    {
        SpeciesProfile first = SpeciesCatalogue.Find("crocodile");
        var swimmer = new CreatureBuilder(new Seed(1), LocomotionKind.Swimming, new Parentage(first, first, first), BodyPlan.Eel, strangeness: 0.6);
        ValueList<LatticeSlice> slices = TailFit.Point(swimmer, even);
        Assert.Equal(even.Take(8), slices.Take(8));
        Assert.Equal(new LatticeSlice(0.4, 0.4, 1), slices[10]);
    }

    [Theory]
    [InlineData("parrot", 0)]
    [InlineData("bear", 0.6)]
    public void Tails_of_animals_and_of_others_than_birds_stay_as_they_are(string tail, double strangeness) =>
        Assert.Equal(even, TailFit.Point(Mixed(tail, strangeness), even));

    [Fact]
    public void A_paddle_runs_out_in_a_point_and_a_club_ends_in_a_knob()
    {
        TailTaper paddle = TailTaper.Of(TailStyle.Paddle)!;
        Assert.True(paddle.At(0.55).Height > 1.1 && paddle.At(1).Height < 0.15 && paddle.At(1).Width < 0.1);
        TailTaper club = TailTaper.Of(TailStyle.Club)!;
        Assert.True(club.At(0.9).Width > 3 * club.At(0.7).Width);
    }

    [Theory]
    [InlineData(0, -0.5, 0.1)]
    [InlineData(0.6, -0.9, -0.3)]
    public void Fans_of_rays_end_rounder_on_mixed_creatures(double strangeness, double roundest, double straightest)
    {
        CreatureBuilder builder = Mixed("fish", strangeness);
        for (ulong seed = 1; seed <= 40; seed++)
        {
            Assert.InRange(TailSampler.FanFork(builder, new RandomStream(seed)), roundest, straightest);
        }
    }

    [Theory]
    [InlineData("ant", 0.6, TailStyle.Saurian)]
    [InlineData("fish", 0.6, TailStyle.Saurian)]
    [InlineData("bovine", 0.6, TailStyle.Plain)]
    [InlineData("reptile", 0.6, TailStyle.Plain)]
    [InlineData("ant", 0, TailStyle.Plain)]
    public void Abdomens_and_tails_without_their_fin_run_out_evenly_on_other_bodies(string tail, double strangeness, TailStyle style) =>
        Assert.Equal(style, TailSampler.Other(Mixed(tail, strangeness)).Style);

    [Fact]
    public void A_furred_tail_on_bare_skin_runs_out_evenly()
    {
        CreatureBuilder furred = Mixed("bovine", 0.6);
        var bare = new CreatureBuilder(new Seed(1), LocomotionKind.Walking, furred.Parents with { Skin = SpeciesCatalogue.Find("frog") }, BodyPlan.Plantigrade, strangeness: 0.6);
        Assert.Equal(TailStyle.Saurian, TailSampler.Other(bare).Style);
    }

    [Fact]
    public void No_tail_of_a_family_swells_behind_its_root_and_none_is_a_peg()
    {
        int tails = 0;
        for (ulong seed = 10095001; seed <= 10095060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            if (creature.Tail.Style is not (TailStyle.Saurian or TailStyle.Whip))
            {
                continue;
            }

            tails++;
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double Size(int ring) => Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
            double length = shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.TorsoLast];
            Assert.True(length > 6 * Size(StationRing.TailStem), FormattableString.Invariant($"{seed}: a tail of {length / Size(StationRing.TailStem):0.0} radii of its root"));
            for (int ring = StationRing.TailBase; ring <= StationRing.TailTip; ring++)
            {
                Assert.True(Size(ring) < 1.03 * Size(ring - 1), FormattableString.Invariant($"{seed}: ring {ring} is {Size(ring) / Size(ring - 1):0.00} of the one before it"));
            }

            Assert.True(Size(StationRing.TailTip) < 0.25 * Size(StationRing.TailStem), $"{seed}: a blunt tip");
        }

        Assert.InRange(tails, 8, 60);
    }

    [Fact]
    public void A_bare_tail_behind_legs_is_slender_and_is_seen_from_behind()
    {
        int tails = 0;
        for (ulong seed = 10772001; seed <= 10772080; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            bool above = creature.Plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Centaur;
            bool haired = creature.Manes.Any(mane => mane.Ring >= StationRing.TorsoLast);
            if (!above || haired || creature.Tail.Style is not (TailStyle.Plain or TailStyle.Saurian or TailStyle.Whip or TailStyle.Paddle))
            {
                continue;
            }

            tails++;
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double length = shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.TorsoLast];
            double root = Math.Sqrt(shape.Width[StationRing.TailStem] * 0.5 * (shape.Top[StationRing.TailStem] + shape.Bottom[StationRing.TailStem]));
            double down = shape.Y[StationRing.TorsoLast] - shape.Y[StationRing.TailTip];
            double back = shape.Z[StationRing.TorsoLast] - shape.Z[StationRing.TailTip];
            Assert.True(length > 9 * root, FormattableString.Invariant($"{seed}: {length / root:0.0} radii"));
            Assert.True(down > 0.2 * back, FormattableString.Invariant($"{seed}: comes down by {down / back:0.00} of what it goes back"));
        }

        Assert.InRange(tails, 8, 80);
    }

    [Fact]
    public void A_tail_with_a_tuft_or_a_club_at_its_end_comes_down_behind_a_mixed_body()
    {
        int tails = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Walking, 0.6, First, 2 * Count))
        {
            bool stands = creature.Plan is BodyPlan.Sprawling or BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar or BodyPlan.Centaur;
            bool haired = creature.Tail.Style == TailStyle.Plain && creature.Manes.Any(mane => mane.Ring >= StationRing.TorsoLast);
            if (!stands || !(haired || creature.Tail.Style == TailStyle.Club))
            {
                continue;
            }

            double down = shape.Y[StationRing.TorsoLast] - shape.Y[StationRing.TailTip];
            double back = shape.Z[StationRing.TorsoLast] - shape.Z[StationRing.TailTip];
            Assert.True(down > LeastWeighted * back, FormattableString.Invariant($"{creature.Seed} {creature.Plan} {creature.Tail.Style}: comes down by {down / back:0.00} of what it goes back"));
            tails++;
        }

        Assert.InRange(tails, 8, Count);
    }

    [Fact]
    public void The_abdomen_of_a_mixed_insect_does_not_turn_down_at_its_end()
    {
        int abdomens = 0;
        for (ulong seed = 10772001; seed <= 10772080; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying });
            if (SpeciesCatalogue.Find(creature.Body.Blend.Bodies[0].Name).Class != AnimalClass.Arthropod || creature.Tail.Style != TailStyle.Plain)
            {
                continue;
            }

            abdomens++;
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double end = 180 / Math.PI * shape.Pitch[StationRing.TailTip];
            Assert.True(end < 45, FormattableString.Invariant($"{seed}: {end:0} degrees"));
        }

        Assert.InRange(abdomens, 8, 80);
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    public void A_tail_as_the_tables_give_it_runs_out(RequestedKind kind)
    {
        int tails = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(kind, 0.6, First, Count))
        {
            if (creature.Tail.Style == TailStyle.Plain && creature.Body.Disc.Sweep == 0)
            {
                double largest = Largest(shape, StationRing.TailStem, StationRing.TailTip);
                double end = Largest(shape, StationRing.TailTwoThirds, StationRing.TailTwoThirds) / largest;
                double tip = Largest(shape, StationRing.TailTip, StationRing.TailTip) / largest;
                Assert.True(end < ThickestEnd && tip < ThickestTip, FormattableString.Invariant($"{creature.Seed} {creature.Plan}: {end:0.00} of its thickness at two thirds, {tip:0.00} at its tip"));
                tails++;
            }
        }

        Assert.InRange(tails, 20, Count);
    }

    [Fact]
    public void Four_of_five_abdomens_of_mixed_insects_come_down()
    {
        int abdomens = 0;
        int level = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Walking, 0.6, First, Count))
        {
            if (creature.Plan == BodyPlan.Hexapod && creature.Tail.Style == TailStyle.Plain && SpeciesCatalogue.Find(creature.Body.Blend.Bodies[0].Name).Class == AnimalClass.Arthropod)
            {
                double down = shape.Y[StationRing.TorsoLast] - shape.Y[StationRing.TailTip];
                double back = shape.Z[StationRing.TorsoLast] - shape.Z[StationRing.TailTip];
                level += down > LeastAbdomen * back ? 0 : 1;
                abdomens++;
            }
        }

        Assert.InRange(abdomens, 10, Count);
        Assert.True(5 * level <= abdomens, FormattableString.Invariant($"{level} of {abdomens} are level"));
    }

    [Fact]
    public void The_abdomen_of_a_mixed_insect_is_no_thicker_than_its_trunk()
    {
        int abdomens = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Flying, 1, First, Count))
        {
            if (SpeciesCatalogue.Find(creature.Body.Blend.Bodies[0].Name).Class == AnimalClass.Arthropod && creature.Tail.Style == TailStyle.Plain)
            {
                double size = Largest(shape, StationRing.TailStem, StationRing.TailTip) / Largest(shape, StationRing.WingRoot, StationRing.Pelvis);
                Assert.True(size < ThickestAbdomen, FormattableString.Invariant($"{creature.Seed}: an abdomen of {size:0.00} trunks"));
                abdomens++;
            }
        }

        Assert.InRange(abdomens, 8, Count);
    }

    [Fact]
    public void A_tail_that_rolls_up_is_no_rod_over_the_back()
    {
        int tails = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Walking, 1, First, Count))
        {
            if (creature.Tail.Style == TailStyle.Prehensile && creature.Plan != BodyPlan.Upright)
            {
                double rise = shape.Y[StationRing.TailTip] - shape.Y[StationRing.TorsoLast];
                double length = shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.TorsoLast];
                Assert.True(rise < HighestRolled * length, FormattableString.Invariant($"{creature.Seed} {creature.Plan}: a tail that rises by {rise / length:0.00} of its length"));
                tails++;
            }
        }

        Assert.InRange(tails, 3, Count);
    }

    [Fact]
    public void Nine_of_ten_bare_tails_of_mixed_fliers_come_down_below_the_rump()
    {
        int tails = 0;
        int level = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Flying, 1, First, Count))
        {
            bool haired = creature.Manes.Any(mane => mane.Ring >= StationRing.TorsoLast);
            if (creature.Plan == BodyPlan.Flapping && !haired && creature.Tail.Style is TailStyle.Plain or TailStyle.Saurian or TailStyle.Whip or TailStyle.Paddle
                && SpeciesCatalogue.Find(creature.Body.Blend.Bodies[0].Name).Class != AnimalClass.Arthropod)
            {
                double down = shape.Y[StationRing.TorsoLast] - shape.Y[StationRing.TailTip];
                double back = shape.Z[StationRing.TorsoLast] - shape.Z[StationRing.TailTip];
                level += down > LeastFlown * back ? 0 : 1;
                tails++;
            }
        }

        // Those that would reach the ground are raised again.
        Assert.InRange(tails, 20, Count);
        Assert.True(10 * level <= tails, FormattableString.Invariant($"{level} of {tails} tails do not come down"));
    }

    [Fact]
    public void Nine_of_ten_swimmers_that_are_driven_by_their_tails_do_not_end_in_a_wall_with_a_fin_on_it()
    {
        int driven = 0;
        int walls = 0;
        foreach ((CreatureBlueprint creature, BodyShape shape) in DrawnShapes.Of(RequestedKind.Swimming, 0.6, 13660001, Count))
        {
            if (creature.Plan is BodyPlan.Fish or BodyPlan.Whale or BodyPlan.Eel && creature.Body.Disc.Sweep == 0)
            {
                double tail = (shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.TorsoLast]) / (shape.Arc[StationRing.TorsoLast] - shape.Arc[StationRing.TrunkFirst]);
                walls += tail > LeastDriven ? 0 : 1;
                driven++;
            }
        }

        Assert.InRange(driven, 20, Count);
        Assert.True(10 * walls <= driven, FormattableString.Invariant($"{walls} of {driven} end in a wall"));
    }

    [Fact]
    public void Nine_of_ten_tails_with_flukes_show_them_from_behind()
    {
        int flukes = 0;
        int level = 0;
        for (ulong seed = 13660001; seed < 13660001 + Count; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            if (creature.Tail.Style == TailStyle.Fluke)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double down = shape.Y[StationRing.TorsoLast] - shape.Y[StationRing.TailTip];
                double back = shape.Z[StationRing.TorsoLast] - shape.Z[StationRing.TailTip];
                level += down > LeastSunk * back ? 0 : 1;
                flukes++;
            }
        }

        Assert.InRange(flukes, 10, Count);
        Assert.True(10 * level <= flukes, FormattableString.Invariant($"{level} of {flukes} are seen edge on"));
    }

    [Fact]
    public void Flukes_lie_nearly_level()
    {
        double[] slopes = DrawnShapes.Of(RequestedKind.Swimming, 1, 13660001, Count)
            .Where(drawn => drawn.Creature.Tail.Style == TailStyle.Fluke && drawn.Creature.Body.Disc.Sweep == 0)
            .Select(drawn => Math.Atan2(drawn.Shape.Y[StationRing.TailTwoThirds] - drawn.Shape.Y[StationRing.TailTip], drawn.Shape.Z[StationRing.TailTwoThirds] - drawn.Shape.Z[StationRing.TailTip]) * 180 / Math.PI)
            .ToArray();
        Assert.InRange(slopes.Length, 10, Count);
        int steep = slopes.Count(slope => slope < RisingFluke || slope > FallingFluke);
        Assert.True(8 * steep <= slopes.Length, FormattableString.Invariant($"{steep} of {slopes.Length}: {string.Join(" ", slopes.Select(slope => FormattableString.Invariant($"{slope:0}")))}"));
    }

    [Fact]
    public void What_rows_has_a_tail()
    {
        double[] tails = DrawnShapes.Of(RequestedKind.Swimming, 1, 13660001, Count)
            .Where(drawn => drawn.Creature.Plan == BodyPlan.Flipper && drawn.Creature.Body.Disc.Sweep == 0 && drawn.Creature.Body.Shell.Style == ShellStyle.None)
            .Select(drawn => (drawn.Shape.Arc[StationRing.TailTip] - drawn.Shape.Arc[StationRing.TorsoLast]) / (drawn.Shape.Arc[StationRing.TorsoLast] - drawn.Shape.Arc[StationRing.TrunkFirst]))
            .ToArray();
        Assert.InRange(tails.Length, 10, Count);
        Assert.True(tails.Count(tail => tail < LeastRowing) * 10 <= tails.Length, FormattableString.Invariant($"{string.Join(" ", tails.Select(tail => FormattableString.Invariant($"{tail:0.00}")))}"));
    }

    [Fact]
    public void A_tail_with_a_sting_bends_over_the_back()
    {
        double[] ahead = Enumerable.Range(0, 80)
            .Select(i => BlueprintSampler.Sample(23371000 + (ulong)i, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 1 }))
            .Where(creature => creature.Tail.Style == TailStyle.Stinger)
            .Select(creature => BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail))
            .Select(shape => (shape.Z[StationRing.TailTip] - shape.Z.Min()) / (shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.TorsoLast]))
            .ToArray();
        Assert.NotEmpty(ahead);
        Assert.True(ahead.Count(tip => tip > 0.04) * 2 > ahead.Length, FormattableString.Invariant($"tips ahead of their rearmost ring by {string.Join(" ", ahead.Select(tip => FormattableString.Invariant($"{tip:0.00}")))} of their tails"));
    }

    [Fact]
    public void A_sting_is_no_longer_than_a_quarter_of_its_tail()
    {
        int stings = 0;
        for (ulong seed = 9971001; seed <= 9971060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = 1 });
            if (creature.Tail.Style == TailStyle.Stinger)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double tail = shape.Arc[BodyGrid.Rings - 1] - shape.Arc[StationRing.TorsoLast];
                FeatureBlueprint sting = creature.Features.Single(part => part.Kind == FeatureKind.Horn && part.Ring == BodyGrid.Rings - 1);
                Assert.InRange(sting.Length / tail, 0.05, 0.25);
                stings++;
            }
        }

        Assert.NotEqual(0, stings);
    }

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void No_tail_of_a_mixed_flier_hangs_like_one_leg_more(double strangeness)
    {
        for (ulong seed = 9995331; seed <= 9995370; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = strangeness });
            if (creature.Plan == BodyPlan.Flapping && creature.Tail.Style != TailStyle.Feathers)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double down = shape.Y[StationRing.TorsoLast] - shape.Y[BodyGrid.Rings - 1];
                double back = shape.Z[StationRing.TorsoLast] - shape.Z[BodyGrid.Rings - 1];
                Assert.True(down <= back, FormattableString.Invariant($"{seed}: a tail that comes down by {down / back:0.00} of what it goes back"));
            }
        }
    }

    [Fact]
    public void Bare_tails_behind_legs_end_pointing_down()
    {
        var falls = new List<double>();
        for (ulong seed = First; seed < First + Count; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking });
            if (creature.Tail.Style is TailStyle.Saurian or TailStyle.Whip or TailStyle.Paddle && creature.Plan is not (BodyPlan.Legless or BodyPlan.ManyLegged or BodyPlan.Hexapod))
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                falls.Add(Math.Atan2(shape.Y[StationRing.TailTwoThirds] - shape.Y[StationRing.TailTip], shape.Z[StationRing.TailTwoThirds] - shape.Z[StationRing.TailTip]) * 180 / Math.PI);
            }
        }

        // Without the rule a tenth of them end level or bend up (-.4).
        falls.Sort();
        Assert.True(falls.Count > 20 && falls[falls.Count / 10] > 4, FormattableString.Invariant($"{falls[falls.Count / 10]:0.0} degrees in the tenth least of {falls.Count}"));
    }

    /// <summary>Radius of the largest section, metres.</summary>
    private static double Largest(BodyShape shape, int first, int last)
    {
        double size = 0;
        for (int ring = first; ring <= last; ring++)
        {
            size = Math.Max(size, Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring])));
        }

        return size;
    }

    private static CreatureBuilder Mixed(string tail, double strangeness)
    {
        SpeciesProfile first = SpeciesCatalogue.Find("bear");
        var parents = new Parentage(first, SpeciesCatalogue.Find(tail), SpeciesCatalogue.Find("frog")) { Tail = SpeciesCatalogue.Find(tail) };
        return new CreatureBuilder(new Seed(1), LocomotionKind.Walking, parents, BodyPlan.Plantigrade, strangeness);
    }
}
