using System;
using System.Numerics;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Slithering;

/// <summary>Drives a crawler without legs. Its ground is below it along −Y.</summary>
internal sealed class SlitheringMode : ILocomotionMode
{
    private readonly SlitherProfile profile;
    private readonly SlitherState state;

    public SlitheringMode(SlitherProfile profile)
    {
        this.profile = profile;
        state = new SlitherState(profile);
    }

    public float Speed => (float)state.Speed.Value;

    public float Phase => state.CyclePhase;

    public float Frequency => Speed / (float)(profile.Wavelength * state.Progress);

    public bool IsOnFeet => false;

    public bool StandsOnFeet => false;

    public bool IsFolded => true;

    public bool Escapes => false;

    public float Clearance => 0f;

    public float Incline => 0f;

    public float BalancedBank => 0f;

    public RootPlace Update(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        var asked = new SlitherInput(settings.Slithering.Gait, input.Speed / place.Scale, input.YawRate, place, settings.Slithering.SpeedResponse);
        return SlitherMotion.Update(profile, asked, ground, state, dt, local);
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local) =>
        Update(goal, dt, RootStep.Asked(place, dt, goal, MotionMedium.Ground), settings, ground, layer, local);

    public void Stand(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        state.Reset();
        Update(place, 0f, default, settings, ground, layer, local);
    }

    public void Rebase(Vector3 offset)
    {
        // The track goes along when the root is found elsewhere.
    }

    public void CopyFrom(ILocomotionMode other) => state.CopyFrom(((SlitheringMode)other).state);
}
