namespace CreatureGen.Motion.Toolkit.Ik;

/// <summary>How far the joint in the middle of a limb of two bones bends, where nothing else is known of it.</summary>
internal static class BendRange
{
    /// <summary>Bend that is always left, radians: 12°. Standing mammals keep their knees so far from straight, and nearer to it a solver's knee snaps.</summary>
    public const double Min = 0.2094;

    /// <summary>Deepest fold, radians: 150°, where flesh meets flesh.</summary>
    public const double Max = 2.618;

    /// <summary>Part of the greatest reach from which on it is eased: a knee near straight turns ever faster for the same way.</summary>
    public const double EaseFrom = 0.968;
}
