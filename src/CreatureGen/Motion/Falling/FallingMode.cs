using System;
using System.Numerics;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// A way of moving, and what happens to the body where that does not carry it: the states from losing the ground to standing again. The pose that it is given is the one shown last.
/// </summary>
internal sealed class FallingMode : ILocomotionMode
{
    /// <summary>Most events of the whole body in an update, those of feet that come down together not counted.</summary>
    public const int MaxEvents = 4;

    private readonly Creature creature;
    private readonly LeggedBody? body;
    private readonly Lazy<FallProfile> profile;
    private readonly ILocomotionMode inner;
    private readonly WalkingMode? legs;
    private readonly EventQueue events;
    private Footing footing;
    private FreeFall? fall;
    private LimpBody? limp;
    private GettingUp? up;
    private bool goesLimp;
    private bool getsUp;

    /// <summary>Wraps a way of moving.</summary>
    /// <param name="creature">Whose.</param>
    /// <param name="body">The body as its walk sees it; null without legs to stand on.</param>
    /// <param name="profile">How it falls.</param>
    /// <param name="inner">What carries it.</param>
    /// <param name="legs">How it goes on its legs; null without legs to stand on.</param>
    /// <param name="events">Receives what happens.</param>
    public FallingMode(Creature creature, LeggedBody? body, Lazy<FallProfile> profile, ILocomotionMode inner, WalkingMode? legs, EventQueue events)
    {
        this.creature = creature;
        this.body = body;
        this.profile = profile;
        this.inner = inner;
        this.legs = legs;
        this.events = events;
    }

    /// <summary>What carries the creature.</summary>
    public BodyState State { get; private set; }

    public float Speed => inner.Speed;

    public float Phase => inner.Phase;

    public float Frequency => inner.Frequency;

    public bool IsOnFeet => IsUp && inner.IsOnFeet;

    public bool StandsOnFeet => IsUp && inner.StandsOnFeet;

    public bool IsFolded => inner.IsFolded;

    /// <inheritdoc/>
    public BodyLayer? Layer
    {
        get => inner.Layer;
        set => inner.Layer = value;
    }

    public bool Escapes => inner.Escapes;

    public float Clearance => State == BodyState.Falling ? float.PositiveInfinity : inner.Clearance;

    public float BalancedBank => inner.BalancedBank;

    /// <summary>Whether feet, wings or water carry it.</summary>
    private bool IsUp => State is BodyState.Supported or BodyState.Landed;

    private LimpBody Lying => limp ??= new LimpBody(profile.Value);

    private GettingUp Up => up ??= new GettingUp(profile.Value, inner, legs);

    private FreeFall Fall => fall ??= new FreeFall(body!, profile.Value, legs!);

    /// <summary>Has it go limp with the next update.</summary>
    public void GoLimp()
    {
        goesLimp = State != BodyState.Limp;
        getsUp = false;
    }

    /// <summary>Has it get up as soon as it lies still.</summary>
    /// <returns>Whether it lies, or will with the next update.</returns>
    public bool GetUp()
    {
        getsUp = State == BodyState.Limp || goesLimp;
        return getsUp;
    }

    /// <inheritdoc/>
    public RootPlace Drive(RootPlace place, float dt, in MotionInput input, MotionSettings settings, IGround ground, in Pose local)
    {
        if (State == BodyState.Supported && inner == legs && footing.IsLost(body!, legs, place, dt, settings, ground))
        {
            Begin(place, local, settings);
        }

        if (goesLimp)
        {
            Lying.Keep(local);
        }

        if (getsUp && State == BodyState.Limp && Lying.IsCalm(place.Scale, settings.Gravity))
        {
            place = Rise(place, settings, ground);
        }

        RootPlace next = Move(place, dt, input, settings, ground, local);
        if (goesLimp)
        {
            goesLimp = false;
            Lying.Begin(next, local, place, dt, ground);
            State = BodyState.Limp;
            Tell(MotionEventKind.WentLimp, next, settings.Up, 0f, 0f);
        }

        return next;
    }

    /// <inheritdoc/>
    public void Follow(in RootPlace place, float dt, in RootPlace goal, MotionSettings settings, IGround ground, in Pose local)
    {
        Recover();
        local.SetToRest(creature.Skeleton);
        inner.Follow(place, dt, goal, settings, ground, local);
    }

