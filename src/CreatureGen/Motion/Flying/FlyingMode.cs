using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>
/// Drives a flier: on its legs while it has ground under its feet, on its wings else. Between the two it crouches and pushes off with its feet where they stand, and comes down onto feet that are
/// set below it: the pose on the legs is mixed with that in the air by how much the feet are planted. Wings belong to the flight at all times. What has no legs is always in the air: it hovers
/// where others stand.
/// </summary>
internal sealed class FlyingMode : ILocomotionMode
{
    /// <summary>How far down the ground is looked for, metres of the model.</summary>
    private const float Lookout = 200f;

    /// <summary>Leg lengths above the ground at which a flier that the game moves is in the air.</summary>
    private const float AirborneHeight = 0.3f;

    /// <summary>Force of all feet at a leap and at a touchdown, weights of the body.</summary>
    private const float PushForce = 2.5f;

    private readonly FlightProfile profile;
    private readonly WalkingMode? legs;
    private readonly StancePose stance;
    private readonly EventQueue events;
    private FlightState state;
    private float turn;

    /// <summary>Speed at which it began to reach for the ground, metres of the model per second; null while it does not.</summary>
    private float? foreseen;

    public FlyingMode(FlightProfile profile, WalkingMode? legs, EventQueue events)
    {
        this.profile = profile;
        this.legs = legs;
        this.events = events;
        stance = new StancePose(profile.Skeleton);
        state = Resting;
    }

    /// <summary>Most beats of wings in the longest update.</summary>
    public const int MaxBeats = 8;

    public float Speed { get; private set; }

    public float Phase => StandsOnFeet ? legs!.Phase : (float)state.Cycle;

    public float Frequency => StandsOnFeet ? legs!.Frequency : state.BeatFrequency;

    public bool IsOnFeet => legs != null && state.IsOnFeet;

    public bool StandsOnFeet => IsOnFeet && StancePose.IsWhole(state.Planted.Value);

    public float Clearance => IsOnFeet ? 0f : (float)state.Height.Value;

    public float Incline => IsOnFeet ? legs!.Incline : 0f;

    public float BalancedBank => IsOnFeet ? 0f : (float)(state.Air.Value * state.Bank);

    public bool Escapes => false;

    /// <summary>How it is where nothing is asked of it.</summary>
    private FlightState Resting => legs != null ? FlightState.OnGround : FlightState.Hovering(profile);

    /// <summary>Whether it stands still with its wings folded.</summary>
    public bool IsFolded => StandsOnFeet && legs!.IsStill && state.Phase == FlightPhase.Grounded && state.WingSpread < 0.01f;

    public RootPlace Update(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        bool before = IsOnFeet;
        BodyVelocity velocity = Fly(place, dt, input, settings, ground, layer, local);
        if (IsOnFeet)
        {
            TouchDown(before, place, settings, ground, layer);
            legs!.Sink = (float)(profile.CrouchDepth * state.CrouchDepth);
            place = legs.Update(place, dt, OnFoot(input, place.Scale), settings, ground, layer, stance.Cleared());
            Speed = legs.Speed;
        }
        else
        {
            LiftOff(before, place.Scale);
            Speed = state.Speed;
            turn = (float)state.Turn.Value;
            place = RootStep.Advance(place, velocity, dt);
            Reach(place, settings, ground, layer);
        }

        Mix(local);
        return place;
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        bool before = IsOnFeet;
        float height = HeightOf(goal, settings, ground);
        MotionMedium medium = height > AirborneHeight * profile.LegLength ? MotionMedium.Air : MotionMedium.Ground;
        BodyVelocity velocity = Fly(goal, dt, RootStep.Asked(place, dt, goal, medium), settings, ground, layer, local);
        if (IsOnFeet)
        {
            TouchDown(before, goal, settings, ground, layer);
            legs!.Follow(place, dt, goal, settings, ground, layer, stance.Cleared());
            Speed = legs.Speed;
        }
        else
        {
            LiftOff(before, goal.Scale);
            Speed = state.Speed;
            turn = (float)state.Turn.Value;
            Reach(goal, settings, ground, layer);
        }

        Mix(local);
    }

