namespace CreatureGen.Species;

/// <summary>How a species carries itself and goes, beyond what its plan says.</summary>
internal sealed record MotionTraits
{
    /// <summary>Degrees of the line from pelvis to shoulders above level that it takes up standing on two legs with wings.</summary>
    public double StandingPitch { get; init; } = 20;

    /// <summary>Whether it rolls from side to side on short legs under an upright body.</summary>
    public bool Waddles { get; init; }

    /// <summary>Whether its back and shoulder blades are as supple as a cat's.</summary>
    public bool IsSupple { get; init; }

    /// <summary>Whether it gets up with its hind legs first, on its wrists, as cattle and camels do; others get up with their fore legs first.</summary>
    public bool RisesHindFirst { get; init; }

    /// <summary>Whether its head bobs as it walks, where it is light.</summary>
    public bool BobsHead { get; init; }
}
