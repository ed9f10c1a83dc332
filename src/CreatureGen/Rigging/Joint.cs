using System.Numerics;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>What a joint is for, independent of its number.</summary>
public enum JointRole
{
    /// <summary>The creature's place in the world, on the ground.</summary>
    Root,

    /// <summary>The body's own root: its centre, or the head of a swimmer.</summary>
    Body,

    /// <summary>Carrier of the hind limbs.</summary>
    Pelvis,

    /// <summary>Between pelvis and chest.</summary>
    Spine,

    /// <summary>Carrier of the fore limbs.</summary>
    Chest,

    /// <summary>Neck.</summary>
    Neck,

    /// <summary>Head.</summary>
    Head,

    /// <summary>Lower jaw.</summary>
    Jaw,

    /// <summary>Eyeball; local +Z of the model is its gaze at rest.</summary>
    Eye,

    /// <summary>Eyelid: turns about local X to the end of its range until the eye is shut.</summary>
    Lid,

    /// <summary>Tail.</summary>
    Tail,

    /// <summary>Shoulder blade or half of the hips: slides, does not turn.</summary>
    Girdle,

    /// <summary>Hip or shoulder.</summary>
    Hip,

    /// <summary>Knee or elbow.</summary>
    Knee,

    /// <summary>Ankle or wrist.</summary>
    Ankle,

    /// <summary>Ball of the foot or of the hand, carrying toes or fingers.</summary>
    Ball,

    /// <summary>Joint of a wing, root to tip.</summary>
    Wing,

    /// <summary>Joint of a fin.</summary>
    Fin,

    /// <summary>Joint of an ear.</summary>
    Ear,

    /// <summary>Joint of an antenna.</summary>
    Antenna,

    /// <summary>The end of a chain; moves no vertex.</summary>
    End,

    /// <summary>None of these: a joint of a skeleton from elsewhere about which nothing is known.</summary>
    Other,
}

/// <summary>A joint of a <see cref="Skeleton"/> in its rest pose.</summary>
/// <param name="Name">Unique name; of grown creatures ASCII, the same for the same role in every creature.</param>
/// <param name="Role">What it is for.</param>
/// <param name="Side">Left, right or on the midline.</param>
/// <param name="Parent">Index of the parent, always smaller than its own; −1 for the root.</param>
/// <param name="LocalPosition">Metres, in the parent's space.</param>
/// <param name="LocalRotation">In the parent's space.</param>
/// <param name="ModelPosition">Metres, in model space.</param>
/// <param name="ModelRotation">In model space.</param>
/// <param name="Length">Distance to the main child, metres; 0 of an end joint and of the frames of the whole creature (root and body).</param>
/// <param name="Limit">Limits of its rotation.</param>
public sealed record Joint(
    string Name,
    JointRole Role,
    Side Side,
    int Parent,
    Vector3 LocalPosition,
    Quaternion LocalRotation,
    Vector3 ModelPosition,
    Quaternion ModelRotation,
    float Length,
    JointLimit Limit)
{
    /// <summary>Unit direction of the bone in the joint's own space: towards the main child, of a joint without children onward from its parent. +Y in grown creatures.</summary>
    public Vector3 Along { get; init; } = Vector3.UnitY;
}
