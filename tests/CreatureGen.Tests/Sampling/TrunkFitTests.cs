using System;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Tails;
using CreatureGen.Blueprints;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Species;
using Xunit;

namespace CreatureGen.Tests.Sampling;

public sealed class TrunkFitTests
{
    /// <summary>Largest hips of a swimmer in bellies: what is mixed and drawn after the rule leaves of its 0.57.</summary>
    private const double Hips = 0.7;

    // Longest trunk that legs carry, in chests, and depth of its loin in chests: what the rules leave of what is asked of them, for each gives way by a part.
    private const double Slenderness = 3.4;
    private const double Tuck = 0.86;

    /// <summary>Most that the neck of a mixed mammal is raised over its trunk in the water, degrees.</summary>
    private const double RaisedNeckDegrees = 40;

    /// <summary>Least length of a tail that rolls up, in radii of its root: what posture and lattice leave of the rule's 9.</summary>
    private const double LeastRolled = 7;

    /// <summary>Longest tail that is carried up, in trunks: what the lattice leaves of the rule's 0.75.</summary>
    private const double Carried = 0.85;

    /// <summary>Deepest mixed swimmer in lengths of its trunk: what the rules that follow leave of the .56 asked for (1.12 without).</summary>
    private const double DeepestSwimmer = 0.68;

    /// <summary>Steepest fall from throat to chest of nine of ten swimmers, for each unit that it goes back: what the parts that give way leave of the .7 asked for (1.27 without).</summary>
    private const double SteepThroat = 1.12;

    /// <summary>Depth of the waist of insects in chests (up to 1.15 without).</summary>
    private const double Waist = 0.83;

    /// <summary>Thinnest loin of a body that takes from insects without being one, in pelvises: what lattice and hips leave of the rule's .92 (.56 without).</summary>
    private const double Loin = 0.8;

    // Highest base of a swimmer's neck over its spine against its shoulder, and broadest and deepest sections of a mixed swimmer: what the parts that give way leave of what is asked for (1.8, 2.8 and 2.5 without).
    private const double Shoulder = 1.5;
    private const double Broadest = 2;
    private const double Deepest = 1.7;

    /// <summary>Mean breadth of mixed fish, and of what is mixed and swims by winding, in their depths (1.01 and 1.29 without the rule).</summary>
    private const double BroadFish = 0.9;
    private const double BroadWinding = 1.25;

    /// <summary>Most that the necks of mixed fish and whales lack in the mean to the line from the head to the ribs, as a factor.</summary>
    private const double Hollow = 1.1;

    [Fact]
    public void Necks_of_mixed_fish_and_whales_are_not_hollow_between_the_head_and_the_ribs()
    {
        double[] necks = DrawnShapes.Of(RequestedKind.Swimming, 1, 11200001, 200)
            .Where(drawn => drawn.Creature.Plan is BodyPlan.Fish or BodyPlan.Whale && drawn.Creature.Body.Disc.Sweep == 0)
            .Select(drawn => HollowOf(drawn.Shape))
            .ToArray();
        Assert.True(necks.Length > 20);
        Assert.True(necks.Average() < Hollow, FormattableString.Invariant($"{necks.Average():0.000} of {necks.Length}"));
    }

    /// <summary>How many times as thick as it is the middle of a neck would be half way between the head and the ribs, at least 1.</summary>
    private static double HollowOf(BodyShape shape)
    {
        double line = (SizeOf(StationRing.Cranium) + SizeOf(StationRing.Ribs)) / 2;
        return Math.Max(1, line / SizeOf(StationRing.NeckMiddle));

        double SizeOf(int ring) => Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
    }

    [Theory]
    [InlineData(BodyPlan.Fish, BroadFish)]
    [InlineData(BodyPlan.Eel, BroadWinding)]
    public void Mixed_fish_are_deeper_than_broad_and_no_balls_from_behind(BodyPlan plan, double broadest)
    {
        double[] breadths = DrawnShapes.Of(RequestedKind.Swimming, 1, 11200001, 200)
            .Where(drawn => drawn.Creature.Plan == plan && drawn.Creature.Body.Disc.Sweep == 0)
            .Select(drawn => TrunkOutline.Of(drawn.Shape).Breadth)
            .ToArray();
        Assert.True(breadths.Length > 20);
        Assert.True(breadths.Average() < broadest, FormattableString.Invariant($"{breadths.Average():0.00} of {breadths.Length}"));
    }

