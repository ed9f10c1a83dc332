using System;
using CreatureGen.Anatomy;
using CreatureGen.Json;
using CreatureGen.Maths;

namespace CreatureGen.Blueprints;

/// <summary>Checks what the range of no single field can say: parts that have to fit together. Parts that are out of range themselves are passed over.</summary>
internal static class BlueprintRules
{
    /// <summary>Least length of a direction; a shorter one points nowhere reliably.</summary>
    private const double LeastDirection = 0.1;

    /// <summary>Least part of a section's size that hollows have to leave, so that the head does not turn inside out.</summary>
    private const double LeastSection = 0.1;

    /// <summary>Lists what does not fit together.</summary>
    public static void Check(CreatureBlueprint blueprint, ProblemList problems)
    {
        CheckPlan(blueprint, problems);
        CheckHollows(blueprint.Head?.Bumps, problems);
        CheckShell(blueprint.Body?.Shell, problems);
        CheckTail(blueprint.Tail, problems);
        CheckFins(blueprint.Fins, problems);
        CheckDirections(blueprint, problems);
        CheckManes(blueprint.Manes, problems);
        SocketRules.Check(blueprint, problems);
    }

    /// <summary>How creatures of a plan move; null for an undefined plan.</summary>
    public static LocomotionKind? KindOf(BodyPlan plan) => plan switch
    {
        BodyPlan.Flapping or BodyPlan.Buzzing => LocomotionKind.Flying,
        BodyPlan.Fish or BodyPlan.Eel or BodyPlan.Whale or BodyPlan.Flipper => LocomotionKind.Swimming,
        _ => AnatomyChoices.Plan.NameOf(plan) is null ? null : LocomotionKind.Walking,
    };

    private static void CheckPlan(CreatureBlueprint blueprint, ProblemList problems)
    {
        LocomotionKind? kind = KindOf(blueprint.Plan);
        string? name = AnatomyChoices.Kind.NameOf(blueprint.Kind);
        if (kind != null && name != null && kind != blueprint.Kind)
        {
            problems.Add("plan", AnatomyChoices.Plan.NameOf(blueprint.Plan)!, "a plan of a " + name + " creature");
        }

        RequireWings("wings", blueprint.Plan == BodyPlan.Flapping, blueprint.Wings?.Count, problems);
        RequireWings("insectWings", blueprint.Plan == BodyPlan.Buzzing, blueprint.InsectWings?.Count, problems);
    }

    private static void RequireWings(string path, bool needed, int? count, ProblemList problems)
    {
        if (needed && count == 0)
        {
            problems.Add(path, FieldChecker.CountOf(0), "at least 1 element, the plan flies by them");
        }
    }

    private static void CheckHollows(ValueList<HeadBump>? bumps, ProblemList problems)
    {
        double depth = 0;
        foreach (HeadBump bump in bumps ?? ValueList<HeadBump>.Empty)
        {
            if (!FieldChecker.Accepts(bump, HeadFields.Bump))
            {
                return;
            }

            depth -= Math.Min(0, bump.Amount);
        }

        if (depth <= 1 - LeastSection)
        {
            return;
        }

        double least = ThinnestSection(bumps!, out int ring, out int segment);
        if (least < LeastSection)
        {
            string size = NumberText.Of(least);
            problems.Add("head.bumps", FormattableString.Invariant($"{size} of the section's size at ring {ring}, segment {segment}"), "at least " + NumberText.Of(LeastSection));
        }
    }

