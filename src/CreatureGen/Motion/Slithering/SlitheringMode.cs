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

    public RootPlace Drive(RootPlace place, float dt, in MotionInput input, LocomotionSettings settings, IGround ground, in Pose local)
    {
        var asked = new SlitherInput(settings.Crawl, input.Speed / place.Scale, input.YawRate, place);
        return SlitherMotion.Update(profile, asked, ground, state, dt, local);
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, LocomotionSettings settings, IGround ground, in Pose local) =>
        Drive(goal, dt, RootStep.Asked(place, dt, goal, MotionMedium.Ground), settings, ground, local);

    public void Stand(in RootPlace place, LocomotionSettings settings, IGround ground, in Pose local)
    {
        state.Reset();
        Drive(place, 0f, default, settings, ground, local);
    }

    public void Rebase(Vector3 offset)
    {
        // The track goes along when the root is found elsewhere.
    }
}
