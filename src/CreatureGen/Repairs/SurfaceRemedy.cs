using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;

namespace CreatureGen.Repairs;

/// <summary>Cures what a shape too extreme does to the surface: finds by trial which parts do it and drops them, else takes the shape back towards plain ones.</summary>
internal static class SurfaceRemedy
{
    /// <summary>Rounds in which parts are tried; what is broken after them is the body itself.</summary>
    private const int PartRounds = 3;

    /// <summary>Creatures smaller than this lose digits of their positions to rounding.</summary>
    private const double SmallScale = 0.4;

    private static readonly (string Name, Func<CreatureBlueprint, int> Count, Func<CreatureBlueprint, int, CreatureBlueprint> Without)[] lists =
    {
        ("forks", b => b.Fork == null ? 0 : 1, (b, _) => b with { Fork = null }),
        ("features", b => b.Features.Count, (b, i) => b with { Features = Without(b.Features, i) }),
        ("manes", b => b.Manes.Count, (b, i) => b with { Manes = Without(b.Manes, i) }),
        ("frills", b => b.Frills.Count, (b, i) => b with { Frills = Without(b.Frills, i) }),
        ("insectWings", b => b.InsectWings.Count, (b, i) => b with { InsectWings = Without(b.InsectWings, i) }),
        ("ears", b => b.Ears.Count, (b, i) => b with { Ears = Without(b.Ears, i) }),
        ("fins", b => b.Fins.Count, (b, i) => b with { Fins = Without(b.Fins, i) }),
        ("wings", b => b.Wings.Count, (b, i) => b with { Wings = Without(b.Wings, i) }),
        ("teeth", b => b.Head.Mouth.Teeth > 0 ? 1 : 0, (b, _) => b with { Head = b.Head with { Mouth = b.Head.Mouth with { Teeth = 0 } } }),
        ("nostrils", b => b.Head.NostrilSize > 0 ? 1 : 0, (b, _) => b with { Head = b.Head with { NostrilSize = 0 } }),
        ("tongues", b => b.Head.Mouth.Tongue != TongueStyle.None ? 1 : 0, (b, _) => b with { Head = b.Head with { Mouth = b.Head.Mouth with { Tongue = TongueStyle.None } } }),
        ("beaks", b => b.Head.Beak != null ? 1 : 0, (b, _) => b with { Head = b.Head with { Beak = null } }),
        ("claws", b => CountClaws(b.Legs), (b, i) => b with { Legs = WithoutClaws(b.Legs, i) }),
        ("shells", b => b.Body.Shell.Style != ShellStyle.None ? 1 : 0, (b, _) => b with { Body = b.Body with { Shell = b.Body.Shell with { Style = ShellStyle.None } } }),
        ("legs", b => b.Legs.Count, (b, i) => b with { Legs = Without(b.Legs, i) }),
        ("tail ends", b => b.Tail.Style != TailStyle.Plain ? 1 : 0, (b, _) => b with { Tail = b.Tail with { Style = TailStyle.Plain } }),
    };

    /// <summary>Changes the blueprint. False if nothing is left to try.</summary>
    public static bool Apply(RepairLog log, InvariantViolation violation, int round)
    {
        CreatureBlueprint b = log.Blueprint;
        if (violation.Invariant == CreatureInspection.Joints && b.Legs.Count > 0)
        {
            return log.Change(b with { Legs = Without(b.Legs, b.Legs.Count / 2) }, "its skeleton had too many joints");
        }

        if (round < PartRounds && DropCulprit(log, violation))
        {
            return true;
        }

        return (b.Scale < SmallScale && log.Change(b with { Scale = 1.5 * b.Scale }, "at this size rounding closed up what is smallest")) || PlainRemedy.Apply(log, violation);
    }

