using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;

namespace CreatureGen.Repairs;

/// <summary>Makes parts fit together that do not, without building anything: afterwards the blueprint is valid.</summary>
internal static class PartRemedies
{
    /// <summary>Rings by which a socket is moved to find free cells, tried in this order.</summary>
    private static readonly int[] shifts = { 0, 1, -1, 2, -2, 3, -3, 4, -4, 6, -6, 8, -8 };

    /// <summary>Puts all parts in order.</summary>
    public static void Apply(RepairLog log)
    {
        log.Change(log.Blueprint, "the field allows no such value");
        FillHollows(log);
        FitFace(log);
        FitParts(log);
        DropTwins(log);
        PlaceSockets(log);
        FitPlan(log);
        Unfork(log);
    }

    private static void Unfork(RepairLog log)
    {
        var problems = new ProblemList("");
        ForkRules.Check(log.Blueprint, problems);
        if (problems.All.Count > 0)
        {
            log.Change(log.Blueprint with { Fork = null }, "limbs or parts of the head were in the way of a fork");
        }
    }

    private static void FillHollows(RepairLog log)
    {
        for (int round = 0; round < 20 && Complains(log.Blueprint, "head.bumps"); round++)
        {
            HeadBlueprint head = log.Blueprint.Head;
            ValueList<HeadBump> bumps = head.Bumps.Each(bump => bump.Amount < 0 ? bump with { Amount = 0.8 * bump.Amount } : bump);
            log.Change(log.Blueprint with { Head = head with { Bumps = bumps } }, "hollows turned the head inside out");
        }
    }

    private static void FitFace(RepairLog log)
    {
        HeadBlueprint head = log.Blueprint.Head;
        EyeBlueprint eyes = head.Eyes with
        {
            Ring = Clamp(head.Eyes.Ring, BlueprintRules.EyeRings),
            Segment = head.Eyes.IsSingle ? 0 : Clamp(head.Eyes.Segment, BlueprintRules.SideSegments),
        };
        log.Change(log.Blueprint with { Head = head with { Eyes = eyes } }, "eyes are on the head, two of them apart");
        head = log.Blueprint.Head;
        log.Change(log.Blueprint with { Head = head with { NostrilSize = Visible(head.NostrilSize), Mouth = head.Mouth with { Teeth = Visible(head.Mouth.Teeth) } } }, "it was too small to have an area");
        log.Change(log.Blueprint with { Head = log.Blueprint.Head with { Beak = head.Mouth.CornerRing == 0 ? null : head.Beak } }, "a beak is on a mouth that opens");
    }

    private static double Clamp(double value, NumberRange range) => Math.Min(range.Maximum, Math.Max(range.Minimum, value));

    private static double Visible(double size) => size < BlueprintRules.MinVisible ? 0 : size;

    private static void FitParts(RepairLog log)
    {
        CreatureBlueprint b = log.Blueprint;
        ShellBlueprint shell = b.Body.Shell;
        int rows = shell.Style == ShellStyle.None ? shell.Rows : Math.Max(2, Math.Min(shell.Rows, BodyGrid.Rings - 2 - shell.Ring));
        log.Change(b with { Body = b.Body with { Shell = shell with { Rows = rows } } }, "the shell went past the tail");
        b = log.Blueprint;
        log.Change(b with { Tail = b.Tail with { Size = b.Tail.Style == TailStyle.Plain ? b.Tail.Size : Math.Max(BlueprintRules.MinTailSize, b.Tail.Size) } }, "a tail of this style has a size");
        b = log.Blueprint;
        log.Change(b with { Fins = b.Fins.Each(fin => fin.Place == FinPlace.Pectoral ? fin with { Width = Math.Max(BlueprintRules.MinFinWidth, fin.Width) } : fin) }, "a paired fin has a width");
        b = log.Blueprint;
        log.Change(
            b with
            {
                Manes = b.Manes.Each(mane => mane with
                {
                    Ring = Math.Min(mane.Ring, mane.LastRing),
                    LastRing = Math.Max(mane.Ring, mane.LastRing),
                    Segment = Math.Min(mane.Segment, mane.LastSegment),
                    LastSegment = Math.Max(mane.Segment, mane.LastSegment),
                }),
            },
            "a field of hair ended before it began");
        b = log.Blueprint;
        log.Change(b with { Features = b.Features.Each(part => BlueprintRules.IsDoubled(part) ? part with { Segment = Clamp(part.Segment, BlueprintRules.SideSegments) } : part) }, "the two of a pair stood in one another");
        b = log.Blueprint;
        log.Change(
            b with
            {
                Ears = b.Ears.Each(ear => BlueprintRules.PointsSomewhere(ear) ? ear : ear with { Upward = 1 }),
                Features = b.Features.Each(part => BlueprintRules.PointsSomewhere(part) ? part : part with { Outward = 1 }),
            },
            "it pointed nowhere");
    }

    private static void DropTwins(RepairLog log)
    {
        CreatureBlueprint b = log.Blueprint;
        log.Change(
            b with { InsectWings = Distinct(b.InsectWings, wing => wing), Features = Distinct(b.Features, BlueprintRules.SolidOf), Manes = Distinct(b.Manes, mane => mane), Frills = Distinct(b.Frills, frill => frill) },
            "equal parts lay in one another");
    }

