using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling.Placement;

/// <summary>
/// Places the legs and arms of a walker: the rules of <see cref="LegRules"/> and <see cref="ArmRules"/>, and what makes their outcome stand. Legs never cross, are never tiny,
/// and the creature is balanced or the answer says what it lacks.
/// </summary>
internal static class WalkingRules
{
    /// <summary>Step by which a body is lowered when long legs leave no room for the pairs that its anatomy needs, relative to its height.</summary>
    private const double LoweringStep = 0.06;

    private const int LoweringSteps = 9;

    /// <summary>Places the limbs of a walker.</summary>
    /// <param name="measure">Its torso.</param>
    /// <param name="set">Its anatomy.</param>
    /// <param name="size">Size of its legs.</param>
    /// <param name="stream">Decides on arms; exactly one number is drawn.</param>
    /// <exception cref="ArgumentOutOfRangeException">A size is not positive.</exception>
    public static WalkingPlacement Place(SpineMeasure measure, SocketSet set, LegSize size, RandomStream stream)
    {
        LegFitting.Check(size);
        double dice = stream.Uniform();
        Attempt attempt = Settle(measure, set, set.Legs, size);
        ArmPlacement? arms = null;
        if (set.Arms is not null && attempt.Chosen.Count > 0 && dice < ArmRules.Odds(attempt.Field.Measure, set.Arms, attempt.Legs()))
        {
            Attempt armed = ReferenceEquals(set.Arms.Legs, set.Legs) ? attempt : Settle(measure, set, set.Arms.Legs, size);
            arms = armed.Score <= attempt.Score ? ArmRules.Place(armed.Field.Measure, set.Arms, size, armed.Legs()) : null;
            attempt = arms is null ? attempt : armed;
        }

        BodyPlan? change = attempt.Chosen.Count >= set.MinimumPairs ? null : attempt.Field.AnyTooLow() ? set.Stance.LowerPlan : set.Stance.FewerPlan;
        return new WalkingPlacement(set.Plan, attempt.Rule, attempt.Legs(), attempt.Completed, attempt.Girth, arms, attempt.Raise, change, attempt.Balance);
    }

    /// <summary>
    /// The rules' choice if it stands; else, in this order, with slimmer legs, with one pair under the centre of mass, with a lower body; the first of the best is taken.
    /// </summary>
    private static Attempt Settle(SpineMeasure measure, SocketSet set, IReadOnlyList<LimbSocket> sockets, LegSize size)
    {
        if (set.TakesAll)
        {
            return Choose(measure, set, sockets, size, set.Girth, 0, AllPlaces);
        }

        Attempt best = Choose(measure, set, sockets, size, LegGirth.Nominal, 0, LegRules.Choose);
        if (best.Score > 0)
        {
            best = Better(best, Choose(measure, set, sockets, size, LegGirth.Min, 0, LegRules.Choose));
        }

        if (best.Score > 0 && set.MinimumPairs <= 1)
        {
            best = Better(best, Choose(measure, set, sockets, size, LegGirth.Nominal, 0, OnePairUnderMass));
        }

        for (int step = 1; step <= LoweringSteps && best.Chosen.Count < set.MinimumPairs; step++)
        {
            Attempt lower = Choose(measure, set, sockets, size, LegGirth.Min, -LoweringStep * step * Math.Max(0, measure.BodyHeight), LegRules.Choose);
            best = Better(best, lower);
        }

        return best;
    }

    /// <summary>Chooses legs for a body that starts at a given height and is then raised until none of them is too short.</summary>
    private static Attempt Choose(
        SpineMeasure measure,
        SocketSet set,
        IReadOnlyList<LimbSocket> sockets,
        LegSize size,
        LegGirth girth,
        double raise,
        Func<LegField, (WalkingRule Rule, List<int> Sockets)> rule)
    {
        // Every round raises to the next higher demand of some socket, so there are no more rounds than sockets.
        for (int round = 0; ; round++)
        {
            var field = new LegField(measure.Raised(raise), set, sockets, size, girth, raise);
            (WalkingRule decided, List<int> chosen) = rule(field);
            int completed = LegRules.Complete(field, chosen, set.MinimumPairs);
            double shortage = 0;
            foreach (int socket in chosen)
            {
                shortage = Math.Max(shortage, field.Shortage(socket));
            }

            if (shortage <= LegField.LengthTolerance || round > sockets.Count)
            {
                chosen.Sort();
                BalanceCorrection? balance = chosen.Count == 0 ? null : field.Correct(chosen);
                return new Attempt(field, decided, chosen, completed, girth, raise, balance);
            }

            raise += shortage;
        }
    }

    private static (WalkingRule Rule, List<int> Sockets) AllPlaces(LegField field)
    {
        var chosen = new List<int>();
        for (int i = 0; i < field.Count; i++)
        {
            chosen.Add(i);
        }

        return (WalkingRule.AsManyAsFit, chosen);
    }

    private static (WalkingRule Rule, List<int> Sockets) OnePairUnderMass(LegField field)
    {
        var chosen = new List<int>();
        int socket = LegRules.UnderMass(field);
        if (socket >= 0)
        {
            chosen.Add(socket);
        }

        return (WalkingRule.OnePairUnderMass, chosen);
    }

    private static Attempt Better(Attempt first, Attempt second) => second.Score < first.Score ? second : first;

    private sealed record Attempt(
        LegField Field,
        WalkingRule Rule,
        List<int> Chosen,
        int Completed,
        LegGirth Girth,
        double Raise,
        BalanceCorrection? Balance)
    {
        /// <summary>0 when the legs stand; the more the worse. A pitch of the torso is no fault: bipeds live by it.</summary>
        public int Score
        {
            get
            {
                int missing = Math.Max(0, Field.Set.MinimumPairs - Chosen.Count);
                int remedy = Balance is null || Balance.Remedy <= BalanceRemedy.PitchTorso ? 0 : (int)Balance.Remedy;
                return (10 * missing) + remedy;
            }
        }

        public List<LegPlacement> Legs() => Balance is null ? new List<LegPlacement>() : Field.Corrected(Chosen, Balance);
    }
}
