namespace CreatureGen.Anatomy.Legs;

/// <summary>How a leg steps; lengths in leg lengths.</summary>
/// <param name="Linkage">How its bones share the work.</param>
internal sealed record LegStep(LegLinkage Linkage)
{
    /// <summary>Height of the ball in the swing.</summary>
    public double Lift { get; init; }

    /// <summary>Part of the swing at which it is highest.</summary>
    public double Peak { get; init; }

    /// <summary>How far the metatarsus folds back early in the swing.</summary>
    public double FoldDegrees { get; init; }

    /// <summary>How far it reaches ahead late in the swing (negative).</summary>
    public double UnfoldDegrees { get; init; }

    /// <summary>Pitch of the foot, toes down, as it leaves the ground.</summary>
    public double ToeOffDegrees { get; init; }

    /// <summary>Greatest pitch in the swing.</summary>
    public double SwingPitchDegrees { get; init; }

    /// <summary>Pitch as it comes down; negative is heel first.</summary>
    public double StrikeDegrees { get; init; }

    /// <summary>Side to which the knee bends about the left axis: 1 knee, −1 elbow, 0 as it is built (legs out to the side).</summary>
    public int Bend { get; init; }

    /// <summary>How far the leg is drawn in towards the middle at most, part of the height of its hip: as far as its foot gives way to a side.</summary>
    public float MaxAdduction { get; init; } = 0.13f;

    /// <summary>Whether the pair throws the body ahead: hind legs of grasshoppers and frogs.</summary>
    public bool Leaps { get; init; }

    /// <summary>Whether its knee points ahead and lies beside the fore foot where the leg is folded: hind legs of frogs.</summary>
    public bool KneesAhead { get; init; }

    /// <summary>Part of the trunk's height that is under water as the body floats: less of those that the surface carries, or that have feathers under them.</summary>
    public float Immersion { get; init; } = 0.78f;

    /// <summary>How far trunk and tail wave as it swims, radians from end to end; of those that row with legs it is the tail alone.</summary>
    public float Undulation { get; init; } = 0.2f;

    /// <summary>How far the heel of a hind foot rises that rests on its tip while the body stands, radians: 38° of horses, cattle and deer, half as much of dogs and cats; none of those that stand on their soles.</summary>
    public float RestPitch { get; init; }
}
