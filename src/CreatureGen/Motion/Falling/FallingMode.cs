using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Floating;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// A way of moving, and what happens to the body where that does not carry it: the states from losing the ground to standing again. The pose that it is given is the one shown last.
/// </summary>
internal sealed partial class FallingMode : ILocomotionMode
{
    /// <summary>Most events of the whole body in an update, those of feet that come down together not counted.</summary>
    public const int MaxEvents = 5;

    /// <summary>Change of the body's speed, √(gℓ), above which a blow knocks it down.</summary>
    private const float KnockDown = 0.6f;

    private readonly MotionSubject subject;
    private readonly LeggedBody? body;
    private readonly Lazy<FallProfile> profile;
    private readonly ILocomotionMode inner;
    private readonly IWingedMode? wings;
    private readonly WalkingMode? legs;
    private readonly EventQueue events;
    private Footing footing;
    private FreeFall? fall;
    private LimpBody? limp;
    private GettingUp? up;
    private Leap? leap;
    private Recoil? recoil;
    private Reel? reel;
    private Blow blow;
    private Drift drift;
    private bool goesLimp;
    private bool getsUp;
    private bool dazed;
    private bool hasMoved;

    /// <summary>Wraps a way of moving.</summary>
    /// <param name="subject">Whose.</param>
    /// <param name="body">The body as its walk sees it; null without legs to stand on.</param>
    /// <param name="profile">How it falls.</param>
    /// <param name="floats">How it floats; null for what does not.</param>
    /// <param name="inner">What carries it.</param>
    /// <param name="legs">How it goes on its legs; null without legs to stand on.</param>
    /// <param name="events">Receives what happens.</param>
    public FallingMode(MotionSubject subject, LeggedBody? body, Lazy<FallProfile> profile, FloatProfile? floats, ILocomotionMode inner, WalkingMode? legs, EventQueue events)
    {
        this.subject = subject;
        this.body = body;
        this.profile = profile;
        this.floats = floats;
        this.inner = inner;
        wings = inner as IWingedMode;
        this.legs = legs;
        this.events = events;
        blow = Blow.None;
    }

    /// <summary>Asks memory for what it remembers.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch() => MemoryLines.Touch(ref footing) ^ MemoryLines.Touch(ref drift) ^ MemoryLines.Touch(ref glide);

    /// <summary>What carries the creature.</summary>
    public BodyState State { get; private set; }

    public float Speed => State switch
    {
        BodyState.Afloat => Water.Speed,
        BodyState.Limp or BodyState.Rising => 0f,
        _ => inner.Speed,
    };

    public float Phase => State == BodyState.Afloat ? Water.Phase : inner.Phase;

    public float Frequency => State == BodyState.Afloat ? Water.Frequency : inner.Frequency;

    public bool IsOnFeet => IsUp && inner.IsOnFeet;

    public bool StandsOnFeet => IsUp && inner.StandsOnFeet;

    public bool IsFolded => inner.IsFolded;

    public bool Escapes => inner.Escapes;

    public float Clearance => State is BodyState.Falling or BodyState.Afloat ? float.PositiveInfinity : inner.Clearance;

    public float Incline => State is BodyState.Falling or BodyState.Afloat ? 0f : inner.Incline;

    public float BalancedBank => inner.BalancedBank;

    /// <summary>Whether it is limp, or is to be with the next update.</summary>
    public bool IsLimp => goesLimp || State == BodyState.Limp;

    /// <summary>Whether nothing bears it from below: it flies, jumps or falls, or is down already.</summary>
    public bool IsInAir => State == BodyState.Supported ? wings != null && !inner.IsOnFeet : State != BodyState.Afloat && State != BodyState.Landed;

    /// <summary>Whether it goes on its legs and nothing else happens to it, or is about to.</summary>
    public bool OnlyWalks(in RootPlace place, in MotionSettings settings, IGround ground) => State == BodyState.Supported && inner == legs
        && glide.IsOver && !goesLimp && blow.Joint < 0 && recoil is not { IsActive: true } && reel is not { IsActive: true }
        && !(Read(ground, place) is { Ground: not null } reading && Water.IsWet(reading, place));

