using System.Numerics;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>Drives a swimmer.</summary>
internal sealed class SwimmingMode : ILocomotionMode
{
    private readonly SwimProfile profile;
    private SwimState state;

    public SwimmingMode(SwimProfile profile) => this.profile = profile;

    public float Speed { get; private set; }

    public float Phase => state.CyclePhase;

    public float Frequency => state.BeatFrequency;

    public bool IsOnFeet => false;

    public bool StandsOnFeet => false;

    public bool IsFolded => true;

    public bool Escapes => state.EscapeProgress > 0f;

    public float Clearance => float.PositiveInfinity;

    public float BalancedBank => 0f;

    public RootPlace Drive(RootPlace place, float dt, in MotionInput input, MotionSettings settings, IGround ground, in Pose local)
    {
        float scale = place.Scale;
        BodyVelocity velocity = SwimMotion.Update(profile, new SwimInput(input.Speed / scale, input.YawRate, input.ClimbRate / scale, input.Escape, settings.Swimming), ref state, dt, local);
        Speed = velocity.Linear.Z;
        return RootStep.Advance(place, velocity, dt);
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, MotionSettings settings, IGround ground, in Pose local) =>
        Drive(place, dt, RootStep.Asked(place, dt, goal, MotionMedium.Ground), settings, ground, local);

    public void Stand(in RootPlace place, MotionSettings settings, IGround ground, in Pose local)
    {
        state = default;
        Drive(place, 0f, default, settings, ground, local);
    }

    public void Rebase(Vector3 offset)
    {
    }
}
