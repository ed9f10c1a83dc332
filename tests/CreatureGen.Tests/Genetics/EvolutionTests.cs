using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Genetics;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Genetics.Populations;
using CreatureGen.Sampling;
using CreatureGen.Seeding;
using CreatureGen.Tests.Blueprints;
using Xunit;

namespace CreatureGen.Tests.Genetics;

public sealed class EvolutionTests
{
    private static readonly CreatureBlueprint[] Founders = Enumerable.Range(60, 6).Select(i => BlueprintSampler.Sample((ulong)i, CreatureOptions.Default)).ToArray();
    private static readonly EvolutionSettings Small = EvolutionSettings.Default with { Population = 12, Breeding = new BreedingSettings { Mutation = 0.35 } };
    private static readonly EvolutionWork One = EvolutionWork.Default with { Threads = 1 };
    private static readonly Goal Tall = new(new TallnessCriterion());

    public static IEnumerable<TheoryDataRow<ISelection>> Selections => [new(new NicheSelection()), new(new TournamentSelection()) { Explicit = true }, new(new NoveltySelection()) { Explicit = true }];

    [Theory(Explicit = true)]
    [MemberData(nameof(Selections))]
    public void Generations_are_the_same_on_any_number_of_threads_and_after_a_pause(ISelection selection)
    {
        EvolutionSettings settings = Small with { Selection = selection };
        var goal = new Goal([new WeightedCriterion(new TallnessCriterion(), 2), new WeightedCriterion(new DistinctnessCriterion(), 1)]);
        List<Generation> whole = Run(goal, settings, One, 3);
        Assert.Equal(whole.Select(Text), Run(goal, settings, One with { Threads = 4 }, 3).Select(Text));

        Generation paused = whole[1];
        Individual Recalled(Individual one) => Evolution.Recall(BlueprintJson.Read(BlueprintJson.Write(one.Blueprint)).Blueprint!, one.Verdict, one.Scores, goal);
        paused = new Generation(1, paused.Individuals.Select(Recalled).ToArray(), paused.Archive.Select(Recalled).ToArray());
        Assert.Equal(Text(whole[1]), Text(paused));
        Assert.Equal(Text(whole[2]), Text(Evolution.Next(paused, goal, settings, One)));
    }

    [Fact]
    public void The_best_lives_on_and_a_population_gets_better()
    {
        List<Generation> generations = Run(Tall, Small, One, 6);
        for (int i = 1; i < generations.Count; i++)
        {
            Assert.Equal(i, generations[i].Number);
            Assert.Equal(12, generations[i].Individuals.Count);
            Assert.True(generations[i].Best.Score >= generations[i - 1].Best.Score);
            Assert.Equal(12, generations[i].Individuals.Select(one => one.Identity).Distinct().Count());
        }

        Assert.True(generations[^1].Best.Score > 1.1 * generations[0].Best.Score, $"{generations[0].Best.Score}, {generations[^1].Best.Score}");
        Assert.True(generations[^1].Median > generations[0].Median);
        Assert.Equal(Score(generations[^1].Best), generations[^1].Best.Score, 1e-9);

        static double Score(Individual one) => new TallnessCriterion().Score(new Candidate(one.Blueprint, []));
    }

    [Fact(Explicit = true)]
    public void Another_seed_takes_another_course_and_a_chance_selection_leads_nowhere()
    {
        Assert.NotEqual(Text(Run(Tall, Small, One, 1)[1]), Text(Run(Tall, Small with { Seed = 2 }, One, 1)[1]));
        double Median(ISelection selection) => Run(Tall, Small with { Selection = selection }, One, 6)[^1].Median;
        Assert.True(Median(new TournamentSelection(1, 0)) < Median(new TournamentSelection(3, 2)));
    }

    [Fact(Explicit = true)]
    public void Each_niche_holds_one_creature_and_it_never_gets_worse()
    {
        NicheGrid grid = NicheGrid.Default;
        List<Generation> generations = Run(Tall, Small with { Selection = new NicheSelection(grid) }, One, 8);
        for (int i = 1; i < generations.Count; i++)
        {
            Dictionary<int, double> before = generations[i - 1].Individuals.GroupBy(one => grid.Of(one.Measures)).ToDictionary(niche => niche.Key, niche => niche.Max(one => one.Score));
            Dictionary<int, Individual> now = generations[i].Individuals.ToDictionary(one => grid.Of(one.Measures));
            Assert.All(before, niche => Assert.True(now[niche.Key].Score >= niche.Value));
        }

        Assert.True(generations[^1].Individuals.Count > generations[1].Individuals.Count);
    }

