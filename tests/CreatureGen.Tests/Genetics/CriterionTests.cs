using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Genetics;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Inspection;
using CreatureGen.Inspection.Variety;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics;
using CreatureGen.Sampling;
using Xunit;

namespace CreatureGen.Tests.Genetics;

public sealed class CriterionTests
{
    private static readonly Creature Walker = Grown(20, RequestedKind.Walking);
    private static readonly Creature Insect = Grown(28, RequestedKind.Walking);
    private static readonly Creature Swimmer = Grown(17, RequestedKind.Swimming);

    [Fact]
    public void Speed_is_the_top_speed_of_the_gaits_for_the_side_of_a_cube_of_the_same_volume()
    {
        double size = Math.Cbrt(Walker.Mass.Volume);
        Assert.Equal(new MotionProfile(Walker).Gaits!.TopSpeed / Math.Sqrt(9.81 * size), Score(new SpeedCriterion(), Walker), 1e-4);
        Assert.Equal(Swimmer.DefaultSpeed / Math.Sqrt(9.81 * Math.Cbrt(Swimmer.Mass.Volume)), Score(new SpeedCriterion(), Swimmer), 1e-4);
    }

    [Fact]
    public void Stability_is_the_least_slope_over_which_a_creature_tips_in_any_direction()
    {
        foreach (Creature creature in new[] { Walker, Insect })
        {
            var skin = new WeldedSkin(creature.Mesh);
            Vector3[] soles = skin.BodyTriangles.ToArray().Select(v => skin.Positions[v]).Where(p => p.Y <= 4e-3f * creature.StandingHeight).Distinct().ToArray();
            double least = Enumerable.Range(0, 3600).Min(i =>
            {
                (double z, double x) = Math.SinCos(i * Math.Tau / 3600);
                return soles.Max(p => (x * p.X) + (z * p.Z)) - (x * creature.Mass.Centre.X) - (z * creature.Mass.Centre.Z);
            });
            Assert.Equal(least / creature.Mass.Centre.Y, Score(new StabilityCriterion(), creature), 0.01);
        }

        Assert.Equal(0, Score(new StabilityCriterion(), Swimmer));
    }

    [Fact]
    public void What_is_for_the_size_is_the_same_at_twice_the_size()
    {
        Creature large = CreatureGenerator.Build(Walker.Blueprint with { Scale = 2 * Walker.Blueprint.Scale });
        foreach (ICriterion criterion in new ICriterion[] { new StabilityCriterion(), new TallnessCriterion(), new ProportionsCriterion(BodyMeasures.Of(Insect)), new StrangenessCriterion() })
        {
            Assert.Equal(Score(criterion, Walker), Score(criterion, large), 0.01);
        }
    }

    [Fact]
    public void Work_of_transport_is_that_of_animals_and_the_same_each_time()
    {
        foreach (Creature creature in new[] { Walker, Insect, Swimmer, Grown(5, RequestedKind.Flying) })
        {
            var profile = new MotionProfile(creature);
            double cost = TransportCost.Of(profile);
            Assert.InRange(cost, 1e-4, 2);
            Assert.Equal(cost, TransportCost.Of(profile));
            Assert.Equal(1 / cost, Score(new EconomyCriterion(), creature), 1e-9);
        }
    }

    [Fact]
    public void What_crawls_works_against_the_friction_of_its_belly()
    {
        Creature snake = CreatureGenerator.Generate(3, CreatureOptions.Default with { Kind = RequestedKind.Walking, BaseBodies = new ValueList<BaseBodyWeight>([new BaseBodyWeight("serpent", 1000), new BaseBodyWeight("cobra", 1000)]), BodyPlans = new ValueList<BodyPlanWeight>([new BodyPlanWeight(BodyPlan.Legless, 1000)]) });
        Assert.Equal(BodyPlan.Legless, snake.Blueprint.Plan);
        Assert.InRange(TransportCost.Of(new MotionProfile(snake)), 0.11, 1);
    }

    [Fact]
    public void Smoothness_falls_with_what_the_measures_of_motion_find()
    {
        var profile = new MotionProfile(Insect);
        double worst = Movement.Of(profile).Where(movement => movement.IsCyclic).Select(movement => new MotionTrial(movement, GroundRelief.Flat, 60).Run(profile))
            .Max(report => ((report.Slip ?? 0) / 0.01) + ((report.LegOverlap ?? 0) / 0.03) + (report.LimitExcess / 0.02));
        Assert.Equal(1 / (1 + worst), Score(new SmoothnessCriterion(), Insect), 1e-6);
    }

