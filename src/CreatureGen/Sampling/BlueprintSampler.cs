using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>From a seed to a blueprint: the only place where anything is random.</summary>
/// <remarks>Every decision draws from a stream of its own, found by name in the seed tree: a decision added tomorrow changes none of today's.</remarks>
public static class BlueprintSampler
{
    /// <summary>How often a creature is drawn anew until its number of legs is what the options ask for.</summary>
    private const int Attempts = 200;

    /// <summary>How often a body may change to the plan that it can carry.</summary>
    private const int PlanChanges = 3;

    /// <summary>The blueprint of a seed that asks for nothing in particular.</summary>
    public static CreatureBlueprint Sample(ulong seed) => Sample(seed, CreatureOptions.Default);

    /// <summary>The blueprint of a seed that asks for a kind alone.</summary>
    public static CreatureBlueprint Sample(ulong seed, LocomotionKind kind) =>
        Sample(seed, CreatureOptions.Default with { Kind = RequestedKind.Walking + (int)kind });

    /// <summary>The blueprint of a seed within options. Options that the seed's own creature meets do not change it.</summary>
    /// <exception cref="ArgumentException">The options are not valid, or no creature meets them; the message says why.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options) => Sample(seed, options, out _);

    /// <summary>The same, and how the sockets of its limbs were given out.</summary>
    /// <exception cref="ArgumentException">The options are not valid, or no creature meets them; the message says why.</exception>
    public static CreatureBlueprint Sample(ulong seed, CreatureOptions options, out SocketTally sockets)
    {
        options.ThrowIfInvalid();
        var choice = new PlanChoice(options);
        for (int attempt = 0; attempt < Attempts; attempt++)
        {
            var root = new Seed(seed);
            CreatureDraft? draft = Stand(attempt == 0 ? root : root.Child("attempt").Child(attempt), choice, options);
            if (draft != null)
            {
                CreatureBlueprint type = Finish(seed, draft, options, out sockets);
                return options.Individual is ulong individual ? IndividualSampler.Vary(type, draft, IndividualTraits.Draw(root, individual), options) : type;
            }
        }

        throw new ArgumentException(
            FormattableString.Invariant($"seed {seed} gave no creature with {options.MinLegPairs} to {options.MaxLegPairs} pairs of limbs in {Attempts} attempts; expected options that leave more choice"),
            nameof(options));
    }

    /// <summary>Draws body and legs; null when the number of limbs is not what the options ask for.</summary>
    private static CreatureDraft? Stand(Seed root, PlanChoice choice, CreatureOptions options)
    {
        LocomotionKind kind = choice.Kind(root.Child("kind").Stream());
        SpeciesProfile species = choice.Species(root.Child("family").Stream(), kind);
        BodyPlan plan = choice.Plan(root.Child("plan").Stream(), kind, species);
        for (int change = 0; ; change++)
        {
            var draft = new CreatureDraft(root, kind, species, plan);
            BodySampler.Sample(draft);
            StanceSampler.Settle(draft);
            BodyPlan? other = LegSampler.Sample(draft);
            if (other is BodyPlan next && change < PlanChanges && choice.Allows(species, next))
            {
                plan = next;
                continue;
            }

            bool fits = other == null && draft.Legs.Count >= options.MinLegPairs && draft.Legs.Count <= options.MaxLegPairs;
            return fits ? draft : null;
        }
    }

    private static CreatureBlueprint Finish(ulong seed, CreatureDraft draft, CreatureOptions options, out SocketTally sockets)
    {
        FinSampler.Sample(draft);
        int refused = draft.Sockets.Refusals;
        HeadSampler.AddEars(draft);
        sockets = new SocketTally(refused, draft.Sockets.Refusals - refused, draft.Sockets.TakenCells);
        FeatureSampler.Sample(draft, options.Ornaments);
        HeadBlueprint head = HeadSampler.Sample(draft);
        CoatBlueprint coat = CoatSampler.Sample(draft, options.Palette);
        double scale = draft.Stream("scale").Uniform(options.MinScale, options.MaxScale);
        return new CreatureBlueprint(
            CreatureBlueprint.CurrentAlgorithm,
            seed,
            draft.Kind,
            draft.Plan,
            scale,
            options.TriangleBudget,
            draft.Body,
            head,
            draft.Tail,
            new ValueList<LegBlueprint>(draft.Legs),
            new ValueList<WingBlueprint>(draft.Wings),
            new ValueList<InsectWingBlueprint>(draft.InsectWings),
            new ValueList<FinBlueprint>(draft.Fins),
            new ValueList<EarBlueprint>(draft.Ears),
            new ValueList<FeatureBlueprint>(draft.Features),
            new ValueList<ManeBlueprint>(draft.Manes),
            new ValueList<FrillBlueprint>(draft.Frills),
            coat);
    }
}