    /// <inheritdoc/>
    public void Stand(in RootPlace place, MotionSettings settings, IGround ground, in Pose local)
    {
        Recover();
        local.SetToRest(creature.Skeleton);
        inner.Stand(place, settings, ground, local);
    }

    /// <inheritdoc/>
    public void Rebase(Vector3 offset)
    {
        inner.Rebase(offset);
        limp?.Rebase(offset);
    }

    /// <inheritdoc/>
    public void CopyFrom(ILocomotionMode other)
    {
        var mode = (FallingMode)other;
        inner.CopyFrom(mode.inner);
        (State, footing) = (mode.State, mode.footing);
        (goesLimp, getsUp) = (mode.goesLimp, mode.getsUp);
        if (mode.fall != null)
        {
            Fall.CopyFrom(mode.fall);
        }

        if (mode.limp != null)
        {
            Lying.CopyFrom(mode.limp);
        }

        if (mode.up != null)
        {
            Up.CopyFrom(mode.up);
        }
    }

    /// <summary>Moves on in the present state and writes the pose.</summary>
    private RootPlace Move(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, in Pose local)
    {
        switch (State)
        {
            case BodyState.Falling:
                local.SetToRest(creature.Skeleton);
                return Falling(place, dt, settings, ground, local);
            case BodyState.Landed:
                local.SetToRest(creature.Skeleton);
                return Landed(place, dt, input, settings, ground, local);
            case BodyState.Limp:
                place = Lying.Advance(place, dt, settings, ground);
                Lying.Show(place, dt, settings, ground, local);
                return place;
            case BodyState.Rising:
                if (Up.Advance(place, dt, settings, ground, local))
                {
                    Recover();
                    Tell(MotionEventKind.Rose, place, settings.Up, 0f, 0f);
                }

                return place;
            default:
                local.SetToRest(creature.Skeleton);
                return inner.Drive(place, dt, input, settings, ground, local);
        }
    }

    /// <summary>Begins to get up from where it lies.</summary>
    private RootPlace Rise(in RootPlace place, in MotionSettings settings, IGround ground)
    {
        RootPlace stand = Lying.PlaceUnder(place, settings, ground);
        Up.Begin(Lying, stand, settings, ground);
        Lying.Stop();
        getsUp = false;
        State = BodyState.Rising;
        Tell(MotionEventKind.Rises, stand, settings.Up, 0f, 0f);
        return stand;
    }

    private void Begin(in RootPlace place, in Pose shown, in MotionSettings settings)
    {
        BodyVelocity velocity = legs!.Velocity;
        Fall.Begin(shown, Rotation.Rotate(place.Rotation, velocity.Linear) * place.Scale, velocity.YawRate);
        State = BodyState.Falling;
        Tell(MotionEventKind.Fell, place, settings.Up, 0f, 0f);
    }

    private RootPlace Falling(RootPlace place, float dt, in MotionSettings settings, IGround ground, in Pose local)
    {
        place = Fall.Fall(place, dt, settings, ground, local, out float impact);
        if (impact > 0f)
        {
            State = BodyState.Landed;
            float force = Fall.ForceOf(impact, settings.Gravity);
            Tell(MotionEventKind.Landed, place, settings.Up, impact, force);
            legs!.Tell(MotionEventKind.FootDown, impact, force);
        }

        return place;
    }

    /// <summary>The legs take up the fall; meanwhile it goes no faster than it came.</summary>
    private RootPlace Landed(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, in Pose local)
    {
        State = Fall.Absorb(dt) ? BodyState.Supported : State;
        float going = legs!.Speed * place.Scale;
        var asked = new MotionInput(Scalar.Clamp(input.Speed, Math.Min(going, 0f), Math.Max(going, 0f)), input.YawRate);
        place = legs.Drive(place, dt, asked, settings, ground, local);
        Fall.Fade(dt, local);
        return place;
    }

    /// <summary>Is carried again, as if nothing had been.</summary>
    private void Recover()
    {
        State = BodyState.Supported;
        footing = default;
        goesLimp = false;
        getsUp = false;
        limp?.Stop();
        if (legs != null)
        {
            legs.Sink = 0f;
            legs.Bow = 0f;
        }
    }

    private void Tell(MotionEventKind kind, in RootPlace place, Vector3 up, float speed, float strength) =>
        events.Add(new MotionEvent(kind, -1, profile.Value.Body, place.Position, up, 0, speed, strength, 0f));
}
