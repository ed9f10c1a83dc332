using System.Numerics;

namespace CreatureGen.Motion;

/// <summary>What happened.</summary>
public enum MotionEventKind
{
    /// <summary>A foot came down.</summary>
    FootDown,

    /// <summary>A foot left the ground.</summary>
    FootUp,

    /// <summary>Wings began to beat down.</summary>
    WingBeat,

    /// <summary>The ground was lost: it falls.</summary>
    Fell,

    /// <summary>A fall came to the ground.</summary>
    Landed,

    /// <summary>It took off for a jump.</summary>
    Jumped,

    /// <summary>It was hit.</summary>
    Struck,

    /// <summary>It went limp.</summary>
    WentLimp,

    /// <summary>It began to get up.</summary>
    Rises,

    /// <summary>It is up again.</summary>
    Rose,

    /// <summary>It came into water too deep for its legs, and swims.</summary>
    EnteredWater,

    /// <summary>It has ground under its feet again, or flies up from the water.</summary>
    LeftWater,
}

/// <summary>Something that happened in an update: for sounds, dust and prints. Each happens in exactly one update.</summary>
/// <param name="Kind">What.</param>
/// <param name="Foot">Index of the foot, in the order of the animator's feet; −1 for what the whole body does.</param>
/// <param name="Joint">Skeleton index of the ball of that foot; of the left shoulder for wings; of the joint that carries the body for what it does as a whole.</param>
/// <param name="Position">On the ground under the ball, world space, metres; else the creature's root.</param>
/// <param name="Normal">Of the ground, unit, world space; else the creature's own up.</param>
/// <param name="Surface">What the ground is made of; 0 for what does not touch it.</param>
/// <param name="Speed">Metres per second of the body over the ground; for a landing, on ground or water, that with which it came down.</param>
/// <param name="Strength">Greatest force of the step or landing to be expected, in weights of the body; for wings the width of the beat, 1 at cruise; 0 for what has none.</param>
/// <param name="SecondsAgo">How long before the end of the update it happened.</param>
public readonly record struct MotionEvent(
    MotionEventKind Kind,
    int Foot,
    int Joint,
    Vector3 Position,
    Vector3 Normal,
    int Surface,
    float Speed,
    float Strength,
    float SecondsAgo);