    /// <summary>Keeps sockets where they are, moves them along the body, or drops what has no room; what the plan moves by comes first.</summary>
    private static void PlaceSockets(RepairLog log)
    {
        CreatureBlueprint b = log.Blueprint;
        CreatureBlueprint placed = b with
        {
            Legs = ValueList<LegBlueprint>.Empty,
            Wings = ValueList<WingBlueprint>.Empty,
            Fins = ValueList<FinBlueprint>.Empty,
            Ears = ValueList<EarBlueprint>.Empty,
        };
        placed = Place(placed, b.Wings, wing => wing.Socket, (wing, socket) => wing with { Socket = socket }, (c, list) => c with { Wings = list });
        placed = Place(placed, b.Legs, leg => leg.Socket, (leg, socket) => leg with { Socket = socket }, (c, list) => c with { Legs = list });
        placed = Place(placed, b.Fins, fin => OnMidline(fin), (fin, socket) => fin with { Socket = socket }, (c, list) => c with { Fins = list });
        placed = Place(placed, b.Ears, ear => ear.Socket, (ear, socket) => ear with { Socket = socket }, (c, list) => c with { Ears = list });
        log.Change(placed, "its cells were taken or off the side of the body");
    }

    private static CreatureBlueprint Place<T>(
        CreatureBlueprint placed,
        ValueList<T> items,
        Func<T, SocketBlueprint> socketOf,
        Func<T, SocketBlueprint, T> moved,
        Func<CreatureBlueprint, ValueList<T>, CreatureBlueprint> with)
        where T : IEquatable<T>
    {
        var kept = new List<T>();
        foreach (T item in items)
        {
            foreach (int shift in shifts)
            {
                SocketBlueprint socket = socketOf(item);
                T candidate = moved(item, socket with { Ring = socket.Ring + shift, Segment = Math.Min(socket.Segment, Math.Max(0, (BodyGrid.Segments / 2) - socket.Columns)) });
                if (socket.Columns == SocketRules.MidlineColumns && socket.Segment is SocketRules.DorsalSegment or SocketRules.VentralSegment)
                {
                    candidate = moved(item, socket with { Ring = socket.Ring + shift });
                }

                kept.Add(candidate);
                if (FieldChecker.Accepts(socketOf(candidate), LimbFields.Socket) && Fits(with(placed, new ValueList<T>(kept))))
                {
                    break;
                }

                kept.RemoveAt(kept.Count - 1);
            }
        }

        return with(placed, new ValueList<T>(kept));
    }

    private static SocketBlueprint OnMidline(FinBlueprint fin) => fin.Place switch
    {
        FinPlace.Dorsal => fin.Socket with { Segment = SocketRules.DorsalSegment, Columns = SocketRules.MidlineColumns },
        FinPlace.Ventral => fin.Socket with { Segment = SocketRules.VentralSegment, Columns = SocketRules.MidlineColumns },
        _ => fin.Socket,
    };

    private static bool Fits(CreatureBlueprint candidate)
    {
        var problems = new ProblemList("");
        SocketRules.Check(candidate, problems);
        return problems.All.Count == 0;
    }

    /// <summary>A plan whose limbs are not there becomes the nearest one that moves by what there is.</summary>
    private static void FitPlan(RepairLog log)
    {
        CreatureBlueprint b = log.Blueprint;
        PlanNeeds needs = PlanNeeds.Of(b);
        BodyPlan plan = needs.Have >= needs.Need ? b.Plan : PlanFor(b);
        LocomotionKind kind = BlueprintRules.KindOf(plan) ?? b.Kind;
        log.Change(b with { Plan = plan, Kind = kind }, needs.Have >= needs.Need ? "the plan belongs to this kind" : "the plan had not the limbs it moves by");
    }

    private static BodyPlan PlanFor(CreatureBlueprint b) => b.Kind switch
    {
        LocomotionKind.Flying when b.Wings.Count > 0 => BodyPlan.Flapping,
        LocomotionKind.Flying when b.InsectWings.Count > 0 => BodyPlan.Buzzing,
        LocomotionKind.Swimming => PlanNeeds.PairedFins(b) switch { 0 => BodyPlan.Eel, _ => BodyPlan.Fish },
        _ => LegsOnTheGround(b) switch { 0 => BodyPlan.Legless, 1 => BodyPlan.Theropod, 2 => BodyPlan.Sprawling, _ => BodyPlan.Hexapod },
    };

    private static int LegsOnTheGround(CreatureBlueprint b)
    {
        int pairs = 0;
        foreach (LegBlueprint leg in b.Legs)
        {
            pairs += leg.Stance == LegStance.Standing ? 1 : 0;
        }

        return pairs;
    }

    private static bool Complains(CreatureBlueprint blueprint, string path)
    {
        foreach (Problem problem in BlueprintValidator.Validate(blueprint))
        {
            if (problem.Path == path)
            {
                return true;
            }
        }

        return false;
    }

    private static ValueList<T> Distinct<T>(ValueList<T> items, Func<T, T> solidOf)
        where T : IEquatable<T>
    {
        var kept = new List<T>();
        foreach (T item in items)
        {
            if (!kept.Exists(other => solidOf(other).Equals(solidOf(item))))
            {
                kept.Add(item);
            }
        }

        return kept.Count == items.Count ? items : new ValueList<T>(kept);
    }
}
