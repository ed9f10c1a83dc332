using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;

namespace CreatureGen.Sampling.Placement;

/// <summary>A place for a pair of fins on the flanks.</summary>
/// <param name="Ring">Ring of its centre.</param>
/// <param name="Segment">Segment of its centre.</param>
/// <param name="Weight">How likely it is beside the other places.</param>
internal readonly record struct FinSite(int Ring, double Segment, double Weight);

/// <summary>The outline of a fin and how likely it is.</summary>
/// <param name="Style">Outline.</param>
/// <param name="Weight">Relative likelihood.</param>
internal readonly record struct FinChoice(FinStyle Style, double Weight);

/// <summary>The end of a tail and how likely it is.</summary>
/// <param name="Style">Outline.</param>
/// <param name="Weight">Relative likelihood.</param>
internal readonly record struct TailChoice(TailStyle Style, double Weight);

/// <summary>A whole number drawn from a range, both ends included.</summary>
/// <param name="Min">Smallest.</param>
/// <param name="Max">Largest.</param>
internal readonly record struct CountRange(int Min, int Max)
{
    /// <summary>Draws a number, all equally likely.</summary>
    public int Draw(Seeding.RandomStream stream) => stream.Integer(Min, Max + 1);
}

/// <summary>The fins that a swimming plan may have.</summary>
/// <param name="Dorsals">Number of fins on the back.</param>
/// <param name="Ventrals">Number of fins on the belly's midline.</param>
/// <param name="MidlineRows">Cells along the body of a fin on the midline, before its scale.</param>
/// <param name="FirstRing">First ring of the bones that may carry a fin on the midline.</param>
/// <param name="LastRing">Last ring of the bones that may carry a fin on the midline.</param>
/// <param name="Midline">Outlines of fins on the midline.</param>
/// <param name="Pectorals">Number of pairs of fins on the flanks.</param>
/// <param name="Flanks">Places of paired fins.</param>
/// <param name="Paired">Outlines of paired fins.</param>
/// <param name="Tails">Ends of the tail.</param>
internal sealed record FinAnatomy(
    CountRange Dorsals,
    CountRange Ventrals,
    CountRange MidlineRows,
    int FirstRing,
    int LastRing,
    IReadOnlyList<FinChoice> Midline,
    CountRange Pectorals,
    IReadOnlyList<FinSite> Flanks,
    IReadOnlyList<FinChoice> Paired,
    IReadOnlyList<TailChoice> Tails)
{
    private static readonly FinChoice[] midline = { new(FinStyle.Shark, 0.9), new(FinStyle.Spiny, 0.9), new(FinStyle.Sail, 0.6), new(FinStyle.Tuna, 0.7), new(FinStyle.Carp, 0.9), new(FinStyle.Veil, 0.6), new(FinStyle.Ray, 0.4) };
    private static readonly FinChoice[] paddle = { new(FinStyle.Paddle, 1) };
    private static readonly FinChoice[] flippers = { new(FinStyle.Paddle, 1), new(FinStyle.Shark, 0.6), new(FinStyle.Ray, 0.3) };
    private static readonly FinChoice[] fans = { new(FinStyle.Paddle, 0.7), new(FinStyle.Shark, 0.7), new(FinStyle.Tuna, 0.6), new(FinStyle.Carp, 1), new(FinStyle.Veil, 0.7), new(FinStyle.Ray, 0.35), new(FinStyle.Flying, 0.6) };

    /// <summary>One or two dorsal fins anywhere, perhaps one below; pectorals behind the head, often pelvic fins behind them; an upright tail.</summary>
    public static FinAnatomy Fish { get; } = new(
        new CountRange(1, 2),
        new CountRange(0, 1),
        new CountRange(6, 16),
        23,
        44,
        midline,
        new CountRange(1, 2),
        new[] { new FinSite(22, 10, 1), new FinSite(24, 10.5, 0.6), new FinSite(34, 12, 0.1) },
        fans,
        new[]
        {
            new TailChoice(TailStyle.Fork, 1), new TailChoice(TailStyle.Fan, 0.7), new TailChoice(TailStyle.Lance, 0.4), new TailChoice(TailStyle.Lunate, 0.8),
            new TailChoice(TailStyle.Heterocercal, 0.8), new TailChoice(TailStyle.Truncate, 0.7), new TailChoice(TailStyle.Veil, 0.7),
        });

    /// <summary>One long dorsal fin, small pectorals close behind the head, a plain or pointed tail.</summary>
    public static FinAnatomy Eel { get; } = new(
        new CountRange(1, 1),
        new CountRange(0, 0),
        new CountRange(20, 22),
        23,
        44,
        new[] { new FinChoice(FinStyle.Sail, 1), new FinChoice(FinStyle.Spiny, 1), new FinChoice(FinStyle.Ray, 1) },
        new CountRange(0, 1),
        new[] { new FinSite(20, 10, 1) },
        paddle,
        new[] { new TailChoice(TailStyle.Plain, 1), new TailChoice(TailStyle.Lance, 1) });

    /// <summary>A dorsal fin behind the shoulders or none, one pair of flippers, a fluke.</summary>
    public static FinAnatomy Whale { get; } = new(
        new CountRange(0, 1),
        new CountRange(0, 0),
        new CountRange(5, 14),
        29,
        42,
        new[] { new FinChoice(FinStyle.Shark, 0.8), new FinChoice(FinStyle.Tuna, 0.6), new FinChoice(FinStyle.Carp, 0.4), new FinChoice(FinStyle.Ray, 0.3) },
        new CountRange(1, 1),
        new[] { new FinSite(24, 10, 1) },
        flippers,
        new[] { new TailChoice(TailStyle.Fluke, 1) });

    /// <summary>Two pairs of flippers to row with, a plain tail.</summary>
    public static FinAnatomy Flipper { get; } = new(
        new CountRange(0, 0),
        new CountRange(0, 0),
        new CountRange(6, 10),
        23,
        44,
        midline,
        new CountRange(2, 2),
        new[] { new FinSite(25, 10, 1), new FinSite(41, 10, 1) },
        flippers,
        new[] { new TailChoice(TailStyle.Plain, 1) });

    /// <summary>The same with a fin on the back wherever the plan may have one.</summary>
    public FinAnatomy WithDorsal() => Dorsals.Max > 0 && Dorsals.Min == 0 ? this with { Dorsals = new CountRange(1, Dorsals.Max) } : this;

    /// <summary>The fins of a swimming plan.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The plan is not one of a swimmer.</exception>
    public static FinAnatomy Of(BodyPlan plan) => plan switch
    {
        BodyPlan.Fish => Fish,
        BodyPlan.Eel => Eel,
        BodyPlan.Whale => Whale,
        BodyPlan.Flipper => Flipper,
        _ => throw new ArgumentOutOfRangeException(nameof(plan), plan, "expected the plan of a swimmer"),
    };
}