    /// <summary>The least factor that the bumps put on a section.</summary>
    private static double ThinnestSection(ValueList<HeadBump> bumps, out int ringOfLeast, out int segmentOfLeast)
    {
        double least = double.MaxValue;
        ringOfLeast = 0;
        segmentOfLeast = 0;
        for (int ring = 0; ring < BodyGrid.Rings; ring++)
        {
            for (int segment = 0; segment <= BodyGrid.Segments / 2; segment++)
            {
                double factor = 1;
                foreach (HeadBump bump in bumps)
                {
                    double u = (ring - bump.Ring) / bump.RingSpread;
                    double v = (segment - bump.Segment) / bump.SegmentSpread;
                    factor += bump.Amount * PortableMath.Exp(-((u * u) + (v * v)));
                }

                if (factor < least)
                {
                    least = factor;
                    ringOfLeast = ring;
                    segmentOfLeast = segment;
                }
            }
        }

        return least;
    }

    private static void CheckShell(ShellBlueprint? shell, ProblemList problems)
    {
        const int last = BodyGrid.Rings - 2;
        if (FieldChecker.Accepts(shell, BodyFields.Shell) && shell!.Style != ShellStyle.None && shell.Ring + shell.Rows > last)
        {
            problems.Add("body.shell", FormattableString.Invariant($"rings {shell.Ring}..{shell.Ring + shell.Rows}"), FormattableString.Invariant($"rings up to {last}"));
        }
    }

    private static void CheckTail(TailBlueprint? tail, ProblemList problems)
    {
        const double leastSize = 0.01;
        if (FieldChecker.Accepts(tail, LimbFields.Tail) && tail!.Style != TailStyle.Plain && tail.Size < leastSize)
        {
            problems.Add("tail.size", NumberText.Of(tail.Size), "at least " + NumberText.Of(leastSize) + " for a tail that is not plain");
        }
    }

    private static void CheckFins(ValueList<FinBlueprint>? fins, ProblemList problems)
    {
        const double leastWidth = 0.05;
        for (int i = 0; i < (fins?.Count ?? 0); i++)
        {
            FinBlueprint fin = fins![i];
            if (fin.Place == FinPlace.Pectoral && fin.Width >= 0 && fin.Width < leastWidth)
            {
                problems.Add(PathOf("fins", i, "width"), NumberText.Of(fin.Width), "at least " + NumberText.Of(leastWidth) + " for a pectoral fin");
            }
        }
    }

    private static void CheckManes(ValueList<ManeBlueprint>? manes, ProblemList problems)
    {
        for (int i = 0; i < (manes?.Count ?? 0); i++)
        {
            ManeBlueprint mane = manes![i];
            CheckOrder(PathOf("manes", i, "lastRing"), mane.Ring, mane.LastRing, problems);
            CheckOrder(PathOf("manes", i, "lastSegment"), mane.Segment, mane.LastSegment, problems);
        }
    }

    private static void CheckOrder(string path, double first, double last, ProblemList problems)
    {
        if (last < first)
        {
            problems.Add(path, NumberText.Of(last), "at least " + NumberText.Of(first) + ", where the field of hair begins");
        }
    }

    private static void CheckDirections(CreatureBlueprint blueprint, ProblemList problems)
    {
        for (int i = 0; i < (blueprint.Ears?.Count ?? 0); i++)
        {
            EarBlueprint ear = blueprint.Ears![i];
            CheckDirection(PathOf("ears", i, "outward"), ear.Outward, (ear.Upward * ear.Upward) + (ear.Forward * ear.Forward), problems);
        }

        for (int i = 0; i < (blueprint.Features?.Count ?? 0); i++)
        {
            FeatureBlueprint part = blueprint.Features![i];
            double others = (part.Upward * part.Upward) + (part.Forward * part.Forward) + (part.Sideward * part.Sideward);
            CheckDirection(PathOf("features", i, "outward"), part.Outward, others, problems);
        }
    }

    private static void CheckDirection(string path, double outward, double othersSquared, ProblemList problems)
    {
        if ((outward * outward) + othersSquared < LeastDirection * LeastDirection)
        {
            problems.Add(path, NumberText.Of(outward), "with the other components a direction at least " + NumberText.Of(LeastDirection) + " long");
        }
    }

    private static string PathOf(string list, int index, string field) => FormattableString.Invariant($"{list}[{index}].{field}");
}
