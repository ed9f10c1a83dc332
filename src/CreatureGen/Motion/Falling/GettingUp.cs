using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// Gets up by phases: the head rises first, legs are gathered, those out to the side over the ground, the body rolls onto its belly by the shorter side, its trunk on the ground; then it rises from its crouch with its feet planted.
/// What has no legs rights itself only.
/// </summary>
internal sealed class GettingUp
{
    /// <summary>Seconds of the two parts, τ = √(ℓ/g).</summary>
    private const float GatherTime = 5f;
    private const float RiseTime = 4.5f;

    /// <summary>Parts of the gathering: what of its skin is in the ground is out of it at the first, its trunk has come down onto the ground at the second and begins to be as high as it will stand at the third.</summary>
    private const float Cleared = 0.12f;
    private const float Settled = 0.25f;
    private const float Raised = 0.5f;

    /// <summary>How fast the joints of legs out to the side turn towards where they belong at most, radians per τ.</summary>
    private const float FastestLimb = 3f;

    private readonly FallProfile profile;
    private readonly ILocomotionMode inner;
    private readonly WalkingMode? legs;
    private readonly PoseBuffer from;
    private readonly LocalPose to;
    private readonly PoseBuffer shown;
    private readonly LocalPose folded;
    private BodyTurn fromTurn;
    private BodyTurn toTurn;
    private float gather;
    private float rise;
    private float elapsed;
    private float gap;
    private float crouch;

    public GettingUp(FallProfile profile, ILocomotionMode inner, WalkingMode? legs)
    {
        this.profile = profile;
        this.inner = inner;
        this.legs = legs;
        from = new PoseBuffer(profile.Skeleton);
        to = new LocalPose(profile.Skeleton);
        shown = new PoseBuffer(profile.Skeleton);
        folded = new LocalPose(profile.Skeleton);
    }

    /// <summary>Begins.</summary>
    /// <param name="limp">How it lies.</param>
    /// <param name="place">Where it will stand.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it lies on.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    public void Begin(LimpBody limp, in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        limp.Show(place, 0f, settings, ground, from.Local);
        from.Finish();
        folded.Take(from.Local);
        to.SetToRest();
        inner.Stand(place, settings, ground, layer, to.Pose);
        bool crouches = legs != null && inner.IsOnFeet;
        if (crouches)
        {
            legs!.Bow = 0f;
            Crouch(profile.CrouchDepth, place, settings, layer);
            shown.Take(to.Pose);
            shown.Finish();
            float sunk = -profile.Support.Lowest(BodyPart.Trunk | BodyPart.Limb, place, shown.Model, settings.Up, ground, out _);
            if (sunk > 0f)
            {
                // What hangs lower than its belly, as long folded wings do, keeps it up.
                Crouch(Math.Max(crouch - sunk, 0f), place, settings, layer);
            }
        }

        fromTurn = BodyTurn.Of(profile, from.Local);
        toTurn = BodyTurn.Of(profile, to.Pose);
        gap = profile.Support.Lowest(place, from.Model, settings.Up, ground);
        float tau = (float)Math.Sqrt(profile.Height * place.Scale / settings.Gravity) * profile.Manner.Tempo;
        gather = GatherTime * tau;
        rise = crouches ? RiseTime * tau : 0f;
        elapsed = 0f;
    }

    /// <summary>Goes on.</summary>
    /// <param name="place">Where it will stand.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it lies on.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    /// <param name="local">Receives the pose.</param>
    /// <returns>Whether it is over.</returns>
    public bool Advance(in RootPlace place, float dt, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        elapsed += dt;
        if (elapsed < gather)
        {
            Gather(elapsed / gather, dt, place, settings, ground, local);
            return false;
        }

        float u = rise > 0f ? (elapsed - gather) / rise : 1f;
        to.Pose.Rotations.CopyTo(local.Rotations);
        to.Pose.Positions.CopyTo(local.Positions);
        if (rise > 0f)
        {
            (float fore, float hind) = profile.Manner.At(Math.Min(u, 1f));
            legs!.Sink = hind * crouch;
            legs.Bow = (fore - hind) * crouch;
            legs.Hold(place, dt, settings, layer, local);
            shown.Take(local);
            shown.Finish();
            GroundClearance.BendUp(profile, shown, place, settings.Up, ground);
            shown.Local.Rotations.CopyTo(local.Rotations);
        }

        return u >= 1f;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(GettingUp other)
    {
        from.Take(other.from.Local);
        to.Take(other.to.Pose);
        folded.Take(other.folded.Pose);
        (fromTurn, toTurn, gather, rise, elapsed, gap, crouch) = (other.fromTurn, other.toTurn, other.gather, other.rise, other.elapsed, other.gap, other.crouch);
    }

    /// <summary>Stands in a crouch so deep, metres of the model.</summary>
    private void Crouch(float depth, in RootPlace place, in MotionSettings settings, BodyLayer? layer)
    {
        crouch = depth;
        legs!.Sink = depth;
        legs.Hold(place, 0f, settings, layer, to.Pose);
    }

    /// <summary>Rolls onto the belly and gathers the legs.</summary>
    private void Gather(float u, float dt, in RootPlace place, in MotionSettings settings, IGround ground, in Pose local)
    {
        for (int j = 0; j < profile.Skeleton.Count; j++)
        {
            float w = profile.Windows[j].At(u);
            shown.Local.Rotations[j] = Rotation.Slerp(from.Local.Rotations[j], to.Pose.Rotations[j], w);
            shown.Local.Positions[j] = Vec.Lerp(from.Local.Positions[j], to.Pose.Positions[j], w);
        }

        SwingTwistLimit.ClampPose(profile.Skeleton, shown.Local);
        int body = profile.Body;
        BodyTurn.Between(fromTurn, toTurn, u).Set(profile, shown.Local);
        shown.Local.Positions[body] = Vec.Lerp(from.Local.Positions[body], to.Pose.Positions[body], Scalar.Smooth(u));
        shown.Finish();
        if (!profile.Swims)
        {
            // Its trunk lies on the ground while its legs are gathered.
            float depth = Math.Min(gap, 0f) * (1f - Scalar.Smooth(u / Cleared));
            float raised = Scalar.Smooth((u - Raised) / (1f - Raised));
            GroundClearance.Settle(profile, shown, place, depth, Scalar.Smooth(u / Settled) * (1f - raised), settings.Up, ground);
            LimbFold.Up(profile, shown, folded.Pose, FastestLimb * GatherTime * dt / gather, raised, place, depth, settings.Up, ground);
            GroundClearance.Clear(profile, shown, place, depth, settings.Up, ground);
        }

        shown.Local.Rotations.CopyTo(local.Rotations);
        shown.Local.Positions.CopyTo(local.Positions);
    }
}
