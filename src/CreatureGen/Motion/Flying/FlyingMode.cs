using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Poses;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>
/// Drives a flier: on its legs while it has ground under its feet, on its wings else. Between the two it crouches and pushes off with its feet where they stand, and comes down onto feet that are
/// set below it: the pose on the legs is mixed with that in the air by how much the feet are planted. Wings belong to the flight at all times. What has no legs is always in the air: it hovers
/// where others stand.
/// </summary>
internal sealed class FlyingMode : IWingedMode
{
    /// <summary>How far down the ground is looked for, metres of the model.</summary>
    private const float Lookout = 200f;

    /// <summary>Leg lengths above the ground at which a flier that the game moves is in the air.</summary>
    private const float AirborneHeight = 0.3f;

    /// <summary>Force of all feet at a leap and at a touchdown, weights of the body.</summary>
    private const float PushForce = 2.5f;

    /// <summary>How far wings are opened in a jump and in a fall, as those that are shown, and how quickly, √(g/leg).</summary>
    private const double HeldOpen = 0.9;
    private const double OpeningRate = 4.5;

    private readonly FlightProfile profile;
    private readonly WalkingMode? legs;
    private readonly StancePose stance;
    private readonly LegPace? pace;
    private readonly EventQueue events;
    private FlightState state;
    private CriticallyDampedSpring opened;
    private float turn;

    /// <summary>Speed of its legs when they came down or began to make ready for a leap, metres of the model per second; null while they go as they are asked.</summary>
    private float? kept;

    public FlyingMode(FlightProfile profile, WalkingMode? legs, EventQueue events)
    {
        this.profile = profile;
        this.legs = legs;
        this.events = events;
        stance = new StancePose(profile.Skeleton);
        pace = legs?.NewPace();
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

    /// <summary>How far it gives way on its legs, metres of the model: within one long update it comes down and does so.</summary>
    private float Sink => (float)(profile.CrouchDepth * state.CrouchDepth);

    /// <summary>How it is where nothing is asked of it.</summary>
    private FlightState Resting => legs != null ? FlightState.OnGround : FlightState.Hovering(profile);

    /// <summary>Whether it stands still with its wings folded.</summary>
    public bool IsFolded => StandsOnFeet && legs!.IsStill && state.Phase == FlightPhase.Grounded && state.WingSpread < 0.01f && opened.Value < 0.01;

    public RootPlace Update(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        FlightInput asked;
        state.Left = dt;
        do
        {
            bool before = IsOnFeet;
            FlightPhase phase = state.Phase;
            float left = state.Left;
            RootDelta way = Fly(place, left, input, settings, HeightOf(place, settings, ground), layer, out asked);
            float gone = left - state.Left;
            if (before)
            {
                legs!.Sink = Sink;
                place = legs.Update(place, gone, OnFoot(phase, input, place.Scale), settings, ground, layer, stance.Cleared());
                Speed = legs.Speed;
            }
            else
            {
                Speed = state.Speed;
                turn = (float)state.Turn.Value;
                place = way.From(place);
            }

            Change(before, place, settings, ground, layer);
        }
        while (state.Left > 0f);

        if (!IsOnFeet)
        {
            Reach(place, settings, ground, layer);
        }

        Write(asked, local);
        pace?.Bound(dt, local);
        return place;
    }

    public void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        float height = HeightOf(goal, settings, ground);
        MotionMedium medium = height > AirborneHeight * profile.LegLength ? MotionMedium.Air : MotionMedium.Ground;
        MotionInput input = RootStep.Asked(place, dt, goal, medium);
        FlightInput asked;
        state.Left = dt;
        do
        {
            bool before = IsOnFeet;
            Fly(goal, state.Left, input, settings, height, layer, out asked);
            Speed = before ? legs!.Speed : state.Speed;
            turn = (float)state.Turn.Value;
            Change(before, goal, settings, ground, layer);
        }
        while (state.Left > 0f);

        if (IsOnFeet)
        {
            legs!.Follow(place, dt, goal, settings, ground, layer, stance.Cleared());
            Speed = legs.Speed;
        }
        else
        {
            Reach(goal, settings, ground, layer);
        }

        Write(asked, local);
        pace?.Bound(dt, local);
    }

    public void Stand(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        state = Resting;
        Speed = 0f;
        kept = null;
        opened = default;
        Fly(place, 0f, default, settings, HeightOf(place, settings, ground), layer, out FlightInput asked);
        if (legs != null)
        {
            legs.Sink = 0f;
            legs.Stand(place, settings, ground, layer, stance.Cleared());
        }

        Write(asked, local);
        pace?.Show(local);
    }