    [Fact]
    public void A_creature_is_like_its_own_outline_whichever_way_it_looks_and_less_like_another()
    {
        (OutlineMask mask, OutlineMask mirrored) = (Drawn(Walker, 1), Drawn(Walker, -1));
        double own = Score(new SilhouetteCriterion(mask), Walker);
        Assert.InRange(own, 0.88, 1);
        Assert.Equal(own, Score(new SilhouetteCriterion(mirrored), Walker), 0.02);
        Assert.InRange(Score(new SilhouetteCriterion(mask), Swimmer), 0.05, 0.8 * own);
    }

    [Fact]
    public void A_square_covers_half_of_an_oblong_twice_as_long()
    {
        Outline square = Outline.OfPicture(10, 12, (x, y) => x < 8 && y >= 4);
        Outline oblong = Outline.OfPicture(400, 300, (_, y) => y is >= 50 and < 250);
        Assert.Equal(0.5, square.Likeness(oblong), 0.02);
        Assert.Equal(1, square.Likeness(Outline.OfPicture(100, 100, (_, _) => true)));
    }

    [Fact]
    public void Likeness_to_proportions_is_one_for_the_same_and_falls_with_each_part()
    {
        BodyMeasures measures = BodyMeasures.Of(Walker);
        Assert.Equal(1, Score(new ProportionsCriterion(measures), Walker));
        double tail = Score(new ProportionsCriterion(measures with { Tail = (2 * measures.Tail) + (0.15 * measures.Size) }), Walker);
        Assert.Equal(Math.Exp(-Math.Log(2) / 10), tail, 1e-9);
        Assert.Equal(Math.Exp(-0.05), Score(new ProportionsCriterion(measures with { LegPairs = measures.LegPairs + 1 }), Walker), 1e-9);
        Assert.True(Score(new ProportionsCriterion(measures), Swimmer) < 0.8);
    }

    [Fact]
    public void Distinctness_is_the_mean_distance_to_the_five_nearest()
    {
        CreatureBlueprint[] company = Enumerable.Range(40, 8).Select(i => BlueprintSampler.Sample((ulong)i, CreatureOptions.Default)).ToArray();
        double nearest = company.Select(other => SpeciesDistance.Between(Walker.Blueprint, other)).Order().Take(5).Average();
        Assert.Equal(nearest, new DistinctnessCriterion().Score(new Candidate(Walker.Blueprint, company)), 1e-12);
        Assert.Equal(1, Score(new DistinctnessCriterion(), Walker));
        Assert.Equal(0, new DistinctnessCriterion().Score(new Candidate(Walker.Blueprint, [Walker.Blueprint])), 1e-12);
    }

    [Fact]
    public void Picks_are_liked_best_and_without_any_all_are_alike()
    {
        var picks = new PicksCriterion([Insect.Blueprint, Swimmer.Blueprint]);
        Assert.Equal(1, Score(picks, Insect));
        Assert.Equal(1 - Math.Min(SpeciesDistance.Between(Walker.Blueprint, Insect.Blueprint), SpeciesDistance.Between(Walker.Blueprint, Swimmer.Blueprint)), Score(picks, Walker));
        Assert.Equal(1, Score(new PicksCriterion([]), Walker));
    }

    [Fact]
    public void Animals_are_less_strange_than_what_is_made_of_several()
    {
        double Mean(double strangeness) => Enumerable.Range(300, 30).Average(i => Score(new StrangenessCriterion(), BlueprintSampler.Sample((ulong)i, CreatureOptions.Default with { Strangeness = strangeness })));
        Assert.True(Mean(0) < 0.5 * Mean(1), $"{Mean(0)}, {Mean(1)}");
    }

    [Fact]
    public void A_goal_of_several_criteria_is_their_weighted_product_and_nothing_makes_up_for_a_zero()
    {
        var goal = new Goal([new WeightedCriterion(new Fixed("a", 4), 1), new WeightedCriterion(new Fixed("b", 9), 1)]);
        Assert.Equal(6, Total(goal), 1e-12);
        Assert.Equal(Math.Pow(4 * 4 * 9, 1 / 3.0), Total(new Goal([new WeightedCriterion(new Fixed("a", 4), 2), new WeightedCriterion(new Fixed("b", 9), 1)])), 1e-12);
        Assert.Equal(0, Total(new Goal([new WeightedCriterion(new Fixed("a", 4), 1), new WeightedCriterion(new Fixed("b", 0), 1)])));
    }

