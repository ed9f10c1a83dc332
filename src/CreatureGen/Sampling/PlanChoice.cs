using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling.Limbs;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling;

/// <summary>Kinds, species and plans with their probabilities, as options narrow them.</summary>
internal sealed class PlanChoice
{
    /// <summary>How often kinds are drawn when any is asked for.</summary>
    private static readonly double[] kindWeights = { 0.55, 0.22, 0.23 };

    /// <summary>Probability at full strangeness that the first parent is any body, and not one of those that are common among creatures of its kind.</summary>
    private const double AnyBody = 0.9;

    private readonly CreatureOptions options;

    /// <summary>Whether there are bodies with fewer or more legs than the options ask for: no body has more than the most that they can ask for.</summary>
    private readonly bool countsLegs;

    /// <summary>The weight of each species, by kind, where options narrow nothing: working them out for every creature was an eighth of its blueprint.</summary>
    private static readonly double[][] wholeWeights = WholeWeights();

    /// <summary>The weight of each species, by kind: asked for with every draw, and the same each time.</summary>
    private readonly double[]?[] speciesWeights;

    /// <summary>How often a kind is asked for, over all species, by kind: asked for three times by every blueprint.</summary>
    private readonly double[] kindsAsked = new double[kindWeights.Length];

    private PlanChoice(CreatureOptions options, double[]?[] speciesWeights)
    {
        this.options = options;
        this.speciesWeights = speciesWeights;
    }

    /// <summary>Narrows the choice.</summary>
    /// <exception cref="ArgumentException">Nothing is left.</exception>
    public PlanChoice(CreatureOptions options)
    {
        this.options = options;
        countsLegs = options.MinLegPairs > CreatureOptions.Default.MinLegPairs || options.MaxLegPairs < CreatureOptions.Default.MaxLegPairs;
        speciesWeights = countsLegs || options.BodyPlans.Count > 0 || options.BaseBodies.Count > 0 ? new double[kindWeights.Length][] : wholeWeights;
        double total = 0;
        for (int kind = 0; kind < kindWeights.Length; kind++)
        {
            kindsAsked[kind] = WeightOf((LocomotionKind)kind);
            total += kindsAsked[kind];
        }

        if (!(total > 0))
        {
            throw new ArgumentException("no creature has the kind, body plans, base bodies and number of limbs that the options ask for; expected options that leave at least one", nameof(options));
        }
    }

    /// <summary>Whether a body moves in a way by itself, or can be carried by the limbs of another: insects by those of insects alone, and edges as wide as wings by none.</summary>
    private bool Carries(SpeciesProfile body, LocomotionKind kind, SpeciesProfile carrier) => kind switch
    {
        _ when body.FrequencyOf(kind) == 0 && body.Disc.Sweep != 0 => false,
        LocomotionKind.Walking => Leaves(body, kind) || (body.Class != AnimalClass.Arthropod && carrier.Class != AnimalClass.Arthropod),
        LocomotionKind.Flying => Leaves(body, kind) && (body.Legs is null || body.Wings != null),
        _ => Leaves(body, kind) && (body.FrequencyOf(kind) > 0 || body.Class != AnimalClass.Arthropod),
    };

    /// <summary>Whether options leave a plan.</summary>
    public bool Allows(SpeciesProfile species, BodyPlan plan) => FactorOf(species, plan) > 0;

    /// <summary>Whether options leave any plan of a kind.</summary>
    public bool Leaves(SpeciesProfile species, LocomotionKind kind) => Array.Exists(species.PlansOf(kind), plan => plan.Weight > 0 && Allows(species, plan.Value));

    /// <summary>How often options ask for a body, relative to others.</summary>
    public double WeightOf(SpeciesProfile species)
    {
        foreach (BaseBodyWeight body in options.BaseBodies)
        {
            if (body.Name == species.Body)
            {
                return body.Weight;
            }
        }

        return species.OnlyByName ? 0 : 1;
    }

    /// <summary>Whether options leave any other body.</summary>
    public bool LeavesOthers(SpeciesProfile species) => SpeciesCatalogue.All.Any(other => other != species && WeightOf(other) > 0);

    /// <summary>Draws a kind.</summary>
    public LocomotionKind Kind(RandomStream random)
    {
        double[] weights = new double[kindWeights.Length];
        for (int kind = 0; kind < weights.Length; kind++)
        {
            weights[kind] = kindsAsked[kind] > 0 ? kindWeights[kind] * Asked((LocomotionKind)kind) : 0;
        }

        return (LocomotionKind)random.Weighted(weights);
    }

    /// <summary>Draws a species.</summary>
    public SpeciesProfile Species(RandomStream random, LocomotionKind kind) => SpeciesCatalogue.All[random.Weighted(WeightsOf(kind))];

