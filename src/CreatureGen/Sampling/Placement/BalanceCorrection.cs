namespace CreatureGen.Sampling.Placement;

/// <summary>What a creature needs to stand without falling over, the mildest remedy first.</summary>
internal enum BalanceRemedy
{
    /// <summary>Nothing.</summary>
    None,

    /// <summary>The feet are set forward or back.</summary>
    ShiftFeet,

    /// <summary>The torso is pitched about the hips as well.</summary>
    PitchTorso,

    /// <summary>The feet are larger as well.</summary>
    GrowFeet,

    /// <summary>None of these is enough: the plan must gain a pair of legs or a counterweight (a longer tail, a smaller head).</summary>
    AddPairOrTail,
}

/// <summary>How a creature is brought into balance.</summary>
/// <param name="Remedy">The mildest remedy that does it.</param>
/// <param name="Shift">How far all feet are set forward, metres.</param>
/// <param name="Pitch">How far the torso is pitched up about the hips, radians.</param>
/// <param name="FootGrowth">Factor on the feet.</param>
/// <param name="Margin">The margin of balance with all this.</param>
/// <param name="Overhang">How far the centre of mass still lies before (positive) or behind where it ought to be, metres; 0 unless a pair or a tail is missing.</param>
internal sealed record BalanceCorrection(BalanceRemedy Remedy, double Shift, double Pitch, double FootGrowth, double Margin, double Overhang);

/// <summary>How far a creature may be corrected.</summary>
/// <param name="RearmostShift">How far the feet may be set back, metres, not positive.</param>
/// <param name="ForemostShift">How far the feet may be set forward, metres, not negative.</param>
/// <param name="Pivot">The hips that the torso is pitched about.</param>
/// <param name="MaximumPitch">How far it may be pitched either way, radians.</param>
/// <param name="MaximumFootGrowth">Largest factor on the feet, at least 1.</param>
internal readonly record struct BalanceLimits(double RearmostShift, double ForemostShift, SagittalPoint Pivot, double MaximumPitch, double MaximumFootGrowth)
{
    /// <summary>By which part of the hull's width the centre of mass must lie inside it.</summary>
    public double MinMargin { get; init; } = Balance.MinMargin;
}
