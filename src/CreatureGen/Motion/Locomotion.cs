using System;
using System.Numerics;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Falling;
using CreatureGen.Motion.Flying;
using CreatureGen.Motion.Grounds;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Slithering;
using CreatureGen.Motion.Swimming;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion;

/// <summary>
/// The way in which a creature moves, wholly or not at all: when a game's ground throws in the middle of a movement, all that the creature remembers, and its pose, are as they were before.
/// </summary>
/// <remarks>
/// There are two of everything: what moves, and what was before. They change places when a movement fails. Over the library's own ground, which never throws, nothing is kept, and what was before is not even made: that is a quarter of an animator's memory. A part of the animator and no object of its own, which would be fetched from memory for each of a crowd.
/// </remarks>
internal struct Locomotion
{
    private readonly MotionProfile profile;
    private readonly EventQueue events;
    private LocalPose? poseBefore;
    private WalkingMode? keptLegs;
    private FallingMode? kept;

    public Locomotion(MotionProfile profile, EventQueue events)
    {
        this.profile = profile;
        this.events = events;
        (Legs, Mode) = Make();
    }

    /// <summary>How it goes on its legs; null without legs to stand on.</summary>
    public WalkingMode? Legs { get; private set; }

    /// <summary>How it moves; null for what cannot.</summary>
    public FallingMode? Mode { get; private set; }

    /// <inheritdoc cref="ILocomotionMode.Update"/>
    public RootPlace Update(in RootPlace place, float dt, in MotionInput input, MotionSettings settings, CheckedGround ground, BodyLayer? layer, in Pose local)
    {
        if (Mode == null)
        {
            return place;
        }

        Keep(ground, local);
        try
        {
            return Mode.Update(place, dt, input, settings, ground, layer, local);
        }
        catch when (ground.MayThrow)
        {
            Undo(local);
            throw;
        }
    }

    /// <inheritdoc cref="ILocomotionMode.Follow"/>
    public void Follow(in RootPlace place, float dt, in RootPlace goal, MotionSettings settings, CheckedGround ground, BodyLayer? layer, in Pose local)
    {
        Keep(ground, local);
        try
        {
            Mode?.Follow(place, dt, goal, settings, ground, layer, local);
        }
        catch when (ground.MayThrow)
        {
            Undo(local);
            throw;
        }
    }

    /// <inheritdoc cref="ILocomotionMode.Stand"/>
    public void Stand(in RootPlace place, MotionSettings settings, CheckedGround ground, BodyLayer? layer, in Pose local)
    {
        Keep(ground, local);
        try
        {
            Mode?.Stand(place, settings, ground, layer, local);
        }
        catch when (ground.MayThrow)
        {
            Undo(local);
            throw;
        }
    }

    /// <summary>Puts the feet of what was seen from afar where they are in their stride.</summary>
    public void Resume(in RootPlace place, MotionSettings settings, CheckedGround ground, in Pose local)
    {
        Keep(ground, local);
        try
        {
            Legs!.Resume(place, settings, ground);
        }
        catch when (ground.MayThrow)
        {
            Undo(local);
            throw;
        }
    }

    private (WalkingMode? Legs, FallingMode? Mode) Make()
    {
        ILocomotionMode? inner = profile.Begin(events, out WalkingMode? legs);
        return (legs, inner == null ? null : new FallingMode(profile.Subject, profile.Legs, profile.Fall, profile.Float, inner, legs, events));
    }

    /// <summary>Keeps what was before where the ground may throw.</summary>
    private void Keep(CheckedGround ground, in Pose local)
    {
        if (ground.MayThrow && Mode != null)
        {
            if (kept == null)
            {
                (keptLegs, kept) = Make();
                poseBefore = new LocalPose(profile.Subject.Skeleton);
            }

            poseBefore!.Take(local);
            kept!.CopyFrom(Mode);
        }
    }

    private void Undo(in Pose local)
    {
        (Legs, keptLegs) = (keptLegs, Legs);
        (Mode, kept) = (kept, Mode);
        poseBefore!.Pose.Rotations.CopyTo(local.Rotations);
        poseBefore.Pose.Positions.CopyTo(local.Positions);
        events.Clear();
    }
}
