using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Json;

namespace CreatureGen.Sampling;

/// <summary>Checks options: each field, and what the fields say together.</summary>
internal static class OptionsRules
{
    /// <summary>All problems of options.</summary>
    public static IReadOnlyList<Problem> Validate(CreatureOptions options)
    {
        var problems = new ProblemList(OptionsJson.What);
        FieldChecker.Check(options, OptionsFields.Options, problems);
        Check(options, problems);
        return problems.All;
    }

    /// <summary>Lists what contradicts itself. Fields that are out of range themselves are passed over.</summary>
    public static void Check(CreatureOptions options, ProblemList problems)
    {
        if (options.MinScale > options.MaxScale)
        {
            problems.Add("minScale", NumberText.Of(options.MinScale), "at most maxScale, which is " + NumberText.Of(options.MaxScale));
        }

        if (options.MinLegPairs > options.MaxLegPairs)
        {
            problems.Add("minLegPairs", Text(options.MinLegPairs), "at most maxLegPairs, which is " + Text(options.MaxLegPairs));
        }

        if (HasFew(options.BodyPlans, AnatomyChoices.Plan.Count))
        {
            CheckPlans(options, problems);
        }

        if (HasFew(options.BaseBodies, BaseBodyNames.All.Count))
        {
            CheckBodies(options.BaseBodies, problems);
        }
    }

    private static bool HasFew<T>(ValueList<T>? list, int max)
        where T : IEquatable<T> => list != null && list.Count <= max;

    private static void CheckPlans(CreatureOptions options, ProblemList problems)
    {
        var excluded = new List<BodyPlan>();
        for (int i = 0; i < options.BodyPlans.Count; i++)
        {
            BodyPlanWeight plan = options.BodyPlans[i];
            for (int k = 0; k < i; k++)
            {
                if (options.BodyPlans[k].Plan == plan.Plan && AnatomyChoices.Plan.NameOf(plan.Plan) is string name)
                {
                    problems.Add(FormattableString.Invariant($"bodyPlans[{i}].plan"), name, FormattableString.Invariant($"each plan once; bodyPlans[{k}] has it too"));
                    break;
                }
            }

            if (plan.Weight == 0)
            {
                excluded.Add(plan.Plan);
            }
        }

        bool left = false;
        foreach (BodyPlan plan in AnatomyChoices.Plan.Values)
        {
            left |= IsAskedFor(plan, options.Kind) && !excluded.Contains(plan);
        }

        if (!left)
        {
            string kind = options.Kind == RequestedKind.Any ? "" : ", for this kind of creature";
            problems.Add("bodyPlans", "all excluded", "at least one plan with a weight above 0" + kind);
        }
    }

    private static bool IsAskedFor(BodyPlan plan, RequestedKind kind) => kind switch
    {
        RequestedKind.Walking => BlueprintRules.KindOf(plan) == LocomotionKind.Walking,
        RequestedKind.Flying => BlueprintRules.KindOf(plan) == LocomotionKind.Flying,
        RequestedKind.Swimming => BlueprintRules.KindOf(plan) == LocomotionKind.Swimming,
        _ => true,
    };

    private static void CheckBodies(ValueList<BaseBodyWeight> bodies, ProblemList problems)
    {
        var excluded = new List<string>();
        for (int i = 0; i < bodies.Count; i++)
        {
            for (int k = 0; k < i; k++)
            {
                if (FieldChecker.IsKnown(bodies[i].Name, BaseBodyNames.All) && string.Equals(bodies[k].Name, bodies[i].Name, StringComparison.Ordinal))
                {
                    problems.Add(
                        FormattableString.Invariant($"baseBodies[{i}].name"),
                        Excerpt.Quoted(bodies[i].Name),
                        FormattableString.Invariant($"each name once; baseBodies[{k}] has it too"));
                    break;
                }
            }

            if (bodies[i].Weight == 0)
            {
                excluded.Add(bodies[i].Name);
            }
        }

        foreach (string name in BaseBodyNames.All)
        {
            if (!excluded.Contains(name))
            {
                return;
            }
        }

        problems.Add("baseBodies", "all excluded", "at least one base body with a weight above 0");
    }

    private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);
}
