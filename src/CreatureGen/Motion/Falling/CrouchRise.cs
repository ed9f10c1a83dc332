using System;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>Rises from the deepest crouch that keeps the feet where they stand.</summary>
internal sealed class CrouchRise : IRise
{
    /// <summary>Time that it takes, √(leg length / gravity).</summary>
    private const float Time = 3.4f;

    private readonly FallProfile profile;
    private readonly WalkingMode legs;
    private readonly PoseBuffer shown;
    private float crouch;

    public CrouchRise(FallProfile profile, WalkingMode legs)
    {
        this.profile = profile;
        this.legs = legs;
        shown = new PoseBuffer(profile.Skeleton);
    }

    /// <inheritdoc/>
    public void Begin(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        legs.Bow = 0f;
        Crouch(profile.CrouchDepth, place, settings, layer, local);
        shown.Take(local);
        shown.Finish();
        float sunk = -profile.Support.Lowest(BodyPart.Trunk | BodyPart.Limb, place, shown.Model, settings.Up, ground, out _);
        if (sunk > 0f)
        {
            // What hangs lower than its belly, as long folded wings do, keeps it up.
            Crouch(Math.Max(crouch - sunk, 0f), place, settings, layer, local);
        }
    }

    /// <inheritdoc/>
    public float Seconds(float tau) => Time * tau * profile.Manner.Tempo;

    /// <inheritdoc/>
    public void Show(float u, in RootPlace place, float dt, in MotionSettings settings, BodyLayer? layer, in Pose local)
    {
        (float fore, float hind) = profile.Manner.At(u);
        legs.Sink = hind * crouch;
        legs.Bow = (fore - hind) * crouch;
        legs.Hold(place, dt, settings, layer, local);
    }

    /// <inheritdoc/>
    public void CopyFrom(IRise other) => crouch = ((CrouchRise)other).crouch;

    /// <summary>Stands in a crouch so deep, metres of the model.</summary>
    private void Crouch(float depth, in RootPlace place, in MotionSettings settings, BodyLayer? layer, in Pose local)
    {
        crouch = depth;
        legs.Sink = depth;
        legs.Hold(place, 0f, settings, layer, local);
    }
}
