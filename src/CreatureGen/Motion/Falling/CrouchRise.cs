using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>Rises from the deepest crouch that keeps the feet where they stand.</summary>
internal sealed class CrouchRise : IRise
{
    /// <summary>Time that it takes, √(leg length / gravity).</summary>
    private const float Time = 3.4f;

    /// <summary>Depth of a crouch from which it takes that, leg lengths; it takes as much less as a body falls sooner from less high, down to a part of it.</summary>
    private const float Deep = 0.45f;
    private const float MinTime = 0.45f;

    /// <summary>Part of a crouch that is left of it at the least.</summary>
    private const float MinCrouch = 0.25f;

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
    public void Begin(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, float height, in Pose local)
    {
        legs.Bow = 0f;
        Crouch(profile.CrouchDepth, place, settings, layer, local);
        shown.Take(local);
        shown.Finish();
        float low = height - profile.TrunkHeight(shown.Model);
        if (low > 0f)
        {
            Crouch(Math.Max(crouch - low, MinCrouch * crouch), place, settings, layer, local);
            shown.Take(local);
            shown.Finish();
        }

        float sunk = -profile.Support.Lowest(BodyPart.Trunk | BodyPart.Limb, place, shown.Model, settings.Up, ground, out _);
        if (sunk > 0f)
        {
            // What hangs lower than its belly, as long folded wings do, keeps it up.
            Crouch(Math.Max(crouch - sunk, 0f), place, settings, layer, local);
        }
    }

    /// <inheritdoc/>
    public float Seconds(float tau) => Time * tau * profile.Manner.Tempo * (float)Scalar.Clamp(Math.Sqrt(crouch / (Deep * profile.Height)), MinTime, 1.0);

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
