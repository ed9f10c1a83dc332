using System;
using CreatureGen.Anatomy;
using CreatureGen.Json;
using CreatureGen.Maths;

namespace CreatureGen.Blueprints;

/// <summary>Checks what the range of no single field can say: parts that have to fit together. Parts that are out of range themselves are passed over.</summary>
internal static class BlueprintRules
{
    /// <summary>Least length of a direction; a shorter one points nowhere reliably.</summary>
    private const double MinDirection = 0.1;

    /// <summary>Least part of a section's size that hollows have to leave, so that the head does not turn inside out.</summary>
    private const double MinSection = 0.1;

    /// <summary>Least size of a tail that is not plain, metres.</summary>
    public const double MinTailSize = 0.01;

    /// <summary>Least width of a pectoral fin.</summary>
    public const double MinFinWidth = 0.05;

    /// <summary>Least size of teeth and nostrils that are there at all; smaller ones have no area.</summary>
    public const double MinVisible = 0.01;

    /// <summary>Where eyes may be along the head.</summary>
    public static readonly NumberRange EyeRings = new(0, 20);

    /// <summary>Where the left one of a pair may be around the body: off the midline. A single eye is on it, at segment 0.</summary>
    public static readonly NumberRange SideSegments = new(0.5, (BodyGrid.Segments / 2) - 0.5);

    /// <summary>Lists what does not fit together.</summary>
    public static void Check(CreatureBlueprint blueprint, ProblemList problems)
    {
        CheckPlan(blueprint, problems);
        CheckMovers(blueprint, problems);
        CheckTwins("insectWings", blueprint.InsectWings, wing => wing, problems);
        CheckTwins("features", blueprint.Features, SolidOf, problems);
        CheckPairs(blueprint.Features, problems);
        CheckTwins("manes", blueprint.Manes, mane => mane, problems);
        CheckTwins("frills", blueprint.Frills, frill => frill, problems);
        CheckFace(blueprint.Head, problems);
        CheckHollows(blueprint.Head?.Bumps, problems);
        CheckShell(blueprint.Body?.Shell, problems);
        CheckTail(blueprint.Tail, problems);
        CheckFins(blueprint.Fins, problems);
        CheckDirections(blueprint, problems);
        CheckManes(blueprint.Manes, problems);
        SocketRules.Check(blueprint, problems);
        ForkRules.Check(blueprint, problems);
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
    }

    private static void CheckMovers(CreatureBlueprint blueprint, ProblemList problems)
    {
        if (blueprint.Legs is null || blueprint.Wings is null || blueprint.InsectWings is null || blueprint.Fins is null)
        {
            return;
        }

        PlanNeeds needs = PlanNeeds.Of(blueprint);
        if (needs.Have < needs.Need)
        {
            string plan = AnatomyChoices.Plan.NameOf(blueprint.Plan) ?? FieldChecker.Undefined;
            problems.Add(needs.List, FormattableString.Invariant($"{needs.Have} {needs.What}"), FormattableString.Invariant($"at least {needs.Need} for the plan {plan}"));
        }
    }

    /// <summary>Solid parts that are equal lie in one another, face on face: their surfaces are none.</summary>
    private static void CheckTwins<T>(string list, ValueList<T>? items, Func<T, T> solidOf, ProblemList problems)
        where T : IEquatable<T>
    {
        for (int i = 1; i < (items?.Count ?? 0); i++)
        {
            for (int k = 0; k < i; k++)
            {
                if (solidOf(items![i]).Equals(solidOf(items[k])))
                {
                    problems.Add(FormattableString.Invariant($"{list}[{i}]"), FormattableString.Invariant($"the same as {list}[{k}]"), "a part that differs from all others");
                    break;
                }
            }
        }
    }

    /// <summary>What a small part builds, without what makes no difference to its surface: its kind, and on the midline what leans to a side. Two parts that are equal in this are one in the other.</summary>
    public static FeatureBlueprint SolidOf(FeatureBlueprint part)
    {
        bool midline = IsOnMidline(part);
        return part with { Kind = FeatureKind.Spike, Sideward = midline ? 0 : part.Sideward, BendSide = midline ? 0 : part.BendSide };
    }

    /// <summary>Whether a part has joints of its own on either side, so that on the midline its two halves would be one in the other.</summary>
    public static bool IsDoubled(FeatureBlueprint part) => part.Kind is FeatureKind.Antenna or FeatureKind.Tail && IsOnMidline(part);

    private static bool IsOnMidline(FeatureBlueprint part) => part.Segment is 0 or BodyGrid.Segments / 2;

