using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>Drives a swimmer.</summary>
internal sealed class SwimmingMode : ILocomotionMode
{
    /// <summary>Seconds ahead of which the ground is looked for, and how far up and down, body lengths.</summary>
    private const float Foresight = 1f;
    private const float Sight = 3f;

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

    public float Incline => 0f;

    public float BalancedBank => 0f;

    public RootPlace Update(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        // It sees the ground ahead in time to rise above it.
        float ahead = (Foresight * Math.Max(state.Speed, 0f)) + (0.5f * profile.BodyLength);
        Vector3 there = place.Position + Rotation.Rotate(place.Rotation, new Vector3(0f, 0f, ahead * place.Scale));
        float room = Math.Min(RoomBelow(place.Position, place.Scale, settings, ground), RoomBelow(there, place.Scale, settings, ground));
        RootPlace to = RootStep.Advance(place, Swim(place.Scale, dt, input, settings, room, local), dt);
        float below = RoomBelow(to.Position, to.Scale, settings, ground);
        return below < 0f ? new RootPlace(to.Position - (settings.Up * (below * to.Scale)), to.Rotation, to.Scale) : to;
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local) =>
        Swim(place.Scale, dt, RootStep.Asked(place, dt, goal, MotionMedium.Ground), settings, float.PositiveInfinity, local);

    public void Stand(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        state = default;
        Swim(place.Scale, 0f, default, settings, float.PositiveInfinity, local);
    }

    public void Rebase(Vector3 offset)
    {
    }

    public void CopyFrom(ILocomotionMode other)
    {
        var mode = (SwimmingMode)other;
        state = mode.state;
        Speed = mode.Speed;
    }

    private BodyVelocity Swim(float scale, float dt, in MotionInput input, in MotionSettings settings, float room, in Pose local)
    {
        BodyVelocity velocity = SwimMotion.Update(profile, new SwimInput(input.Speed / scale, input.YawRate, input.ClimbRate / scale, input.Escape, settings.Swimming, room), ref state, dt, local);
        Speed = velocity.Linear.Z;
        return velocity;
    }

    /// <summary>How far a root at a place is above the ground, metres of the model; negative in it, infinite where there is none near.</summary>
    private float RoomBelow(Vector3 place, float scale, in MotionSettings settings, IGround ground)
    {
        float reach = Sight * profile.BodyLength * scale;
        return ground.Cast(place + (settings.Up * reach), -settings.Up, 2f * reach, out GroundHit hit) ? Vec.Dot(place - hit.Point, settings.Up) / scale : float.PositiveInfinity;
    }
}