    [Fact]
    public void A_grid_counts_its_niches_from_the_lowest_bounds()
    {
        BodyMeasures small = new(0.1, 0.2, 0.1, 0.1, 0, 0, 0, 0, 0, 0, 0);
        Assert.Equal(100, NicheGrid.Default.Count);
        Assert.Equal(0, NicheGrid.Default.Of(small));
        Assert.Equal(99, NicheGrid.Default.Of(small with { Size = 2, Length = 20, LegPairs = 7 }));
        Assert.Equal(5 * 1, NicheGrid.Default.Of(small with { LegPairs = 1 }));
        Assert.Equal([1, 2, 4], NicheAxis.Geometric(1, 4, 3).Select(bound => Math.Round(bound, 12)));
        Assert.Throws<ArgumentException>(() => new NicheGrid([]));
    }

    [Fact(Explicit = true)]
    public void Novelty_remembers_what_was_new_and_spreads_wider_than_a_tournament()
    {
        List<Generation> novel = Run(Tall, Small with { Selection = new NoveltySelection() }, One, 5);
        Assert.Equal([0, 4, 8, 12, 16, 20], novel.Select(generation => generation.Archive.Count));
        Assert.True(Spread(novel[^1]) > 1.2 * Spread(Run(Tall, Small, One, 5)[^1]));

        static double Spread(Generation generation) => generation.Individuals.Average(a => generation.Individuals.Average(b => SpeciesDistance.Between(a.Blueprint, b.Blueprint)));
    }

    [Fact]
    public void Dear_criteria_are_asked_of_the_better_half_by_the_cheap_ones_and_of_nobody_twice()
    {
        var dear = new Counted();
        var goal = new Goal([new WeightedCriterion(new TallnessCriterion(), 1), new WeightedCriterion(dear, 1)]);
        Generation first = Evolution.Found(Founders, goal, Small, One);
        Assert.Equal(6, dear.Asked);
        double[] asked = first.Individuals.Where(one => one.Verdict == Verdict.Judged).Select(one => one.Scores[0]).ToArray();
        Assert.Equal(6, asked.Length);
        Assert.All(first.Individuals.Where(one => one.Verdict == Verdict.SetAside), one => Assert.True(one.Score == 0 && one.Scores[0] <= asked.Min()));
        Evolution.Next(first, goal, Small, One);

        // Children that are freaks are in no half.
        Assert.InRange(dear.Asked, 7, 12);

        // Children by no mutation of one creature that is alone are that creature.
        var alone = new Counted();
        Goal motion = new(alone);
        EvolutionSettings same = Small with { Population = 2, Breeding = new BreedingSettings { Mutation = 0 } };
        Generation pair = Evolution.Found([Founders[0], Founders[1]], motion, same, One);
        int before = alone.Asked;
        Generation twins = Evolution.Next(new Generation(0, [pair.Best], []), motion, same with { Selection = new TournamentSelection(1, 1) }, One);
        Assert.InRange(alone.Asked - before, 0, 2);
        Assert.Contains(pair.Best.Identity, twins.Individuals.Select(one => one.Identity));
    }

    [Fact]
    public void Freaks_are_told_apart_and_are_no_parents()
    {
        CreatureBlueprint walker = BlueprintSampler.Sample(20, CreatureOptions.Default with { Kind = RequestedKind.Walking });
        Assert.Empty(FreakCheck.FaultsOf(CreatureAssembler.Assemble(walker)));
        CreatureBlueprint cased = walker with { Body = walker.Body with { Shell = walker.Body.Shell with { Style = ShellStyle.Elytra, Rows = 6 } } };
        Assert.Contains("wing cases", Assert.Single(FreakCheck.FaultsOf(CreatureAssembler.Assemble(cased))), StringComparison.Ordinal);
        BodyProportions p = walker.Body.Proportions;
        CreatureBlueprint headed = walker with { Body = walker.Body with { Proportions = p with { Head = 9, Girth = 0, Depth = 0, Width = 0, Chest = 0, Belly = 0, Rump = 0, Hump = 0 } } };
        Assert.Contains(FreakCheck.FaultsOf(CreatureAssembler.Assemble(FieldLimiter.Limit(headed, CreatureFields.Creature))), fault => fault.StartsWith("its head is", StringComparison.Ordinal));
    }

    [Fact(Explicit = true)]
    public void Of_sampled_creatures_hardly_any_is_a_freak()
    {
        string[] freaks = Enumerable.Range(0, 60).SelectMany(i => FreakCheck.FaultsOf(CreatureGenerator.Generate((ulong)(500 + i), CreatureOptions.Default with { Strangeness = 0.6 })).Select(fault => $"{500 + i}: {fault}")).ToArray();
        Assert.True(freaks.Length <= 1, string.Join("\n", freaks));
    }

