using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Sampling.Coats;
using CreatureGen.Sampling.Features;
using CreatureGen.Sampling.Individuals;
using CreatureGen.Sampling.Limbs;
using CreatureGen.Sampling.Parents;
using CreatureGen.Sampling.Shapes;
using CreatureGen.Seeding;
using CreatureGen.Species;

namespace CreatureGen.Sampling;

/// <summary>From a seed to a blueprint: the only place where anything is random.</summary>
/// <remarks>Every decision draws from a stream of its own, found by name in the seed tree: a decision added tomorrow changes none of today's.</remarks>
public static class BlueprintSampler
{
    /// <summary>How often a creature is drawn anew until its number of legs is what the options ask for.</summary>
    private const int Attempts = 200;

    /// <summary>How often a body may change to the plan that it can carry.</summary>
    private const int PlanChanges = 3;

    /// <summary>How often a creature that does not keep the promises is drawn with less strangeness before it is drawn with none.</summary>
    private const int Withdrawals = 5;

    /// <summary>Part of the strangeness that is kept then.</summary>
    private const double Kept = 0.75;

    /// <summary>Probability at full strangeness that what goes on four legs has arms as well.</summary>
    private const double Armed = 0.25;

    /// <summary>The blueprint of a seed that asks for nothing in particular.</summary>
    public static CreatureBlueprint Sample(ulong seed) => Sample(seed, CreatureOptions.Default);

    /// <summary>The blueprint of a seed that asks for a kind alone.</summary>
    public static CreatureBlueprint Sample(ulong seed, LocomotionKind kind) =>
        Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking + (int)kind });

    /// <summary>The blueprint of a seed within options. Options that the seed's own creature meets do not change it.</summary>
    /// <exception cref="ArgumentException">The options are not valid, or no creature meets them; the message says why.</exception>
    /// <exception cref="ImpossibleSeedException">This seed gave no creature that meets the options; another may.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options) => Sample(seed, options, out _);

    /// <summary>The same, and how the sockets of its limbs were given out.</summary>
    /// <exception cref="ArgumentException">The options are not valid, or no creature meets them; the message says why.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options, out SocketTally sockets)
    {
        options.ThrowIfInvalid();
        var root = new Seed(seed);
        foreach ((Seed drawn, PlanChoice choice, CreatureOptions limits) in AttemptsAt(root, options))
        {
            double strangeness = options.Strangeness;
            for (int withdrawal = 0; Stand(drawn, choice, limits, strangeness) is CreatureBuilder builder; withdrawal++)
            {
                CreatureBlueprint type = Finish(seed, builder, options, out sockets);
                if (strangeness == 0 || Soundness.Holds(type, builder, sockets))
                {
                    if (type.Legs.Count < options.MinLegPairs || type.Legs.Count > options.MaxLegPairs)
                    {
                        break;
                    }

                    return options.Individual is ulong individual ? IndividualSampler.Vary(type, builder, IndividualTraits.Draw(root, individual), options) : type;
                }

                // The draws stay what they were: with less strangeness fewer of them let another parent give.
                strangeness = withdrawal < Withdrawals ? Kept * strangeness : 0;
            }
        }

        throw new ImpossibleSeedException(
            FormattableString.Invariant($"seed {seed} gave no creature with {options.MinLegPairs} to {options.MaxLegPairs} pairs of limbs in {Attempts} attempts; expected options that leave more choice"),
            nameof(options));
    }

    /// <summary>What is tried for a seed, one after the other: draws, what they choose among, and how many legs they may have.</summary>
    private static IEnumerable<(Seed Drawn, PlanChoice Choice, CreatureOptions Limits)> AttemptsAt(Seed root, CreatureOptions options)
    {
        var choice = new PlanChoice(options);
        CreatureOptions uncounted = options with { MinLegPairs = CreatureOptions.Default.MinLegPairs, MaxLegPairs = CreatureOptions.Default.MaxLegPairs };
        if (uncounted != options)
        {
            // First the creature that it is when nobody counts its legs, then the same with as many as are asked for.
            var free = new PlanChoice(uncounted);
            yield return (root, free, uncounted);
            yield return (root, free, options);
        }

        yield return (root, choice, options);
        for (int attempt = 1; attempt < Attempts; attempt++)
        {
            yield return (root.Child("attempt").Child(attempt), choice, options);
        }
    }

    /// <summary>Draws body and legs; null when the number of limbs is not what the options ask for.</summary>
    private static CreatureBuilder? Stand(Seed root, PlanChoice choice, CreatureOptions options, double asked)
    {
        LocomotionKind kind = choice.Kind(root.Child("kind").Stream());
        SpeciesProfile mover = choice.Species(root.Child("family").Stream(), kind);
        double strangeness = choice.LeavesOthers(mover) ? asked : 0;
        SpeciesProfile first = choice.Stranger(root.Child("strange family").Stream(), kind, mover, strangeness);
        Parentage parents = ParentSampler.Draw(root, kind, first, mover, choice, strangeness);
        BodyPlan plan = choice.Plan(root.Child("plan").Stream(), kind, parents.Legs);
        plan = choice.Allows(parents.Legs, BodyPlan.Centaur) && root.Child("arms of a quadruped").Stream().Chance(Armed * strangeness) ? LegSampler.WithArms(plan) : plan;
        for (int change = 0; ; change++)
        {
            var builder = new CreatureBuilder(root, kind, Harmony.On(parents, plan), plan, strangeness) { MinLegPairs = options.MinLegPairs, MaxLegPairs = options.MaxLegPairs };
            BodySampler.Sample(builder);
            StanceSampler.Settle(builder);
            BodyPlan? other = LegSampler.Sample(builder);
            if (other is BodyPlan next && change < PlanChanges && choice.Allows(parents.Legs, next))
            {
                plan = next;
                continue;
            }

            bool fits = other == null && builder.Legs.Count >= options.MinLegPairs && builder.Legs.Count <= options.MaxLegPairs;
            return fits ? builder : null;
        }
    }

    private static CreatureBlueprint Finish(ulong seed, CreatureBuilder builder, CreatureOptions options, out SocketTally sockets)
    {
        FinSampler.Sample(builder);
        int refused = builder.Sockets.Refusals;
        HeadSampler.AddEars(builder);
        sockets = new SocketTally(refused, builder.Sockets.Refusals - refused, builder.Sockets.TakenCells);
        FeatureSampler.Sample(builder, options.Ornaments);
        HeadBlueprint head = HeadSampler.Sample(builder);
        CoatBlueprint coat = CoatSampler.Sample(builder, options.Palette);
        double scale = NaturalSize.Draw(builder, options);
        return ForkSampler.Add(builder, new CreatureBlueprint(
            CreatureBlueprint.CurrentAlgorithm,
            seed,
            builder.Kind,
            builder.Plan,
            scale,
            options.TriangleBudget,
            builder.Body,
            head,
            builder.Tail,
            ValueList<LegBlueprint>.Of(builder.Legs),
            ValueList<WingBlueprint>.Of(builder.Wings),
            ValueList<InsectWingBlueprint>.Of(builder.InsectWings),
            ValueList<FinBlueprint>.Of(builder.Fins),
            ValueList<EarBlueprint>.Of(builder.Ears),
            ValueList<FeatureBlueprint>.Of(builder.Features),
            ValueList<ManeBlueprint>.Of(builder.Manes),
            ValueList<FrillBlueprint>.Of(builder.Frills),
            coat));
    }
}
