using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Concurrency;
using CreatureGen.Creatures;
using CreatureGen.Genetics.Criteria;

namespace CreatureGen.Genetics.Populations;

/// <summary>Asks the criteria of a goal, the cheap ones first, and nobody twice.</summary>
internal sealed class Jury
{
    private readonly Goal goal;
    private readonly ValueList<double> unasked;

    public Jury(Goal goal, EvolutionWork work)
    {
        this.goal = goal;
        Work = work;
        unasked = new ValueList<double>(new double[goal.Parts.Count]);
    }

    /// <summary>How the work is done.</summary>
    public EvolutionWork Work { get; }

    /// <summary>What can be said of a creature as soon as it is built.</summary>
    /// <param name="creature">The creature; it need not be kept.</param>
    /// <param name="faults">What does not fit together in it.</param>
    public Individual Meet(Creature creature, IReadOnlyList<string> faults)
    {
        var candidate = new Candidate(creature);
        ValueList<double> scores = unasked;
        if (faults.Count == 0)
        {
            scores = goal.Ask(CriterionInput.Blueprint, candidate, scores);
            scores = goal.Ask(CriterionInput.Creature, candidate, scores);
        }

        return With(new Individual(creature.Blueprint, BlueprintIdentity.Of(creature.Blueprint), candidate.Measures, faults.Count == 0 ? Verdict.Judged : Verdict.Freak, scores, 0), scores);
    }

    /// <summary>Asks what is left to ask of a brood: how it moves, where the cheap criteria speak for it, and how it does in company.</summary>
    /// <param name="brood">Creatures that were met.</param>
    /// <param name="known">Creatures that were judged before; one of them that is born again is not asked again.</param>
    public Individual[] Judge(IReadOnlyList<Individual> brood, IReadOnlyList<Individual> known)
    {
        Individual[] judged = new List<Individual>(brood).ToArray();
        if (goal.Asks(CriterionInput.Motion))
        {
            WatchMotion(judged, known);
        }

        return goal.Asks(CriterionInput.Company) && known.Count == 0 ? Compare(judged) : judged;
    }

    /// <summary>Compares all creatures with each other.</summary>
    public Individual[] Compare(IReadOnlyList<Individual> all)
    {
        var compared = new Individual[all.Count];
        IndependentParts.Run(compared.Length, Work.Threads, i =>
        {
            Work.Cancellation.ThrowIfCancellationRequested();
            var company = new List<CreatureBlueprint>(all.Count);
            foreach (Individual other in all)
            {
                if (other.Identity != all[i].Identity && other.Verdict != Verdict.Freak)
                {
                    company.Add(other.Blueprint);
                }
            }

            compared[i] = all[i].Verdict == Verdict.Freak ? all[i] : With(all[i], goal.Ask(CriterionInput.Company, new Candidate(all[i].Blueprint, company), all[i].Scores));
        });
        return compared;
    }

    /// <summary>Where cheaper criteria have spoken, only the better half is watched.</summary>
    private void WatchMotion(Individual[] brood, IReadOnlyList<Individual> known)
    {
        bool spoken = goal.Asks(CriterionInput.Blueprint) || goal.Asks(CriterionInput.Creature);
        double[] merits = Array.ConvertAll(brood, one => one.Verdict == Verdict.Freak ? -1 : goal.Total(one.Scores, CriterionInput.Blueprint, CriterionInput.Creature));
        int[] order = Ranking.Order(merits);
        int watched = spoken ? (brood.Length + 1) / 2 : brood.Length;
        IndependentParts.Run(order.Length, Work.Threads, place =>
        {
            Work.Cancellation.ThrowIfCancellationRequested();
            Individual one = brood[order[place]];
            if (one.Verdict == Verdict.Freak)
            {
                return;
            }

            if (Before(one, known) is Individual before)
            {
                brood[order[place]] = before;
            }
            else if (place < watched)
            {
                brood[order[place]] = With(one, goal.Ask(CriterionInput.Motion, new Candidate(one.Blueprint, Array.Empty<CreatureBlueprint>()), one.Scores));
                Work.Progress?.Invoke();
            }
            else
            {
                brood[order[place]] = one with { Verdict = Verdict.SetAside, Score = 0 };
            }
        });
    }

    private static Individual? Before(Individual one, IReadOnlyList<Individual> known)
    {
        foreach (Individual other in known)
        {
            if (other.Identity == one.Identity)
            {
                return other;
            }
        }

        return null;
    }

    private Individual With(Individual one, ValueList<double> scores) => one with { Scores = scores, Score = one.Verdict == Verdict.Judged ? goal.Total(scores) : 0 };
}