    private static void CheckPairs(ValueList<FeatureBlueprint>? features, ProblemList problems)
    {
        for (int i = 0; i < (features?.Count ?? 0); i++)
        {
            FeatureBlueprint part = features![i];
            if (IsDoubled(part))
            {
                problems.Add(PathOf("features", i, "segment"), NumberText.Of(part.Segment), "off the midline, since parts of kind " + AnatomyChoices.Feature.NameOf(part.Kind) + " are pairs");
            }
        }
    }

    private static void CheckFace(HeadBlueprint? head, ProblemList problems)
    {
        if (FieldChecker.Accepts(head?.Eyes, HeadFields.Eyes))
        {
            Require("head.eyes.ring", head!.Eyes.Ring, EyeRings, " on the head", problems);
            if (!head.Eyes.IsSingle)
            {
                Require("head.eyes.segment", head.Eyes.Segment, SideSegments, " for two eyes, or 0 for a single one", problems);
            }
        }

        RequireVisible("head.nostrilSize", head?.NostrilSize, problems);
        RequireVisible("head.mouth.teeth", head?.Mouth?.Teeth, problems);
        if (head?.Beak != null && head.Mouth?.CornerRing == 0)
        {
            problems.Add("head.beak", "a beak", "none on a head without a mouth slit (mouth.cornerRing 0)");
        }
    }

    private static void Require(string path, double value, NumberRange range, string reason, ProblemList problems)
    {
        if (!range.Contains(value))
        {
            problems.Add(path, NumberText.Of(value), range + reason);
        }
    }

    private static void RequireVisible(string path, double? size, ProblemList problems)
    {
        if (size > 0 && size < MinVisible)
        {
            problems.Add(path, NumberText.Of(size.Value), "0 for none, or at least " + NumberText.Of(MinVisible));
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

        if (depth <= 1 - MinSection)
        {
            return;
        }

        double min = ThinnestSection(bumps!, out int ring, out int segment);
        if (min < MinSection)
        {
            string size = NumberText.Of(min);
            problems.Add("head.bumps", FormattableString.Invariant($"{size} of the section's size at ring {ring}, segment {segment}"), "at least " + NumberText.Of(MinSection));
        }
    }

    /// <summary>The least factor that the bumps put on a section.</summary>
    private static double ThinnestSection(ValueList<HeadBump> bumps, out int ringOfMin, out int segmentOfMin)
    {
        double min = double.MaxValue;
        ringOfMin = 0;
        segmentOfMin = 0;
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

                if (factor < min)
                {
                    min = factor;
                    ringOfMin = ring;
                    segmentOfMin = segment;
                }
            }
        }

        return min;
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
        if (FieldChecker.Accepts(tail, LimbFields.Tail) && tail!.Style != TailStyle.Plain && tail.Size < MinTailSize)
        {
            problems.Add("tail.size", NumberText.Of(tail.Size), "at least " + NumberText.Of(MinTailSize) + " for a tail that is not plain");
        }
    }

    private static void CheckFins(ValueList<FinBlueprint>? fins, ProblemList problems)
    {
        for (int i = 0; i < (fins?.Count ?? 0); i++)
        {
            FinBlueprint fin = fins![i];
            if (fin.Place == FinPlace.Pectoral && fin.Width >= 0 && fin.Width < MinFinWidth)
            {
                problems.Add(PathOf("fins", i, "width"), NumberText.Of(fin.Width), "at least " + NumberText.Of(MinFinWidth) + " for a pectoral fin");
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
            CheckDirection(PointsSomewhere(ear), PathOf("ears", i, "outward"), ear.Outward, problems);
        }

        for (int i = 0; i < (blueprint.Features?.Count ?? 0); i++)
        {
            FeatureBlueprint part = blueprint.Features![i];
            CheckDirection(PointsSomewhere(part), PathOf("features", i, "outward"), part.Outward, problems);
        }
    }

    /// <summary>Whether an ear has a direction.</summary>
    public static bool PointsSomewhere(EarBlueprint ear) =>
        IsLong((ear.Outward * ear.Outward) + (ear.Upward * ear.Upward) + (ear.Forward * ear.Forward));

    /// <summary>Whether a small part has a direction.</summary>
    public static bool PointsSomewhere(FeatureBlueprint part) =>
        IsLong((part.Outward * part.Outward) + (part.Upward * part.Upward) + (part.Forward * part.Forward) + (part.Sideward * part.Sideward));

    private static bool IsLong(double squared) => !(squared < MinDirection * MinDirection);

    private static void CheckDirection(bool points, string path, double outward, ProblemList problems)
    {
        if (!points)
        {
            problems.Add(path, NumberText.Of(outward), "with the other components a direction at least " + NumberText.Of(MinDirection) + " long");
        }
    }

    private static string PathOf(string list, int index, string field) => FormattableString.Invariant($"{list}[{index}].{field}");
}