    [Fact]
    public void Founders_that_are_none_too_many_or_not_valid_are_refused()
    {
        Assert.Throws<ArgumentException>(() => Evolution.Found([], Tall, Small, One));
        Assert.Contains("6 founders for a population of 4", Assert.Throws<ArgumentException>(() => Evolution.Found(Founders, Tall, Small with { Population = 4 }, One)).Message, StringComparison.Ordinal);
        string message = Assert.Throws<ArgumentException>(() => Evolution.Found([Founders[0], Samples.Small with { Scale = -1 }], Tall, Small, One)).Message;
        Assert.StartsWith("founder 2: scale = -1", message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => new EvolutionSettings { Population = 1 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new EvolutionWork { Threads = 0 });
        Assert.Throws<ArgumentOutOfRangeException>(() => new TournamentSelection(0, 1));
        Assert.Throws<ArgumentException>(() => Evolution.Recall(Founders[0], Verdict.Judged, new ValueList<double>([1, 2]), Tall));
        Assert.Throws<ArgumentException>(() => new Generation(0, [], []));
    }

    [Fact]
    public void Work_stops_when_it_is_asked_to_and_tells_each_birth()
    {
        int births = 0;
        Evolution.Found(Founders, Tall, Small, One with { Progress = () => births++ });
        Assert.Equal(6, births);
        using var stop = new CancellationTokenSource();
        stop.Cancel();
        Assert.ThrowsAny<OperationCanceledException>(() => Evolution.Found(Founders, Tall, Small, One with { Cancellation = stop.Token }));
        Assert.ThrowsAny<OperationCanceledException>(() => Evolution.Found(Founders, Tall, Small, new EvolutionWork { Threads = 3, Cancellation = stop.Token }));
    }

    [Fact]
    public void Even_the_smallest_population_lets_children_live()
    {
        EvolutionSettings pair = Small with { Population = 2 };
        Generation first = Evolution.Found([Founders[0], Founders[1]], Tall, pair, One);
        Generation next = Evolution.Next(first, Tall, pair, One);
        Assert.Equal(first.Best.Identity, next.Individuals.Single(one => one.Blueprint.Lineage == null).Identity);
        Assert.Single(next.Individuals, one => one.Blueprint.Lineage != null);
    }

    [Fact]
    public void The_median_is_that_of_all_who_were_judged()
    {
        Individual Scored(double score, Verdict verdict) => new(Founders[0], 1, new BodyMeasures(1, 1, 1, 1, 1, 1, 1, 1, 1, 1, 1), verdict, new ValueList<double>([score]), score);
        Assert.Equal(2, new Generation(0, [Scored(5, Verdict.Judged), Scored(2, Verdict.Judged), Scored(1, Verdict.Judged)], []).Median);
        Assert.Equal(2, new Generation(0, [Scored(5, Verdict.Judged), Scored(2, Verdict.Judged), Scored(0, Verdict.SetAside), Scored(0, Verdict.Freak)], []).Median);
        Assert.Equal(0, new Generation(0, [Scored(0, Verdict.Freak)], []).Median);
    }

    [Fact]
    public void A_tournament_of_all_is_won_by_the_best_and_one_of_one_by_anybody()
    {
        Generation generation = Run(Tall, Small, One, 0)[0];
        RandomStream random = new Seed(1).Stream();
        Couple[] couples = Enumerable.Range(0, 200).Select(_ => new TournamentSelection(200, 0).Choose(generation, random)).ToArray();
        Assert.All(couples, couple => Assert.Same(generation.Best, couple.First));
        couples = Enumerable.Range(0, 400).Select(_ => new TournamentSelection(1, 0).Choose(generation, random)).ToArray();
        Assert.Equal(12, couples.Select(couple => couple.First.Identity).Distinct().Count());
        Assert.All(couples.Take(50), couple => Assert.NotEqual(couple.First.Identity, couple.Second.Identity));
    }

    private static List<Generation> Run(Goal goal, EvolutionSettings settings, EvolutionWork work, int generations)
    {
        var all = new List<Generation> { Evolution.Found(Founders, goal, settings, work) };
        for (int i = 0; i < generations; i++)
        {
            all.Add(Evolution.Next(all[^1], goal, settings, work));
        }

        return all;
    }

    private static string Text(Generation generation) =>
        string.Join("\n", generation.Individuals.Concat(generation.Archive).Select(one => FormattableString.Invariant($"{generation.Number} {one.Identity:x16} {one.Verdict} {one.Score:R} {one.Scores} {one.Measures}")));

    private sealed class Counted : ICriterion
    {
        private int asked;

        public int Asked => asked;

        public string Name => "counted";

        public CriterionInput Input => CriterionInput.Motion;

        public double Score(Candidate candidate)
        {
            Interlocked.Increment(ref asked);
            return 1;
        }
    }
}