    public void Stand(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        state = Resting;
        Speed = 0f;
        Fly(place, 0f, default, settings, ground, layer, local);
        if (legs != null)
        {
            legs.Sink = 0f;
            legs.Stand(place, settings, ground, layer, stance.Cleared());
        }

        Mix(local);
    }

    public void Rebase(Vector3 offset) => legs?.Rebase(offset);

    public void CopyFrom(ILocomotionMode other)
    {
        var mode = (FlyingMode)other;
        legs?.CopyFrom(mode.legs!);
        stance.CopyFrom(mode.stance);
        state = mode.state;
        turn = mode.turn;
        foreseen = mode.foreseen;
        Speed = mode.Speed;
    }

    /// <summary>What is asked of the legs: a flier that makes ready to leap keeps its run, one that has come down runs out.</summary>
    private MotionInput OnFoot(in MotionInput input, float scale)
    {
        return state.Phase switch
        {
            FlightPhase.Grounded => input,
            FlightPhase.Crouching => new MotionInput(Math.Min(input.Speed, legs!.Speed * scale)),
            _ => new MotionInput(Math.Min(input.Speed, Math.Max(legs!.Speed, 0f) * scale), input.YawRate),
        };
    }

    /// <summary>Lets the legs take over, at the speed at which it came down.</summary>
    private void TouchDown(bool before, in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        if (!before)
        {
            legs!.Sink = 0f;
            legs.Arrive(place, Speed, foreseen ?? Speed, turn, settings, ground, layer, stance.Cleared());
            legs.Tell(MotionEventKind.FootDown, Speed * place.Scale, PushForce);
            foreseen = null;
        }
    }

    private void LiftOff(bool before, float scale)
    {
        if (before)
        {
            legs!.Tell(MotionEventKind.FootUp, state.Speed * scale, PushForce);
        }
    }

    /// <summary>Sets the feet of a flier that comes down where they will stand.</summary>
    private void Reach(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        if (legs != null && state.Phase == FlightPhase.Landing && state.Planting > 0)
        {
            foreseen ??= Speed;
            legs.Sink = 0f;
            legs.Arrive(place, Speed, foreseen.Value, turn, settings, ground, layer, stance.Cleared());
        }
        else
        {
            foreseen = null;
        }
    }

    private void Mix(in Pose local)
    {
        if (legs != null)
        {
            stance.Mix(state.Planted.Value, local);
        }
    }

    private BodyVelocity Fly(in RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        FlightIntent intent = legs == null || input.Medium == MotionMedium.Air ? FlightIntent.Air : FlightIntent.Ground;
        float scale = place.Scale;
        if (IsOnFeet)
        {
            state.Ahead = Momentum.At(legs!.Speed);
        }

        state.RunOut = legs?.RunOut ?? 0f;
        state.Raised = legs?.Raised ?? 0f;
        var asked = new FlightInput(intent, input.Speed / scale, input.YawRate, input.ClimbRate / scale, HeightOf(place, settings, ground), settings.Gravity / scale, settings.Flying, Math.Max(layer?.Wings ?? 0f, 0f), IsOnFeet ? legs!.Sway : default);
        BodyVelocity velocity = FlightMotion.Update(profile, asked, ref state, dt, local);
        for (int k = state.BeatsBegun - 1; k >= 0; k--)
        {
            float ago = state.SecondsSinceBeat + (k / state.BeatFrequency);
            events.Add(new MotionEvent(MotionEventKind.WingBeat, -1, profile.Shoulder, place.Position, Rotation.Rotate(place.Rotation, Vector3.UnitY), 0, velocity.Linear.Z * scale, state.BeatWidth, ago));
        }

        return velocity;
    }

    /// <summary>Height of the root above the ground, metres of the model.</summary>
    private static float HeightOf(in RootPlace place, in MotionSettings settings, IGround ground)
    {
        float above = place.Scale;
        return ground.Cast(place.Position + (settings.Up * above), -settings.Up, (Lookout * place.Scale) + above, out GroundHit hit)
            ? Vec.Dot(place.Position - hit.Point, settings.Up) / place.Scale
            : Lookout;
    }
}
