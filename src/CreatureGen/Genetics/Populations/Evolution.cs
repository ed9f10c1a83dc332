using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Concurrency;
using CreatureGen.Creatures;
using CreatureGen.Genetics.Criteria;
using CreatureGen.Repairs;
using CreatureGen.Seeding;

namespace CreatureGen.Genetics.Populations;

/// <summary>Breeds populations on towards a goal. A generation is a function of the one before, the goal and the settings: the same ones give the same generation on any number of threads, today and after a pause.</summary>
/// <remarks>Based on: J. Hudson, "Creature Generation using Genetic Algorithms and Auto-Rigging" (2013); K. Sims, "Evolving Virtual Creatures" (1994).</remarks>
public static class Evolution
{
    /// <summary>Children that are tried before one is taken though something of it does not fit together.</summary>
    private const int MaxFreaks = 4;

    /// <summary>The first generation: the founders and, where they are fewer than its room, their children.</summary>
    /// <param name="founders">At least one, valid.</param>
    /// <param name="goal">What they are bred towards.</param>
    /// <param name="settings">How.</param>
    /// <param name="work">On how many threads.</param>
    /// <exception cref="ArgumentException">There is no founder, there are more than the population has room for, or one is not valid or builds a broken creature; the message says which.</exception>
    /// <exception cref="OperationCanceledException">The work was stopped.</exception>
    public static Generation Found(IReadOnlyList<CreatureBlueprint> founders, Goal goal, EvolutionSettings settings, EvolutionWork work)
    {
        _ = founders ?? throw new ArgumentNullException(nameof(founders));
        _ = goal ?? throw new ArgumentNullException(nameof(goal));
        _ = settings ?? throw new ArgumentNullException(nameof(settings));
        _ = work ?? throw new ArgumentNullException(nameof(work));
        if (founders.Count == 0 || founders.Count > settings.Population)
        {
            throw new ArgumentException(FormattableString.Invariant($"there are {founders.Count} founders for a population of {settings.Population}; expected 1..{settings.Population}"), nameof(founders));
        }

        var jury = new Jury(goal, work);
        var first = new Individual[founders.Count];
        IndependentParts.Run(first.Length, work.Threads, i =>
        {
            work.Cancellation.ThrowIfCancellationRequested();
            first[i] = jury.Meet(Settled(founders[i], i), Array.Empty<string>());
        });
        var couples = new Generation(0, first, Array.Empty<Individual>());
        Individual[] others = Bear(settings.Population - first.Length, couples, new TournamentSelection(1, 0), settings, jury);
        var all = new List<Individual>(first);
        all.AddRange(others);
        Individual[] judged = jury.Judge(all, Array.Empty<Individual>());
        return new Generation(0, Ranking.ByScore(judged), Array.Empty<Individual>());
    }

    /// <summary>The generation after another.</summary>
    /// <param name="generation">The one before, from <see cref="Found"/>, from here or from <see cref="Recall"/>.</param>
    /// <param name="goal">The goal that it was judged by.</param>
    /// <param name="settings">How.</param>
    /// <param name="work">On how many threads.</param>
    /// <exception cref="OperationCanceledException">The work was stopped.</exception>
    public static Generation Next(Generation generation, Goal goal, EvolutionSettings settings, EvolutionWork work)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        _ = goal ?? throw new ArgumentNullException(nameof(goal));
        _ = settings ?? throw new ArgumentNullException(nameof(settings));
        _ = work ?? throw new ArgumentNullException(nameof(work));
        var jury = new Jury(goal, work);
        Individual[] children = Bear(settings.Population, generation, settings.Selection, settings, jury);
        Individual[] judged = jury.Judge(children, generation.Individuals);
        var parents = new List<Individual>(generation.Individuals);
        if (goal.Asks(CriterionInput.Company))
        {
            var all = new List<Individual>(parents);
            all.AddRange(judged);
            Individual[] compared = jury.Compare(all);
            parents = new List<Individual>(compared).GetRange(0, parents.Count);
            judged = new List<Individual>(compared).GetRange(parents.Count, judged.Length).ToArray();
        }