    /// <summary>
    /// Any body in place of one that was drawn, all as often as the options ask for them: on a strange creature the trunk of a shark may stand on legs. The one that was drawn lends
    /// it how it moves.
    /// </summary>
    public SpeciesProfile Stranger(RandomStream random, LocomotionKind kind, SpeciesProfile drawn, double strangeness)
    {
        if (!random.Chance(AnyBody * strangeness))
        {
            return drawn;
        }

        IReadOnlyList<SpeciesProfile> all = SpeciesCatalogue.All;
        double[] weights = new double[all.Count];
        bool any = false;
        for (int i = 0; i < weights.Length; i++)
        {
            weights[i] = Carries(all[i], kind, drawn) ? WeightOf(all[i]) : 0;
            any |= weights[i] > 0;
        }

        return any ? all[random.Weighted(weights)] : drawn;
    }

    /// <summary>Draws a plan.</summary>
    public BodyPlan Plan(RandomStream random, LocomotionKind kind, SpeciesProfile species)
    {
        Weighted<BodyPlan>[] plans = species.PlansOf(kind);
        double[] weights = new double[plans.Length];
        for (int i = 0; i < weights.Length; i++)
        {
            weights[i] = plans[i].Weight * FactorOf(species, plans[i].Value);
        }

        return plans[random.Weighted(weights)].Value;
    }

    /// <summary>Fewest and most pairs of legs and arms of a plan with a body's legs: birds have wings for arms, and only insects more legs than winged beasts.</summary>
    private static (int Min, int Max) PairsOf(SpeciesProfile species, BodyPlan plan) => plan switch
    {
        BodyPlan.Theropod when species.Bird != null => (1, 1),
        BodyPlan.Buzzing when species.Class != AnimalClass.Arthropod => (0, FlierLegs.MaxUnderOthers),
        BodyPlan.Centaur => (3, 3),
        BodyPlan.Theropod or BodyPlan.Upright => (1, 2),
        BodyPlan.Hexapod => (3, 4),
        BodyPlan.ManyLegged => (4, 9),
        BodyPlan.Flapping => (0, FlierLegs.MaxUnderOthers),
        BodyPlan.Buzzing => (0, 8),
        _ when ExtraLegs.Suits(plan) => (2, ExtraLegs.Max),
        BodyPlan.Legless or BodyPlan.Fish or BodyPlan.Eel or BodyPlan.Whale or BodyPlan.Flipper => (0, 0),
        _ => (2, 2),
    };

    private double Asked(LocomotionKind kind) => options.Kind switch
    {
        RequestedKind.Any => 1,
        RequestedKind.Walking => kind == LocomotionKind.Walking ? 1 : 0,
        RequestedKind.Flying => kind == LocomotionKind.Flying ? 1 : 0,
        _ => kind == LocomotionKind.Swimming ? 1 : 0,
    };

    private double WeightOf(LocomotionKind kind)
    {
        if (Asked(kind) == 0)
        {
            return 0;
        }

        double sum = 0;
        foreach (double weight in WeightsOf(kind))
        {
            sum += weight;
        }

        return sum * Asked(kind);
    }

    private double[] WeightsOf(LocomotionKind kind) => speciesWeights[(int)kind] ??= SpeciesWeights(kind);

    private double[] SpeciesWeights(LocomotionKind kind)
    {
        IReadOnlyList<SpeciesProfile> all = SpeciesCatalogue.All;
        double[] weights = new double[all.Count];
        for (int i = 0; i < weights.Length; i++)
        {
            weights[i] = WeightOf(kind, all[i]);
        }

        return weights;
    }

    private static double[][] WholeWeights()
    {
        double[][] weights = new double[kindWeights.Length][];
        var whole = new PlanChoice(CreatureOptions.Default, new double[kindWeights.Length][]);
        for (int kind = 0; kind < weights.Length; kind++)
        {
            weights[kind] = whole.SpeciesWeights((LocomotionKind)kind);
        }

        return weights;
    }

    private double WeightOf(LocomotionKind kind, SpeciesProfile species)
    {
        double whole = 0;
        double left = 0;
        foreach (Weighted<BodyPlan> plan in species.PlansOf(kind))
        {
            whole += plan.Weight;
            left += plan.Weight * FactorOf(species, plan.Value);
        }

        return whole > 0 ? species.FrequencyOf(kind) * WeightOf(species) * left / whole : 0;
    }

    private double FactorOf(SpeciesProfile species, BodyPlan plan)
    {
        if (countsLegs && !HasAskedLegs(species, plan))
        {
            return 0;
        }

        foreach (BodyPlanWeight weight in options.BodyPlans)
        {
            if (weight.Plan == plan)
            {
                return weight.Weight;
            }
        }

        return 1;
    }

    private bool HasAskedLegs(SpeciesProfile species, BodyPlan plan)
    {
        (int min, int max) = PairsOf(species, plan);
        if ((BlueprintRules.KindOf(plan) == LocomotionKind.Swimming ? species.Paddles : species.Legs) is LegPreset own)
        {
            min = max = own.SitesWithin(options.MinLegPairs, options.MaxLegPairs).Length + own.Arms.Length;
        }

        return max >= options.MinLegPairs && min <= options.MaxLegPairs;
    }
}