    /// <summary>Drops the first parts without which the violation is gone.</summary>
    private static bool DropCulprit(RepairLog log, InvariantViolation violation)
    {
        foreach ((string name, Func<CreatureBlueprint, int> count, Func<CreatureBlueprint, int, CreatureBlueprint> without) in lists)
        {
            CreatureBlueprint trial = Emptied(log.Blueprint, count, without);
            if (count(log.Blueprint) == 0 || Breaks(trial, violation))
            {
                continue;
            }

            // One of these: put them back one by one and leave out those that break it.
            CreatureBlueprint kept = log.Blueprint;
            for (int i = count(kept) - 1; i >= 0 && Breaks(kept, violation); i--)
            {
                CreatureBlueprint less = without(kept, i);
                kept = count(kept) == 1 || !Breaks(less, violation) || AloneBreaks(kept, count, without, i, violation) ? less : kept;
            }

            kept = Breaks(kept, violation) ? trial : kept;
            return log.Change(kept, "parts of " + name + " tore the surface (" + violation.Invariant + ")");
        }

        return DropLists(log, violation);
    }

    /// <summary>Drops several lists that break it each by itself: all of them, but for those that may come back.</summary>
    private static bool DropLists(RepairLog log, InvariantViolation violation)
    {
        var dropped = new List<int>();
        for (int list = 0; list < lists.Length; list++)
        {
            CreatureBlueprint trial = Emptied(log.Blueprint, lists[list].Count, lists[list].Without);
            if (!trial.Equals(log.Blueprint) && BlueprintValidator.Validate(trial).Count == 0)
            {
                dropped.Add(list);
            }
        }

        if (dropped.Count < 2 || Breaks(WithoutLists(log.Blueprint, dropped), violation))
        {
            return false;
        }

        foreach (int list in dropped.ToArray())
        {
            dropped.Remove(list);
            if (Breaks(WithoutLists(log.Blueprint, dropped), violation))
            {
                dropped.Add(list);
            }
        }

        string names = string.Join(", ", dropped.ConvertAll(list => lists[list].Name));
        return log.Change(WithoutLists(log.Blueprint, dropped), names + " tore the surface together (" + violation.Invariant + ")");
    }

    private static CreatureBlueprint WithoutLists(CreatureBlueprint blueprint, List<int> dropped)
    {
        foreach (int list in dropped)
        {
            blueprint = Emptied(blueprint, lists[list].Count, lists[list].Without);
        }

        return blueprint;
    }

    private static CreatureBlueprint Emptied(CreatureBlueprint blueprint, Func<CreatureBlueprint, int> count, Func<CreatureBlueprint, int, CreatureBlueprint> without)
    {
        while (count(blueprint) > 0)
        {
            blueprint = without(blueprint, count(blueprint) - 1);
        }

        return blueprint;
    }

    /// <summary>Whether one part breaks the creature without the others of its list.</summary>
    private static bool AloneBreaks(CreatureBlueprint blueprint, Func<CreatureBlueprint, int> count, Func<CreatureBlueprint, int, CreatureBlueprint> without, int part, InvariantViolation violation)
    {
        CreatureBlueprint alone = blueprint;
        for (int i = count(alone) - 1; i >= 0; i--)
        {
            alone = i == part ? alone : without(alone, i);
        }

        return Breaks(alone, violation);
    }

    private static bool Breaks(CreatureBlueprint blueprint, InvariantViolation violation)
    {
        if (BlueprintValidator.Validate(blueprint).Count > 0)
        {
            return true;
        }

        foreach (InvariantViolation found in CreatureInspection.Inspect(CreatureAssembler.Assemble(blueprint)))
        {
            if (found.Invariant == violation.Invariant)
            {
                return true;
            }
        }

        return false;
    }

    private static int CountClaws(ValueList<LegBlueprint> legs)
    {
        int count = 0;
        foreach (LegBlueprint leg in legs)
        {
            count += leg.ClawLength > 0 ? 1 : 0;
        }

        return count;
    }

    private static ValueList<LegBlueprint> WithoutClaws(ValueList<LegBlueprint> legs, int clawed)
    {
        for (int i = 0; i < legs.Count; i++)
        {
            if (legs[i].ClawLength > 0 && clawed-- == 0)
            {
                return legs.With(i, legs[i] with { ClawLength = 0 });
            }
        }

        return legs;
    }

    private static ValueList<T> Without<T>(ValueList<T> items, int index)
        where T : IEquatable<T>
    {
        var kept = new List<T>(items);
        kept.RemoveAt(index);
        return new ValueList<T>(kept);
    }
}