    [Fact]
    public void No_mixed_swimmer_is_a_plank_or_has_a_corner_for_a_shoulder()
    {
        for (ulong seed = 11200001; seed <= 11200120; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = 1 });
            SpeciesProfile first = SpeciesCatalogue.Find(creature.Body.Blend.First);
            if (first.Disc.Sweep != 0)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double corner = shape.Top[StationRing.NeckBase] / shape.Top[StationRing.Ribs - 2];
            double flat = Enumerable.Range(StationRing.Shoulder, StationRing.Pelvis - StationRing.Shoulder).Max(ring => 2 * shape.Width[ring] / (shape.Top[ring] + shape.Bottom[ring]));
            double deep = Enumerable.Range(StationRing.Shoulder, StationRing.Pelvis - StationRing.Shoulder).Max(ring => (shape.Top[ring] + shape.Bottom[ring]) / shape.Width[ring] / 2);
            Assert.True(corner <= Shoulder, FormattableString.Invariant($"{seed}: the base of the neck is {corner:0.00} shoulders high"));
            Assert.True(flat <= Broadest, FormattableString.Invariant($"{seed}: {flat:0.00} times as broad as deep"));
            Assert.True(first.Class == AnimalClass.Fish || deep <= Deepest, FormattableString.Invariant($"{seed}: {deep:0.00} times as deep as broad"));
        }
    }

    [Theory]
    [InlineData(RequestedKind.Walking)]
    [InlineData(RequestedKind.Flying)]
    [InlineData(RequestedKind.Swimming)]
    public void Who_takes_from_insects_without_being_one_has_no_waist_before_an_abdomen(RequestedKind kind)
    {
        int takers = 0;
        for (ulong seed = 11200001; seed <= 11200120; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind, Strangeness = 1 });
            if (SpeciesCatalogue.Find(creature.Body.Blend.First).Class == AnimalClass.Arthropod
                || !creature.Body.Blend.Bodies.Any(part => part.Torso > 0.2 && SpeciesCatalogue.Find(part.Name).Class == AnimalClass.Arthropod))
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double loin = Size(shape, StationRing.Loin) / Size(shape, StationRing.Pelvis);
            Assert.True(loin >= Loin, FormattableString.Invariant($"{kind} {seed}: a loin of {loin:0.00} pelvises"));
            takers++;
        }

        Assert.InRange(takers, 10, 100);
    }

    [Fact]
    public void A_mixed_bird_that_flies_does_not_hang_head_first()
    {
        int birds = 0;
        for (ulong seed = 11200001; seed <= 11200150; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Flying, Strangeness = 1 });
            if (creature.Plan == BodyPlan.Flapping && SpeciesCatalogue.Find(creature.Body.Blend.First).Bird is not null)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                Assert.True(shape.Y[StationRing.NeckBase] >= shape.Y[StationRing.Pelvis], $"{seed}: the neck is below the pelvis");
                birds++;
            }
        }

        Assert.NotEqual(0, birds);
    }

    [Fact]
    public void Mixed_swimmers_are_no_sacks_behind_a_spout()
    {
        int swimmers = 0;
        int steep = 0;
        for (ulong seed = 11030001; seed <= 11030400; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming });
            if (creature.Body.Disc.Sweep != 0)
            {
                continue;
            }

            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            TrunkOutline outline = TrunkOutline.Of(shape);
            Assert.True(outline.Depth <= DeepestSwimmer * outline.Length, FormattableString.Invariant($"{seed}: {outline.Depth / outline.Length:0.00} lengths deep"));
            double fall = 0;
            for (int ring = 14; ring <= StationRing.Ribs; ring++)
            {
                fall = Math.Max(fall, (shape.Y[ring] - shape.Bottom[ring] - shape.Y[ring + 4] + shape.Bottom[ring + 4]) / (shape.Z[ring] - shape.Z[ring + 4]));
            }

            swimmers++;
            steep += fall > SteepThroat ? 1 : 0;
        }

        Assert.True(10 * steep <= swimmers, FormattableString.Invariant($"{steep} of {swimmers} throats fall steeply"));
    }

    [Theory]
    [InlineData(RequestedKind.Walking, BodyPlan.Hexapod)]
    [InlineData(RequestedKind.Flying, BodyPlan.Buzzing)]
    public void Mixed_insects_have_a_waist(RequestedKind kind, BodyPlan plan)
    {
        int insects = 0;
        for (ulong seed = 11030001; seed <= 11030400; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = kind });
            if (creature.Plan == plan && SpeciesCatalogue.Find(creature.Body.Blend.First).Class == AnimalClass.Arthropod)
            {
                double tuck = TrunkOutline.Of(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail)).Tuck;
                Assert.True(tuck <= Waist, FormattableString.Invariant($"{seed}: a waist of {tuck:0.00} chests"));
                insects++;
            }
        }

        Assert.NotEqual(0, insects);
    }

    [Fact]
    public void Mixed_swimmers_thin_out_behind_their_bellies()
    {
        for (ulong seed = 9971001; seed <= 9971060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Swimming);
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double hips = Size(shape, StationRing.Pelvis) / Size(shape, StationRing.Belly);
            Assert.True(creature.Body.Disc.Sweep != 0 || hips <= Hips, FormattableString.Invariant($"{seed}: hips of {hips:0.00} bellies"));
        }
    }

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void What_lies_is_a_rope_and_its_head_is_no_broader_than_it_by_a_fifth(double strangeness)
    {
        int ropes = 0;
        for (ulong seed = 10773001; seed <= 10773300; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = strangeness });
            if (creature.Plan != BodyPlan.Legless)
            {
                continue;
            }

            ropes++;
            BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
            double thickest = Enumerable.Range(StationRing.NeckBase, StationRing.Pelvis - StationRing.NeckBase + 1).Max(ring => 2 * Size(shape, ring));
            double length = (shape.Arc[StationRing.TailTip] - shape.Arc[StationRing.NeckBase]) / thickest;
            Assert.True(length > 9, FormattableString.Invariant($"{seed}: {length:0.0} times as long as thick"));
            double head = shape.Width.Take(StationRing.Nape).Max() / shape.Width.Skip(StationRing.NeckBase).Take(StationRing.Pelvis - StationRing.NeckBase).Max();
            Assert.True(head < 1.2, FormattableString.Invariant($"{seed}: a head of {head:0.00} trunks' breadth"));
        }

        Assert.InRange(ropes, 4, 100);
    }

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void Mixed_mammals_lay_their_necks_down_in_the_water(double strangeness)
    {
        for (ulong seed = 9971001; seed <= 9971060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Swimming, Strangeness = strangeness });
            if (SpeciesCatalogue.Find(creature.Body.Blend.First).Class == AnimalClass.Mammal)
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double raised = Scalar.Degrees(shape.Pitch[StationRing.NeckMiddle] - shape.Pitch[BodyGrid.AnchorRing]);
                Assert.True(raised <= RaisedNeckDegrees, FormattableString.Invariant($"{seed}: a neck raised by {raised:0}° makes a corner of the withers"));
            }
        }
    }

    [Theory]
    [InlineData(0.6)]
    [InlineData(1)]
    public void No_strange_trunk_on_legs_under_it_is_a_log(double strangeness)
    {
        int carried = 0;
        for (ulong seed = 9971001; seed <= 9971060; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking, Strangeness = strangeness });
            if (creature.Plan is BodyPlan.Digitigrade or BodyPlan.Unguligrade or BodyPlan.Plantigrade or BodyPlan.Columnar)
            {
                TrunkOutline outline = TrunkOutline.Of(BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail));
                Assert.True(outline.Slenderness <= Slenderness && outline.Tuck <= Tuck, FormattableString.Invariant($"{seed}: {outline.Slenderness:0.00} chests long, a loin of {outline.Tuck:0.00}"));
                carried++;
            }
        }

        Assert.NotEqual(0, carried);
    }

    [Fact]
    public void No_tail_that_is_carried_up_is_a_rod_over_the_back_or_a_knot()
    {
        for (ulong seed = 9971001; seed <= 9971100; seed++)
        {
            CreatureBlueprint creature = BlueprintSampler.Sample(seed, LocomotionKind.Walking);
            if (TailTaper.Of(creature.Tail.Style) is { Curl: not 0 })
            {
                BodyShape shape = BodyShaper.Shape(creature.Plan, creature.Body, creature.Head, creature.Tail);
                double length = (shape.Arc[BodyGrid.Rings - 1] - shape.Arc[StationRing.TorsoLast]) / (shape.Arc[StationRing.TorsoLast] - shape.Arc[StationRing.TrunkFirst]);
                Assert.True(length <= Carried, FormattableString.Invariant($"{seed}: a tail of {length:0.00} trunks"));
                double radii = (shape.Arc[BodyGrid.Rings - 1] - shape.Arc[StationRing.TorsoLast]) / Size(shape, StationRing.TailStem);
                Assert.True(radii >= LeastRolled, FormattableString.Invariant($"{seed}: a tail of {radii:0.0} radii is a knot"));
            }
        }
    }

    private static double Size(BodyShape shape, int ring) => Math.Sqrt(shape.Width[ring] * 0.5 * (shape.Top[ring] + shape.Bottom[ring]));
}
