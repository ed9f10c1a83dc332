using System;
using CreatureGen.Anatomy.Wings;

namespace CreatureGen.Motion.Winged;

/// <summary>The ways of folding that a kind of wing has: where the search for the one that fits a body begins, and its bounds.</summary>
/// <param name="Usual">Where it begins.</param>
/// <param name="Min">Lower bounds.</param>
/// <param name="Max">Upper bounds.</param>
/// <param name="Closeness">How much it matters that it lies on the body: thin wings lie flat above it.</param>
/// <param name="Trailing">Where it is to end: 0 where the tail begins, 1 where it ends.</param>
/// <param name="AboveLegs">Whether no leg is to be above it.</param>
/// <param name="SunkCost">What it costs to be in the body, in relation to being off it.</param>
/// <param name="MiddleCost">What it costs to be over the midline: thin wings are laid over one another there, stitched ones would cut through one another.</param>
/// <param name="ProudCost">What it costs to stand above the back.</param>
internal sealed record FoldRange(WingFold Usual, WingFold Min, WingFold Max, double Closeness, float Trailing, bool AboveLegs, double SunkCost, double MiddleCost, double ProudCost)
{
    /// <summary>Where further searches begin.</summary>
    public WingFold[] Others { get; init; } = Array.Empty<WingFold>();

    /// <summary>Along the flank: the leading edge lies low, the trailing edge covers the side up to the back. A wing that is one skin cannot lay its forearm forward again as birds do: its surface would turn
    /// over at the elbow. It is drawn together instead.</summary>
    public static FoldRange Stitched { get; } = new(
        new WingFold(0.45, 0.35, 0.05, 0.05, 0.05, 0.05, 0.25 - WingForm.RestIncidence, 0.10, 0.65),
        new WingFold(0.00, -0.20, -0.30, -0.20, 0.00, 0.00, -WingForm.RestIncidence, 0.00, 0.48),
        new WingFold(0.62, 0.65, 0.15, 0.45, 0.18, 0.18, 1.00 - WingForm.RestIncidence, 0.60, 1.00),
        1,
        0f,
        false,
        300,
        4000,
        0);

    /// <summary>The same of what never flies: a blade that is broader than the flank hangs down from the shoulder, its depth along the body, rather than stand above the back like a sail.</summary>
    public static FoldRange Carried { get; } = Stitched with
    {
        Others = new[]
        {
            Stitched.Usual with { Drop = 0.8, Spread = 0.05, Rise = -0.3 },
            Stitched.Usual with { Drop = 0.8, Spread = 0.05, Rise = -0.8, Length = 0.6 },
        },
        Min = Stitched.Min with { Rise = -1.3 },
        Max = Stitched.Max with { Drop = 1.3 },
        Closeness = 2,
        ProudCost = 60,
    };

    /// <summary>Over the abdomen, flat or as a low roof: tips no higher than the root.</summary>
    public static FoldRange Thin { get; } = new(
        new WingFold(0.00, 0.28, -0.05, -0.28, 0.00, 0.00, 1.20, 0.00, 1.00),
        new WingFold(-0.15, 0.05, -0.20, -0.60, 0.00, 0.00, 1.05, 0.00, 1.00),
        new WingFold(0.20, 0.60, 0.02, 0.00, 0.00, 0.00, 1.45, 0.00, 1.00),
        0.1,
        1f,
        true,
        150,
        24,
        0);

    /// <summary>Below wings that are folded over the abdomen.</summary>
    public static FoldRange ThinHind { get; } = new(
        new WingFold(0.12, 0.28, -0.12, -0.28, 0.00, 0.00, 1.30, 0.00, 1.00),
        new WingFold(0.05, 0.05, -0.30, -0.60, 0.00, 0.00, 1.20, 0.00, 1.00),
        new WingFold(0.30, 0.60, -0.06, 0.00, 0.00, 0.00, 1.50, 0.00, 1.00),
        0.1,
        1f,
        true,
        150,
        24,
        0);
}