    /// <summary>What there is of water where it is; nothing for what does not float.</summary>
    private WaterReading Read(IGround ground, in RootPlace place) => floats == null ? default : WaterReading.At(ground, place.Position);

    /// <summary>Whether feet, wings or water carry it.</summary>
    private bool IsUp => State is BodyState.Supported or BodyState.Leaping or BodyState.Landed;

    private LimpBody Lying => limp ??= new LimpBody(profile.Value);

    private GettingUp Up => up ??= new GettingUp(profile.Value, inner, legs);

    private Leap Leap => leap ??= new Leap(body!, profile.Value, legs!);

    private Recoil Recoil => recoil ??= new Recoil(profile.Value);

    private Reel Reel => reel ??= new Reel(body?.Legs.Length ?? 0, body?.LegLength ?? 0f);

    private FreeFall Fall => fall ??= new FreeFall(body!, profile.Value, legs!);

    /// <summary>How far it jumps.</summary>
    public JumpReach ReachOf(float scale, float gravity) => legs == null ? default : Leap.Reach(scale, gravity);

    /// <summary>Has it jump so that its root lands at a point of the world.</summary>
    public JumpResult Jump(Vector3 target, in RootPlace place, in MotionSettings settings)
    {
        if (legs == null || State != BodyState.Supported || !inner.StandsOnFeet)
        {
            return legs == null ? JumpResult.NoLegs : JumpResult.NotOnFeet;
        }

        JumpResult result = Leap.Begin(target, place, settings);
        State = result == JumpResult.Begun ? BodyState.Leaping : State;
        return result;
    }

    /// <summary>Has it get up as soon as it lies still.</summary>
    /// <returns>Whether it lies, or will with the next update.</returns>
    public bool GetUp()
    {
        getsUp = State == BodyState.Limp || goesLimp;
        dazed = false;
        if (getsUp)
        {
            // Here and not in an update, for finding out how a creature lies takes a while.
            _ = Up;
        }

        return getsUp;
    }

    /// <summary>Moves on by a time, seen from where the root is to be.</summary>
    private RootPlace Advance(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        IGround felt = ground;
        WaterReading reading = Read(ground, place);
        if (State == BodyState.Afloat || reading.Ground != null)
        {
            Float(place, reading, input, settings, ground, layer, local);
            felt = Water.FeltOf(ground, reading, place, settings);
        }

        if (State == BodyState.Supported && inner == legs && footing.IsLost(body!, legs, place, dt, settings, felt))
        {
            Begin(place, local, settings);
        }

        if (State == BodyState.Falling && TakesWing(place, input, settings))
        {
            wings!.TakeWing(Rotation.Rotate(Rotation.Inverse(place.Rotation), Fall.Velocity) / place.Scale);
            State = BodyState.Supported;
        }

        if (goesLimp || State == BodyState.Falling)
        {
            Lying.Keep(local);
        }

        if (getsUp && State == BodyState.Limp && Lying.IsCalm(place.Scale, settings.Gravity, dazed && !input.Goes))
        {
            place = Rise(place, settings, ground, layer);
        }

        RootPlace next = Move(place, reading, dt, input, settings, State is BodyState.Supported or BodyState.Leaping or BodyState.Landed ? felt : ground, layer, local);
        if (State is BodyState.Supported or BodyState.Afloat)
        {
            water?.Fade(next, dt, settings, local);
        }

        if (goesLimp)
        {
            goesLimp = false;
            TryGiveWay(dt, place, settings.Gravity, local);
            if (layer != null)
            {
                Lying.Hold(local);
            }

            // The pose before the first that is shown is the rest pose, and what lies between them no velocity.
            Lying.Begin(next, local, place, hasMoved ? dt : 0f, ground);
            State = BodyState.Limp;
            Tell(MotionEventKind.WentLimp, next, settings.Up, 0f, 0f);
            if (blow.Joint >= 0)
            {
                Lying.Push(blow.Joint, blow.Impulse, place.Scale, settings.Gravity);
            }
        }

        if (blow.Joint >= 0)
        {
            events.Add(new MotionEvent(MotionEventKind.Struck, -1, blow.Joint, next.Position, settings.Up, 0, 0f, blow.Strength, 0f));
            blow = Blow.None;
        }

        hasMoved = true;
        return next;
    }

