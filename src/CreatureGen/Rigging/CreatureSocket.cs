using System.Numerics;
using CreatureGen.Anatomy;

namespace CreatureGen.Rigging;

/// <summary>Where on a creature a socket is.</summary>
public enum SocketKind
{
    /// <summary>The middle of the back where it is most level: riders, packs. +Y out of the skin, +Z towards the head.</summary>
    Saddle,

    /// <summary>The crown of the head: hats, reins. +Y out of the skin, +Z towards the nose.</summary>
    Head,

    /// <summary>Between the lips, carried by the skull: prey, sticks, breath. +Z out of the mouth, +Y up.</summary>
    Mouth,

    /// <summary>The middle of a hand: what it grips. +Z along the fingers, +Y out of the back of the hand.</summary>
    Hand,

    /// <summary>The tip of the tail. +Z off its end, +Y up.</summary>
    TailTip,

    /// <summary>The top or a side of a bone of the spine, as in <see cref="AttachmentPoint"/>. +Y out of the skin, +Z towards the head.</summary>
    Spine,
}

/// <summary>A frame on a creature in which things are worn, held or ridden. It goes with one joint; where that is in the world says <c>CreatureAnimator.Socket</c>.</summary>
/// <param name="Name">Unique ASCII name, the same for the same place on every creature.</param>
/// <param name="Kind">Where it is, and which way its axes point.</param>
/// <param name="Side">Left, right or on the midline. A frame on the right is the mirror image of its counterpart on the left, but for its X axis, which keeps it right-handed.</param>
/// <param name="Joint">Index of the joint that carries it.</param>
/// <param name="Position">Metres, in the joint's space.</param>
/// <param name="Rotation">From the socket to the joint, unit.</param>
public sealed record CreatureSocket(string Name, SocketKind Kind, Side Side, int Joint, Vector3 Position, Quaternion Rotation);