    [Theory]
    [InlineData(double.NaN)]
    [InlineData(double.PositiveInfinity)]
    [InlineData(-0.1)]
    public void A_score_that_is_none_is_refused_by_name(double score) =>
        Assert.Contains("the criterion own gave", Assert.Throws<InvalidOperationException>(() => Total(new Goal(new Fixed("own", score)))).Message, StringComparison.Ordinal);

    [Fact]
    public void A_goal_without_criteria_or_with_a_weight_of_nothing_is_refused()
    {
        Assert.Throws<ArgumentException>(() => new Goal([]));
        Assert.Contains("the weight of a is 0", Assert.Throws<ArgumentException>(() => new Goal([new WeightedCriterion(new Fixed("a", 1), 0)])).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void An_outline_needs_pixels_for_its_size_and_something_inside()
    {
        Assert.Throws<ArgumentException>(() => new OutlineMask(new bool[5], 2, 3));
        Assert.Contains("the picture is empty", Assert.Throws<ArgumentException>(() => new OutlineMask(new bool[6], 2, 3)).Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Criteria_of_the_catalogue_are_found_by_their_names()
    {
        Assert.Equal(CriterionCatalogue.All.Count, CriterionCatalogue.All.Select(criterion => criterion.Name).Distinct().Count());
        Assert.All(CriterionCatalogue.All, criterion => Assert.Same(criterion, CriterionCatalogue.Find(criterion.Name)));
        Assert.Null(CriterionCatalogue.Find("Fast"));
    }

    [Fact]
    public void Lengths_of_a_body_are_those_of_its_surface_and_its_bones()
    {
        BodyMeasures measures = BodyMeasures.Of(Walker);
        Vector3[] positions = Walker.Mesh.Positions.ToArray();
        Assert.Equal(positions.Max(p => p.Z) - positions.Min(p => p.Z), measures.Length, 1e-5);
        Assert.Equal(positions.Max(p => p.Y) - positions.Min(p => p.Y), measures.Height, 1e-5);
        Assert.Equal(Walker.Limbs.Count(limb => limb.Stands) / 2, measures.LegPairs);
        Assert.True(measures.Leg > 0 && measures.Leg < measures.Height);
        Assert.Equal((0, 0.0), (BodyMeasures.Of(Swimmer).LegPairs, BodyMeasures.Of(Swimmer).Leg));
    }

    [Fact]
    public void The_share_of_balance_is_what_the_inspection_asks_for()
    {
        StandingBalance balance = StandingBalance.Of(Walker);
        Assert.InRange(balance.Fraction, 0.05, 0.5);
        Assert.True(balance.Metres > 0);
    }

    private static double Score(ICriterion criterion, Creature creature) => criterion.Score(new Candidate(creature));

    private static double Score(ICriterion criterion, CreatureBlueprint blueprint) => criterion.Score(new Candidate(blueprint, []));

    private static double Total(Goal goal) => goal.Total(goal.Ask(CriterionInput.Blueprint, new Candidate(Walker), new ValueList<double>(new double[goal.Parts.Count])));

    private static Creature Grown(ulong seed, RequestedKind kind) => CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });

    /// <summary>A picture of a creature from the side by its vertices and the middles of its edges and faces, 300 pixels long.</summary>
    private static OutlineMask Drawn(Creature creature, int ahead)
    {
        Vector3[] positions = creature.Mesh.Positions.ToArray();
        float length = positions.Max(p => p.Z) - positions.Min(p => p.Z);
        (float left, float top) = (positions.Min(p => ahead * p.Z), positions.Max(p => p.Y));
        int width = 300, height = (int)(300 * (top - positions.Min(p => p.Y)) / length) + 1;
        var inside = new bool[width * height];
        ReadOnlySpan<int> triangles = creature.Mesh.Triangles;
        for (int i = 0; i < triangles.Length; i += 3)
        {
            (Vector3 a, Vector3 b, Vector3 c) = (positions[triangles[i]], positions[triangles[i + 1]], positions[triangles[i + 2]]);
            for (int u = 0; u <= 8; u++)
            {
                for (int v = 0; v <= 8 - u; v++)
                {
                    Vector3 p = ((a * u) + (b * v) + (c * (8 - u - v))) / 8f;
                    int x = (int)(((ahead * p.Z) - left) / length * (width - 1)), y = (int)((top - p.Y) / length * (width - 1));
                    inside[(y * width) + x] = true;
                }
            }
        }

        return new OutlineMask(inside, width, height);
    }

    private sealed class Fixed(string name, double score) : ICriterion
    {
        public string Name => name;

        public CriterionInput Input => CriterionInput.Blueprint;

        public double Score(Candidate candidate) => score;
    }
}
