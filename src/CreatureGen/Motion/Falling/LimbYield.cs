namespace CreatureGen.Motion.Falling;

/// <summary>How a limb gives way to ground that it is in, as data.</summary>
/// <param name="Rounds">How often it is looked at at most.</param>
/// <param name="Part">What of its depth it gives way to in a round, 0..1.</param>
/// <param name="Knee">How much less readily than its hip its knee does.</param>
/// <param name="Ankle">And its ankle.</param>
internal readonly record struct LimbYield(int Rounds, float Part, float Knee, float Ankle)
{
    /// <summary>Of a leg out to the side, an arm or a wing: with all its joints, until it is out.</summary>
    public static LimbYield Free { get; } = new(12, 1f, 1f, 1f);

    /// <summary>Of a leg under the body: a knee that stretches for it as readily would not fold, and one that is pressed between body and ground would go to and fro: it is the body that heaves itself up then.</summary>
    public static LimbYield Under { get; } = new(12, 0.5f, 0.35f, 1f);

    /// <summary>How readily a joint does, 0..1.</summary>
    /// <param name="joint">0 the hip, 1 the knee, 2 the ankle; on an arm or a wing what is as far out.</param>
    public float Of(int joint) => joint == 0 ? 1f : joint == 1 ? Knee : Ankle;
}