        return settings.Selection.Succeed(new Generation(generation.Number, parents, generation.Archive), judged, settings.Population);
    }

    /// <summary>The same generation, judged by another goal: what is wanted has changed on the way.</summary>
    /// <exception cref="OperationCanceledException">The work was stopped.</exception>
    public static Generation Judge(Generation generation, Goal goal, EvolutionWork work)
    {
        _ = generation ?? throw new ArgumentNullException(nameof(generation));
        _ = work ?? throw new ArgumentNullException(nameof(work));
        var jury = new Jury(goal ?? throw new ArgumentNullException(nameof(goal)), work);
        var met = new Individual[generation.Individuals.Count];
        IndependentParts.Run(met.Length, work.Threads, i =>
        {
            work.Cancellation.ThrowIfCancellationRequested();
            Creature creature = CreatureAssembler.Assemble(generation.Individuals[i].Blueprint);
            met[i] = jury.Meet(creature, generation.Individuals[i].Verdict == Verdict.Freak ? FreakCheck.FaultsOf(creature) : Array.Empty<string>());
        });
        return new Generation(generation.Number, Ranking.ByScore(jury.Judge(met, Array.Empty<Individual>())), generation.Archive);
    }

    /// <summary>A creature as it was judged before, to go on with after a pause.</summary>
    /// <param name="blueprint">Its blueprint.</param>
    /// <param name="verdict">What became of it.</param>
    /// <param name="scores">The score of each criterion of the goal.</param>
    /// <param name="goal">The goal.</param>
    /// <exception cref="ArgumentException">The blueprint is not valid, or the scores are not as many as the criteria.</exception>
    public static Individual Recall(CreatureBlueprint blueprint, Verdict verdict, ValueList<double> scores, Goal goal)
    {
        _ = goal ?? throw new ArgumentNullException(nameof(goal));
        _ = scores ?? throw new ArgumentNullException(nameof(scores));
        BlueprintValidator.ThrowIfInvalid(blueprint);
        if (scores.Count != goal.Parts.Count)
        {
            throw new ArgumentException(FormattableString.Invariant($"{scores.Count} scores for {goal.Parts.Count} criteria; expected one for each"), nameof(scores));
        }

        var candidate = new Candidate(blueprint, Array.Empty<CreatureBlueprint>());
        return new Individual(blueprint, BlueprintIdentity.Of(blueprint), candidate.Measures, verdict, scores, verdict == Verdict.Judged ? goal.Total(scores) : 0);
    }

    private static Creature Settled(CreatureBlueprint founder, int number)
    {
        try
        {
            RepairReport report = BlueprintRepair.Repair(BlueprintValidator.Validate(founder).Count == 0 ? founder : throw new ArgumentException(string.Join("; ", BlueprintValidator.Validate(founder))));
            return report.IsSound ? report.Creature : throw new ArgumentException("it builds a broken creature; expected one that is sound, or can be repaired");
        }
        catch (ArgumentException problem)
        {
            throw new ArgumentException(FormattableString.Invariant($"founder {number + 1}: {problem.Message}"), problem);
        }
    }

    /// <summary>Children of couples that a selection chooses. Each has numbers of its own, so that they may be born side by side.</summary>
    private static Individual[] Bear(int count, Generation generation, ISelection selection, EvolutionSettings settings, Jury jury)
    {
        Seed root = new Seed(settings.Seed).Child("generation").Child(generation.Number);
        var children = new Individual[count];
        IndependentParts.Run(count, jury.Work.Threads, i =>
        {
            jury.Work.Cancellation.ThrowIfCancellationRequested();
            Seed own = root.Child(i);
            Couple couple = selection.Choose(generation, own.Child("parents").Stream());
            Offspring child = null!;
            IReadOnlyList<string> faults = Array.Empty<string>();
            for (int attempt = 0; attempt < MaxFreaks; attempt++)
            {
                child = Breeding.Child(couple.First.Blueprint, couple.Second.Blueprint, own.Child("child").Child(attempt).Value, settings.Breeding);
                faults = FreakCheck.FaultsOf(child.Creature);
                if (faults.Count == 0)
                {
                    break;
                }
            }

            children[i] = jury.Meet(child.Creature, faults);
            jury.Work.Progress?.Invoke();
        });
        return children;
    }
}