    /// <inheritdoc/>
    public void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        bool swam = State == BodyState.Afloat;
        Recover();
        glide = default;
        WaterReading reading = Read(ground, goal);
        bool swims = reading.Ground != null && Water.Carries(reading, goal, settings);
        if (swims != swam)
        {
            Change(swims, goal, settings, ground, layer, local);
        }

        local.SetToRest(subject.Skeleton);
        if (swims)
        {
            State = BodyState.Afloat;
            Water.Follow(place, dt, goal, settings, ground, layer, local);
        }
        else
        {
            inner.Follow(place, dt, goal, settings, ground, layer, local);
        }

        water?.Fade(goal, dt, settings, local);
        hasMoved = true;
    }

    /// <inheritdoc/>
    public void Stand(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        Recover();
        glide = default;
        water?.Stop();
        local.SetToRest(subject.Skeleton);
        inner.Stand(place, settings, ground, layer, local);
        hasMoved = true;
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
        (State, footing, goesLimp, getsUp, dazed, hasMoved, blow, drift, glide, haste) = (mode.State, mode.footing, mode.goesLimp, mode.getsUp, mode.dazed, mode.hasMoved, mode.blow, mode.drift, mode.glide, mode.haste);
        if (mode.fall != null)
        {
            Fall.CopyFrom(mode.fall);
        }

        if (mode.water != null)
        {
            Water.CopyFrom(mode.water);
        }

        if (mode.leap != null)
        {
            Leap.CopyFrom(mode.leap);
        }

        if (mode.recoil != null)
        {
            Recoil.CopyFrom(mode.recoil);
        }

        if (mode.reel != null)
        {
            Reel.CopyFrom(mode.reel);
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
    private RootPlace Move(RootPlace place, in WaterReading reading, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        switch (State)
        {
            case BodyState.Leaping:
                local.SetToRest(subject.Skeleton);
                return Leaping(place, dt, settings, ground, layer, local);
            case BodyState.Falling:
                local.SetToRest(subject.Skeleton);
                return Falling(place, dt, settings, ground, layer, local);
            case BodyState.Landed:
                local.SetToRest(subject.Skeleton);
                return Landed(place, dt, input, settings, ground, layer, local);
            case BodyState.Afloat:
                local.SetToRest(subject.Skeleton);
                return Swimming(place, dt, input, settings, ground, layer, local);
            case BodyState.Limp:
                return Lie(place, dt, settings, ground, local);
            case BodyState.Rising:
                GoOnRising(place, dt, input, settings, ground, layer, local);
                return place;
            default:
                local.SetToRest(subject.Skeleton);
                return Carried(place, reading, dt, input, settings, ground, layer, local);
        }
    }

    private RootPlace Carried(in RootPlace place, in WaterReading reading, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        MotionInput possible = water != null && inner.StandsOnFeet ? water.Wade(input, reading, place, settings) : input;
        bool stands = inner.StandsOnFeet;

        // Of what nothing has happened to nothing goes by it.
        float tau = drift.IsOver && reel == null && up == null ? 0f : Tau(place.Scale, settings.Gravity);
        BodyLayer? reeling = reel == null || !stands ? layer : reel.On(layer, dt, tau);
        RootPlace next = inner.Update(drift.IsOver ? place : drift.Carry(place, dt, tau), dt, possible, settings, ground, reeling, local);
        up?.Fade(dt, tau, local);
        if (!stands)
        {
            reel?.Turn(profile.Value.Body, subject.Mass.Centre, dt, tau, local);
        }

        return next;
    }

    private RootPlace Swimming(in RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        float tau = Tau(place.Scale, settings.Gravity);
        RootPlace next = Water.Update(drift.Carry(place, dt, tau), dt, input, settings, ground, layer, local);
        reel?.Turn(profile.Value.Body, subject.Mass.Centre, dt, tau, local);
        return next;
    }

    private float Tau(float scale, float gravity) => (float)Math.Sqrt(profile.Value.Height * scale / gravity);

    private void Tell(MotionEventKind kind, in RootPlace place, Vector3 up, float speed, float strength) =>
        events.Add(new MotionEvent(kind, -1, profile.Value.Body, place.Position, up, 0, speed, strength, 0f));
}
