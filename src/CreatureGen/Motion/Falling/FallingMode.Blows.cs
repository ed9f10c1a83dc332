using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <content>What blows do, and how it goes limp.</content>
internal sealed partial class FallingMode
{
    /// <summary>Arm by which a blow turns a floating body as much as it pushes it, part of the body's size.</summary>
    private const float LeverPart = 0.3f;

    /// <summary>Whether air or water carries it, and nothing holds it that a blow turns.</summary>
    private bool Floats => State == BodyState.Afloat || (subject.Kind != LocomotionKind.Walking && !inner.IsOnFeet);

    /// <summary>Has it go limp with the next update.</summary>
    public void GoLimp()
    {
        goesLimp = State != BodyState.Limp;
        getsUp = false;
    }

    /// <summary>Hits a part: what does not carry the body gives and recovers, the body is pushed, and steps after it; above what balance takes it goes limp, and gets up by itself.</summary>
    /// <param name="joint">Of the part.</param>
    /// <param name="impulse">World N·s.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="model">Its pose.</param>
    /// <param name="settings">Gravity.</param>
    public void Hit(int joint, Vector3 impulse, in RootPlace place, in Pose model, in MotionSettings settings)
    {
        float scale = place.Scale;
        float tau = Tau(scale, settings.Gravity);
        Vector3 change = impulse / (profile.Value.Mass * scale * scale * scale);
        float speed = Vec.Length(change);
        float balance = KnockDown * settings.Gravity * tau;
        blow = new Blow(joint, impulse, speed / (settings.Gravity * tau));
        if (State == BodyState.Limp)
        {
            Lying.Push(joint, impulse, scale, settings.Gravity);
        }
        else if (State == BodyState.Rising || speed > balance)
        {
            GoLimp();
            (getsUp, dazed) = (true, true);
        }
        else
        {
            Recoil.Strike(joint, impulse, place, model, tau);
            Stagger(joint, change, place, model, balance / KnockDown, tau);
        }
    }

    /// <summary>Lays what is left of blows on a pose, after gaze has turned its head: who looks somewhere would hold its head against them.</summary>
    /// <param name="dt">Seconds.</param>
    /// <param name="place">Where the creature is.</param>
    /// <param name="gravity">World m/s².</param>
    /// <param name="local">The pose.</param>
    /// <param name="model">The same in model space, brought up to date.</param>
    public void Give(float dt, in RootPlace place, float gravity, in Pose local, in Pose model)
    {
        if (TryGiveWay(dt, place, gravity, local))
        {
            ForwardKinematics.LocalToModel(profile.Value.Skeleton, local, model);
        }
    }

    /// <summary>Lays what is left of blows on a local pose; says whether there is any.</summary>
    private bool TryGiveWay(float dt, in RootPlace place, float gravity, in Pose local)
    {
        if (recoil is not { IsActive: true } || State is BodyState.Limp or BodyState.Rising)
        {
            return false;
        }

        recoil.Apply(dt, Tau(place.Scale, gravity), local);
        return true;
    }

    /// <summary>Lets the body be pushed: on its legs it steps after it and reels; else it is carried off and slows down, and turns meanwhile where air or water carries it.</summary>
    private void Stagger(int joint, Vector3 change, in RootPlace place, in Pose model, float unit, float tau)
    {
        Vector3 own = Rotation.Rotate(Rotation.Inverse(place.Rotation), change);
        if (State == BodyState.Falling)
        {
            Fall.Push(change);
        }
        else if (legs != null && inner.StandsOnFeet && State != BodyState.Afloat)
        {
            legs.Push(own / place.Scale, 0f);
            Reel.Strike(own / unit, 0f, tau);
        }
        else
        {
            drift.Push(change);
            if (Floats)
            {
                Vector3 lever = (model.Positions[joint] - subject.Mass.Centre) / (LeverPart * profile.Value.Ragdoll.Size);
                Reel.Strike(own / unit, Vec.Cross(lever, own / unit).Y, tau);
            }
        }
    }
}
