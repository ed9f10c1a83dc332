namespace CreatureGen.Motion;

/// <summary>How far a creature jumps from where it stands or runs, in the world, under the gravity that is set. All is 0 for what cannot jump.</summary>
/// <param name="Speed">At the take-off, m/s.</param>
/// <param name="Length">Over level ground straight ahead, metres from where it is as it is asked; a run counts as far as it carries.</param>
/// <param name="Height">Straight up, metres.</param>
public readonly record struct JumpReach(float Speed, float Length, float Height);

/// <summary>What came of asking for a jump.</summary>
public enum JumpResult
{
    /// <summary>It crouches, jumps and lands.</summary>
    Begun,

    /// <summary>The target is out of reach: farther or higher than its <see cref="JumpReach"/>, or so near that its run carries it past.</summary>
    OutOfReach,

    /// <summary>It is not on its feet: in the air, lying, getting up, or jumping already.</summary>
    NotOnFeet,

    /// <summary>It has no legs to stand on.</summary>
    NoLegs,

    /// <summary>Animals so heavy do not jump: above three tonnes.</summary>
    TooHeavy,
}
