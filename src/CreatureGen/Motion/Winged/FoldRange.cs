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

    /// <summary>What corners of the leading edge cost, in relation to being off the body by a body length.</summary>
    public double CornerCost { get; init; } = 0.005;

    /// <summary>What it costs to reach out to the side.</summary>
    public double AsideCost { get; init; }

    /// <summary>What it costs to be low.</summary>
    public double LowCost { get; init; } = 10;

    /// <summary>By which part of what the others are shortened the upper arm is.</summary>
    public float UpperArm { get; init; } = 0.35f;

    /// <summary>Along the flank: the leading edge lies low, the trailing edge covers the side up to the back. A wing that is one skin cannot lay its forearm forward again as birds do: its surface would turn
    /// over at the elbow. It is drawn together instead.</summary>
    public static FoldRange Stitched { get; } = new(
        new WingFold(Drop: 0.45, Spread: 0.35, Rise: 0.05, Converge: 0.05, Curl: 0.05, Lift: 0.05, Lean: 0.25 - WingForm.RestIncidence, Wrap: 0.10, Length: 0.65),
        new WingFold(Drop: 0.00, Spread: -0.20, Rise: -0.30, Converge: -0.20, Curl: 0.00, Lift: 0.00, Lean: -WingForm.RestIncidence, Wrap: 0.00, Length: 0.46),
        new WingFold(Drop: 0.62, Spread: 0.65, Rise: 0.15, Converge: 0.45, Curl: 0.26, Lift: 0.18, Lean: 1.00 - WingForm.RestIncidence, Wrap: 0.60, Length: 1.00),
        1,
        0f,
        false,
        300,
        4000,
        0);

    /// <summary>As <see cref="Stitched"/>, of feathers that never fly: close to the flank, hardly above the back and not out to the side, for they are long and what carries them is low or narrow.</summary>
    public static FoldRange CarriedFeathers { get; } = Stitched with
    {
        Closeness = 4,
        ProudCost = 60,
        AsideCost = 200,
        LowCost = 30,
        CornerCost = 0.02,
    };

    /// <summary>Of skin that never flies: the arm comes down over the shoulder and is drawn together, each bone hangs with its blade straight back along the flank, as skin closes between fingers, and the hand points back.
    /// Laid back along the flank a blade would stand up behind its leading edge like a tent.</summary>
    public static FoldRange CarriedMembranes { get; } = Stitched with
    {
        Usual = new WingFold(Drop: 1.55, Spread: 0.40, Rise: -1.20, Converge: 0.10, Curl: 0.00, Lift: 0.30, Lean: 0.00, Wrap: -0.20, Length: 0.25) { Hangs = true },
        Min = new WingFold(Drop: 1.40, Spread: 0.00, Rise: -1.50, Converge: -0.20, Curl: -0.10, Lift: 0.15, Lean: -0.30, Wrap: -0.30, Length: 0.22),
        Max = new WingFold(Drop: 1.80, Spread: 1.10, Rise: -0.90, Converge: 0.70, Curl: 0.20, Lift: 0.70, Lean: 0.50, Wrap: 0.10, Length: 0.35),
        Closeness = 4,
        SunkCost = 3000,
        ProudCost = 120,
        AsideCost = 200,
        LowCost = 30,
        UpperArm = 0.6f,
    };

    /// <summary>As <see cref="Stitched"/>, of fliers whose wings are skin between fingers: it cannot slide together as feathers do, is deeper than the flank, and stood above the back like tents.</summary>
    public static FoldRange Hung { get; } = Stitched with
    {
        Min = Stitched.Min with { Rise = -1.3 },
        Max = Stitched.Max with { Drop = 1.3 },
        ProudCost = 60,
        Others = new[]
        {
            Stitched.Usual with { Drop = 0.8, Spread = 0.05, Rise = -0.3 },
            Stitched.Usual with { Drop = 0.5, Spread = 0.05, Rise = -0.5, Length = 0.5 },
            Stitched.Usual with { Drop = 0.8, Spread = 0.05, Rise = -0.8, Length = 0.6 },
        },
        Closeness = 4,
        CornerCost = 0.06,
        AsideCost = 100,
    };

    /// <summary>Over the abdomen, flat or as a low roof: tips no higher than the root.</summary>
    public static FoldRange Thin { get; } = new(
        new WingFold(Drop: 0.00, Spread: 0.28, Rise: -0.05, Converge: -0.28, Curl: 0.00, Lift: 0.00, Lean: 1.20, Wrap: 0.00, Length: 1.00),
        new WingFold(Drop: -0.15, Spread: 0.05, Rise: -0.20, Converge: -0.60, Curl: 0.00, Lift: 0.00, Lean: 1.05, Wrap: 0.00, Length: 1.00),
        new WingFold(Drop: 0.20, Spread: 0.60, Rise: 0.02, Converge: 0.00, Curl: 0.00, Lift: 0.00, Lean: 1.45, Wrap: 0.00, Length: 1.00),
        0.1,
        1f,
        true,
        150,
        24,
        0);

    /// <summary>Below wings that are folded over the abdomen.</summary>
    public static FoldRange ThinHind { get; } = new(
        new WingFold(Drop: 0.12, Spread: 0.28, Rise: -0.12, Converge: -0.28, Curl: 0.00, Lift: 0.00, Lean: 1.30, Wrap: 0.00, Length: 1.00),
        new WingFold(Drop: 0.05, Spread: 0.05, Rise: -0.30, Converge: -0.60, Curl: 0.00, Lift: 0.00, Lean: 1.20, Wrap: 0.00, Length: 1.00),
        new WingFold(Drop: 0.30, Spread: 0.60, Rise: -0.06, Converge: 0.00, Curl: 0.00, Lift: 0.00, Lean: 1.50, Wrap: 0.00, Length: 1.00),
        0.1,
        1f,
        true,
        150,
        24,
        0);
}
