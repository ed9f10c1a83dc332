using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Falling;

namespace CreatureGen.Motion;

/// <content>What happens to a body that its way of going does not carry.</content>
public sealed partial class CreatureAnimator
{
    /// <summary>What carries it at present. Where the ground ends or goes away a walker falls, reaches for the ground, and takes up the landing with its legs, all by itself.</summary>
    public BodyState State => Mode?.State ?? BodyState.Supported;

    /// <summary>Lets it go limp with the next update, at the velocities that it has: it falls as a ragdoll and lies in the pose in which it comes to rest until <see cref="GetUp"/>. Nothing happens to what lies already.</summary>
    public void GoLimp() => Mode?.GoLimp();

    /// <summary>Has it get up as soon as it lies still: by phases, with nothing of it in the ground, feet coming to where they stand. The first time for a <see cref="MotionProfile"/> finds out how the creature lies, which takes some ten milliseconds. <see cref="State"/> is <see cref="BodyState.Supported"/> again when it stands.</summary>
    /// <returns>Whether it lies; what stands has nothing to get up from.</returns>
    public bool GetUp() => Mode?.GetUp() ?? false;

    /// <summary>How far it jumps from where it stands; all 0 for what cannot.</summary>
    public JumpReach JumpReach => Mode?.ReachOf(root.Scale, settings.Gravity) ?? default;

    /// <summary>Has what stands on legs jump to a point, from a stand or a run, over whatever is between: it turns there, crouches, flies and lands. A flier opens its wings as it jumps; asked to be in the air, or falling harder than its legs bear, it goes on on its wings.</summary>
    /// <param name="target">Where its root is to land, world space.</param>
    /// <returns>Whether it does, or why it does not.</returns>
    /// <exception cref="ArgumentException">The target is not finite, or farther than 10¹² m along an axis.</exception>
    public JumpResult Jump(Vector3 target)
    {
        Finite.RequireWithin(target, RootPlace.Farthest, nameof(target));
        return Mode?.Jump(target, root, settings) ?? JumpResult.NoLegs;
    }

    /// <summary>Hits it: a neck, tail or limb that does not carry it gives and recovers, the body staggers and steps after it; above what balance takes it goes limp, and gets up by itself.</summary>
    /// <param name="joint">Skeleton index of a joint of the part that is hit, in the middle of its bone.</param>
    /// <param name="impulse">World space, N·s; at most 10⁹ along an axis.</param>
    /// <exception cref="ArgumentException">There is no such joint, or a number is not finite or out of its range.</exception>
    public void Hit(int joint, Vector3 impulse)
    {
        Finite.RequireWithin(impulse, 1e9f, nameof(impulse));
        if ((uint)joint >= (uint)modelRotations.Length)
        {
            throw new ArgumentOutOfRangeException(nameof(joint), joint, FormattableString.Invariant($"expected 0..{modelRotations.Length - 1}"));
        }

        Mode?.Hit(joint, impulse, root, ModelPose, settings);
        headGaze?.Wince();
        secondHead?.Gaze.Wince();
    }
}
