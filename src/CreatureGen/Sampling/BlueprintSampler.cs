using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Seeding;

namespace CreatureGen.Sampling;

/// <summary>From a seed to a blueprint: the only place where anything is random.</summary>
public static class BlueprintSampler
{
    /// <summary>The blueprint of a seed.</summary>
    public static CreatureBlueprint Sample(ulong seed, LocomotionKind? kind)
    {
        var root = new Seed(seed);
        LocomotionKind chosen = kind ?? CreatureDraft.Choose(root.Child("kind").Stream(), (LocomotionKind.Walking, 0.55), (LocomotionKind.Flying, 0.22), (LocomotionKind.Swimming, 0.23));
        FamilyProfile family = ChooseFamily(root, chosen);
        BodyPlan plan = ChoosePlan(root, chosen, family);
        CreatureDraft draft = Stand(root, chosen, family, plan);
        FinSampler.Sample(draft);
        HeadSampler.AddEars(draft);
        FeatureSampler.Sample(draft);
        HeadBlueprint head = HeadSampler.Sample(draft);
        CoatBlueprint coat = CoatSampler.Sample(draft);
        double scale = draft.Stream("scale").Uniform(0.5, 2);
        return new CreatureBlueprint(
            CreatureBlueprint.CurrentVersion,
            seed,
            chosen,
            draft.Plan,
            scale,
            new BodyBlueprint(draft.Blend, draft.Proportions, draft.Posture, draft.Slices, draft.Elevation),
            head,
            draft.Tail,
            new ValueList<LegBlueprint>(draft.Legs),
            new ValueList<WingBlueprint>(draft.Wings),
            new ValueList<InsectWingBlueprint>(draft.InsectWings),
            new ValueList<FinBlueprint>(draft.Fins),
            new ValueList<EarBlueprint>(draft.Ears),
            new ValueList<FeatureBlueprint>(draft.Features),
            coat);
    }

    /// <summary>Draws body and legs; when the body cannot carry the legs of its plan, that of the plan which it can.</summary>
    private static CreatureDraft Stand(Seed root, LocomotionKind kind, FamilyProfile family, BodyPlan plan)
    {
        const int Changes = 3;
        for (int change = 0; ; change++)
        {
            var draft = new CreatureDraft(root, kind, family, plan);
            BodySampler.Sample(draft);
            StanceSampler.Settle(draft);
            BodyPlan? other = LegSampler.Sample(draft);
            if (other == null || change == Changes)
            {
                return draft;
            }

            plan = other.Value;
        }
    }

    private static FamilyProfile ChooseFamily(Seed root, LocomotionKind kind)
    {
        IReadOnlyList<FamilyProfile> families = FamilyProfiles.All;
        double[] weights = new double[families.Count];
        for (int i = 0; i < weights.Length; i++)
        {
            (double walking, double flying, double swimming) = families[i].Frequency;
            weights[i] = kind switch { LocomotionKind.Walking => walking, LocomotionKind.Flying => flying, _ => swimming };
        }

        return families[root.Child("family").Stream().Weighted(weights)];
    }

    private static BodyPlan ChoosePlan(Seed root, LocomotionKind kind, FamilyProfile family)
    {
        RandomStream random = root.Child("plan").Stream();
        return kind switch
        {
            LocomotionKind.Walking => CreatureDraft.Choose(random, family.WalkingPlans),
            LocomotionKind.Flying => family.Body == "insect" || random.Chance(0.06) ? BodyPlan.Buzzing : BodyPlan.Flapping,
            _ => CreatureDraft.Choose(random, family.SwimmingPlans),
        };
    }
}