    public void HoldWings(in RootPlace place, float dt, bool open, in MotionSettings settings, BodyLayer? layer, in Pose local)
    {
        FlightInput asked;
        state.Left = dt;
        do
        {
            // What its legs jump off is as good as ground under them.
            Fly(place, state.Left, default, settings, 0f, layer, out asked, open ? HeldOpen : 0);
        }
        while (state.Left > 0f);
        Speed = legs!.Speed;
        stance.Take(local);
        Write(asked, local);
        pace?.Show(local);
    }

    public void TakeWing(Vector3 velocity)
    {
        state.Phase = FlightPhase.Airborne;
        state.Age = 0;
        state.Ahead = Momentum.At(velocity.Z);
        state.Rise = Momentum.At(velocity.Y);
        state.Fell = true;
        Speed = state.Speed;
        kept = null;
    }

    public void Rebase(Vector3 offset) => legs?.Rebase(offset);

    public void CopyFrom(ILocomotionMode other)
    {
        var mode = (FlyingMode)other;
        legs?.CopyFrom(mode.legs!);
        stance.CopyFrom(mode.stance);
        pace?.CopyFrom(mode.pace!);
        state = mode.state;
        opened = mode.opened;
        turn = mode.turn;
        kept = mode.kept;
        Speed = mode.Speed;
    }

    /// <summary>What is asked of the legs: a flier that makes ready to leap keeps its run, one that has come down runs out.</summary>
    private MotionInput OnFoot(FlightPhase phase, in MotionInput input, float scale)
    {
        if (phase == FlightPhase.Grounded && input.Medium != MotionMedium.Air)
        {
            kept = null;
            return input;
        }

        kept ??= Math.Max(legs!.Speed, 0f);
        float speed = Math.Min(input.Speed, kept.Value * scale);
        return phase == FlightPhase.Settling ? new MotionInput(speed, input.YawRate) : new MotionInput(speed);
    }

    /// <summary>Where it has come down, lets the legs take over, at the speed at which it did; where it has left the ground, tells so and goes on at the speed of its legs.</summary>
    private void Change(bool before, in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        if (IsOnFeet && !before)
        {
            Arrive(place, settings, ground, layer);
            kept = null;
            legs!.Tell(MotionEventKind.FootDown, Speed * place.Scale, PushForce);
        }
        else if (before && !IsOnFeet)
        {
            state.Ahead = Momentum.At(legs!.Speed);
            legs.Tell(MotionEventKind.FootUp, state.Speed * place.Scale, PushForce);
        }
    }

    /// <summary>Sets the feet of a flier that comes down where they will stand.</summary>
    private void Reach(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        if (legs != null && state.Phase == FlightPhase.Landing && state.Planting > 0)
        {
            Arrive(place, settings, ground, layer);
        }
    }

    /// <summary>Has its legs as they are, or will be, where they take over.</summary>
    private void Arrive(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        float speed = Math.Max(Speed, 0f);
        legs!.Sink = Sink;
        legs.Arrive(place, speed, state.Foreseen ?? speed, turn, settings, ground, layer, stance.Cleared());
    }

    /// <summary>Writes the pose: last, for folded wings swing with the steps of this very update.</summary>
    private void Write(in FlightInput asked, in Pose local)
    {
        FlightPose.Write(profile, state, asked with { Sway = IsOnFeet ? legs!.Sway : default }, local);
        if (legs != null)
        {
            stance.Mix(state.Planted.Value, local);
        }
    }

    private RootDelta Fly(in RootPlace place, float dt, in MotionInput input, in MotionSettings settings, float height, BodyLayer? layer, out FlightInput asked, double opening = 0)
    {
        FlightIntent intent = legs == null || input.Medium == MotionMedium.Air ? FlightIntent.Air : FlightIntent.Ground;
        float scale = place.Scale;
        if (IsOnFeet)
        {
            state.Ahead = Momentum.At(legs!.Speed);
        }

        state.RunOut = legs?.RunOut ?? 0f;
        state.Raised = legs?.Raised ?? 0f;
        asked = new FlightInput(intent, input.Speed / scale, input.YawRate, input.ClimbRate / scale, height, settings.Gravity / scale, settings.Flying);
        RootDelta way = FlightMotion.Advance(profile, asked, ref state, dt);
        opened.Step(opening, OpeningRate * Math.Sqrt(asked.Gravity / profile.LegLength), dt - state.Left);
        asked = asked with { ShownWings = Math.Max(layer?.Wings ?? 0f, (float)opened.Value) };
        events.Left = state.Left;
        for (int k = state.BeatsBegun - 1; k >= 0; k--)
        {
            float ago = state.SecondsSinceBeat + (k / state.BeatFrequency);
            events.Add(new MotionEvent(MotionEventKind.WingBeat, -1, profile.Shoulder, place.Position, Rotation.Rotate(place.Rotation, Vector3.UnitY), 0, state.Speed * scale, state.BeatWidth, ago));
        }

        return way;
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
