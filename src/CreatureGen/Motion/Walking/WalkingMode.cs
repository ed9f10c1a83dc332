using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Events;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Subjects;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Idle;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Motion.Walking.Poses;
using CreatureGen.Motion.Walking.Trunk;
using CreatureGen.Motion.Winged;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking;

/// <summary>Motion on legs: sequences the stages (travel, gait, feet, body, legs, head, arms and tail) and nothing else.</summary>
internal sealed partial class WalkingMode : ILocomotionMode
{
    /// <summary>Seconds that an update counts at most.</summary>
    public const float LongestUpdate = 0.25f;

    /// <summary>Steps in an update at most.</summary>
    public const int MaxSteps = (int)(LongestUpdate / DecisionClock.Period) + 2;

    private const float ActivityRate = 5f;

    /// <summary>Froude number of a slow walk, in which it is as active as it gets.</summary>
    private const float SlowWalk = 0.06f;

    /// <summary>What is left of activity, and of the trunk's way up, where it counts as still.</summary>
    private const float MinActivity = StepContext.MinActivity;

    /// <summary>The same of feet that are all down, for acts.</summary>
    private const float Settled = 0.06f;

    /// <summary>How quickly the trunk comes down from how it stands, and up to it again, per second.</summary>
    private const float LowerRate = 8f;
    private const float RaiseRate = 1.2f;

    /// <summary>Seconds ahead of which the speed decides the gait.</summary>
    private const float Foresight = 0.2f;

    /// <summary>Part of a slow walk below which a creature that comes down does so on the spot.</summary>
    private const float ArrivalSpeed = 0.3f;

    /// <summary>How far apart its feet are as it comes down, relative to where they stand at rest.</summary>
    private const float ArrivalTrack = 0.85f;

    /// <summary>Part of its top speed at which it can come down.</summary>
    private const float RunOutFraction = 0.45f;

    private readonly LeggedBody body;
    private readonly GaitSet gaits;
    private readonly GaitClock clock;
    private readonly FootPlanner planner;
    private readonly BodyPlacer placer;
    private readonly RestRotations turns;
    private readonly LegPoser poser;
    private readonly LegPace pace;
    private readonly CarriedWings? wings;
    private readonly bool winged;
    private RootVelocity velocity;
    private PushedBody pushed;
    private int gait;
    private Gait? told;
    private float activity;
    private float acceleration;
    private StandingLife life;
    private WingSway sway;
    private RestlessFeet restless;
    private bool standing;
    private bool moving;
    private bool going;
    private DecisionClock ticker;
    private bool arrived;
    private ExponentialDecay activityDecay;
    private RootHeight height;
    private ExponentialDecay raiseDecay;

    /// <summary>Sets a body on its legs.</summary>
    /// <param name="body">The body.</param>
    /// <param name="gaits">How it goes.</param>
    /// <param name="events">Receives its footsteps.</param>
    /// <param name="wings">Wings that it carries; null without, and for those that others write.</param>
    public WalkingMode(LeggedBody body, GaitSet gaits, EventQueue events, CarriedWings? wings = null)
    {
        this.body = body;
        this.wings = wings;
        winged = SpreadWings.Of(body.Subject);
        this.gaits = gaits;
        clock = new GaitClock(body, gaits.Steps[0].Gait);
        planner = new FootPlanner(body, events);
        placer = new BodyPlacer(body);
        turns = body.Turns;
        poser = new LegPoser(body, turns);
        pace = new LegPace(body, turns);
    }

    public Gait Gait => clock.Gait;

    public int FootCount => body.Legs.Length;

    public float Speed => velocity.Speed;

    public float Phase => (float)clock.Phase;

    public float Frequency => clock.Frequency;

    public bool IsOnFeet => true;

    public bool StandsOnFeet => true;

    public bool IsFolded => true;

    public bool Escapes => false;

    public float Clearance => placer.Climb * body.Span.Hips;

    public float Incline => placer.Climb;

    public float BalancedBank => 0f;

    /// <inheritdoc/>
    /// <summary>How far the body is let down into its legs, metres of the model.</summary>
    public float Sink { get; set; }

    /// <summary>How much farther its fore body is let down than its hind body, metres of the model; of no use on two legs.</summary>
    public float Bow { get; set; }

    /// <summary>Yaw of what its head is to look at, seen from the root, radians: its chest joins in. 0 for nothing.</summary>
    public float Facing { get; set; }

    /// <summary>How folded wings swing with it.</summary>
    public WingSway Sway => sway;

    /// <summary>How it goes at present, metres per second of the model, and radians per second.</summary>
    public BodyVelocity Velocity => new(new Vector3(velocity.Sideways, 0f, velocity.Speed), velocity.Turn);

    /// <summary>What its feet do.</summary>
    public ReadOnlySpan<Foot> Feet => planner.Feet;

    /// <summary>How much of its posture for standing it is in, 0..1.</summary>
    public float Raised { get; private set; }

    /// <summary>Whether all feet stand, and none is about to leave the ground.</summary>
    public bool Stands => activity < Settled && Foot.AllStand(planner.Feet);

    /// <summary>Whether it has come to rest: all feet stand, and the trunk is up.</summary>
    public bool IsStill => activity < MinActivity && Raised > 1f - MinActivity && Foot.AllStand(planner.Feet);

    /// <summary>Fastest speed ahead at which it can come down, metres per second of the model.</summary>
    public float RunOut => RunOutFraction * gaits.TopSpeed;

    /// <summary>The sharpest turn at a speed ahead, world metres per second, of a creature so many times as large as its model; radians per second.</summary>
    public float SharpestTurn(float speed, float scale, in MotionSettings settings) => clock.SharpestTurn(speed / scale, VelocityBounds.Of(body, settings with { Gravity = GravityOf(settings, scale) }), GravityOf(settings, scale));

    /// <summary>Asks memory for what it remembers.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch() =>
        MemoryLines.Touch(ref activity) ^ MemoryLines.Touch(ref velocity) ^ MemoryLines.Touch(ref life) ^ MemoryLines.Touch(ref sway) ^ MemoryLines.Touch(ref underfoot)
        ^ clock.Fetch() ^ placer.Fetch() ^ pace.Fetch() ^ planner.Fetch();

    /// <summary>How a foot is.</summary>
    public FootReport Report(int leg) => planner.Feet[leg].Report(body.Legs[leg].Ball);

    /// <inheritdoc/>
    public void Stand(in RootPlace place, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        told = settings.Walking.Gait;
        Stand(place, settings, ground, layer);
        Pose(place, 0f, settings, layer, null, local);
    }

    /// <summary>Poses it as it comes down to the ground at a run: in the stride that goes with its speed, a foot of the hindmost pair about to stand.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="speed">Metres per second ahead, of the model.</param>
    /// <param name="foreseen">The same when it began to reach for the ground, which decides the gait where none was told as it last stood: legs in the air do not change it.</param>
    /// <param name="turn">Radians per second.</param>
    /// <param name="settings">What can be set.</param>
    /// <param name="ground">Where feet find footing.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    /// <param name="local">Receives the pose.</param>
    public void Arrive(in RootPlace place, float speed, float foreseen, float turn, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        MotionSettings own = settings with { Gravity = GravityOf(settings, place.Scale) };
        float unit = own.Gravity * body.LegLength;
        float walking = (float)Math.Sqrt(SlowWalk * unit);
        int before = gait;
        Stand(place, own, ground, layer);
        if (foreseen > ArrivalSpeed * walking)
        {
            float froude = speed * speed / unit;
            velocity = RootVelocity.At(speed, 0f, turn);
            activity = Math.Min((speed / walking) + (0.35f * Math.Abs(turn)), 1f);
            gait = gaits.Choose(before, foreseen * foreseen / unit);
            clock.Restart(told ?? gaits.Steps[gait].Gait, froude, turn < 0f ? Lead.Right : Lead.Left);
            clock.Shape.Track = Math.Max(clock.Shape.Track, ArrivalTrack);
            clock.Phase = 0;
            clock.Slide(0f, velocity, own.Gravity, Math.Min(speed / walking, 1f), 0f, own.Walking.Stride);
            planner.PlaceInStride(new StepContext(place, velocity, clock, own, ground, 0f, 0f, 0f, activity, true, 0f));
            PlaceFeet(place, own, layer);
            placer.Reset(planner.Feet);
        }

        Pose(place, 0f, settings, layer, null, local);
    }

    /// <summary>Poses it with its feet where they are: time passes for nothing but its breath.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="settings">What can be set.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    /// <param name="local">Receives the pose.</param>
    public void Hold(in RootPlace place, float dt, in MotionSettings settings, BodyLayer? layer, in Pose local) => Pose(place, dt, settings, layer, null, local);

    /// <summary>What has legs keep to their pace in poses in which another way of moving has a part.</summary>
    public LegPace NewPace() => new(body, turns);

    /// <summary>Pushes the body; what it intends stays as it is, and its feet step after it.</summary>
    /// <param name="push">Change of its velocity, metres per second of the model, in its own axes.</param>
    /// <param name="turn">Change of its turn, radians per second.</param>
    public void Push(Vector3 push, float turn) => velocity.Push(push.Z, push.X, turn);

    /// <summary>Has who stands be on its way already, metres of the model and radians per second: its feet step after it.</summary>
    public void SetOff(float speed, float turn) => velocity = RootVelocity.At(speed, 0f, turn);

    /// <summary>Puts all feet down at home.</summary>
    private void Stand(in RootPlace placement, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        velocity = default;
        pushed = default;
        ticker = default;
        moving = false;
        going = false;
        activity = 0f;
        sway = default;
        life.Wake();
        restless.Wake();
        acceleration = 0f;
        gait = 0;
        clock.Restart(gaits.Steps[0].Gait, 0f, Lead.Left);
        clock.Slide(0f, velocity, settings.Gravity, 0f, 0f);
        planner.PlaceAll(new StepContext(placement, velocity, clock, settings, ground, 0f, 0f, 0f, 0f, false, 0f));
        PlaceFeet(placement, settings, layer);
        placer.Reset(planner.Feet);
        height.Reset();
        standing = true;
        arrived = true;
    }

    /// <summary>Tells that all feet that stand come down or leave the ground together.</summary>
    /// <param name="kind">Down or up.</param>
    /// <param name="speed">Metres per second of the body.</param>
    /// <param name="force">Of all feet together, weights of the body.</param>
    public void Tell(MotionEventKind kind, float speed, float force) => planner.TellAll(kind, speed, force / FootCount);

    /// <summary>Moves the origin of the world.</summary>
    public void Rebase(Vector3 offset) => planner.Rebase(offset);

    /// <inheritdoc/>
    public void CopyFrom(ILocomotionMode other)
    {
        var mode = (WalkingMode)other;
        clock.CopyFrom(mode.clock);
        planner.CopyFrom(mode.planner);
        placer.CopyFrom(mode.placer);
        pace.CopyFrom(mode.pace);
        (velocity, pushed, acceleration, gait, told, activity, life) = (mode.velocity, mode.pushed, mode.acceleration, mode.gait, mode.told, mode.activity, mode.life);
        (standing, moving, going, arrived, ticker) = (mode.standing, mode.moving, mode.going, mode.arrived, mode.ticker);
        (activityDecay, height, raiseDecay, Sink, Bow, Raised, Facing) = (mode.activityDecay, mode.height, mode.raiseDecay, mode.Sink, mode.Bow, mode.Raised, mode.Facing);
        (underfoot, underfootDecay, sway, restless) = (mode.underfoot, mode.underfootDecay, mode.sway, mode.restless);
    }

    /// <inheritdoc/>
    public RootPlace Update(RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        RootPlace next = Update(place, dt, input, settings, ground, layer);
        Pose(next, dt, settings, layer, ground, local);
        return next;
    }

    /// <inheritdoc/>
    public void Follow(in RootPlace place, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local)
    {
        RootPlace before = pushed.At(place);
        MotionSettings own = settings with { Gravity = GravityOf(settings, goal.Scale), Up = Rotation.Rotate(goal.Rotation, Vector3.UnitY) };
        if (!pushed.Follow(place, goal, dt, VelocityBounds.Of(body, own), own.Gravity, body.LegLength))
        {
            Stand(goal, settings, ground, layer, local);
            return;
        }

        RootPlace at = pushed.At(goal);
        Follow(before, dt, at, own, ground, layer);
        Pose(at, dt, settings, layer, ground, local);
        pushed.Show(goal, body.Subject.Skeleton, body.Body, local);
    }

    private void Begin(in RootPlace placement, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        if (!standing)
        {
            Stand(placement, settings, ground, layer);
        }
    }

    private void Step(in RootPlace placement, float h, float since, float left, in MotionSettings settings, IGround ground, float haste = 1f)
    {
        float unit = settings.Gravity * body.LegLength;
        float speed = (float)Math.Sqrt((velocity.Speed * velocity.Speed) + (velocity.Sideways * velocity.Sideways));
        float walking = (float)Math.Sqrt(SlowWalk * unit);
        if (ticker.Decides)
        {
            moving = speed > 0.05f * walking || Math.Abs(velocity.Turn) > 0.03f || placer.IsBent;
            going = moving || planner.IsUnsettled(placement, activity, clock);
            ChooseGait(speed * speed / unit, settings);
        }

        float wanted = moving ? Math.Min((speed / walking) + (0.35f * Math.Abs(velocity.Turn)), 1f) : 0f;
        activity += (wanted - activity) * activityDecay.Fraction(ActivityRate * h);
        float frequency = clock.Frequency;
        clock.Slide(h, velocity, settings.Gravity, Math.Min(speed / walking, 1f), placer.Climb, settings.Walking.Stride, haste);
        if (going)
        {
            double phase = clock.Phase + (0.5f * (frequency + clock.Frequency) * h);
            clock.Phase = phase - Math.Floor(phase);
        }

        var step = new StepContext(placement, velocity, clock, settings, ground, h, since, left, activity, moving, placer.Climb);
        planner.Advance(step);
        if (ticker.Decides)
        {
            planner.Decide(step);
        }
    }

    private void ChooseGait(float froude, in MotionSettings settings)
    {
        float ahead = velocity.SpeedAfter(Foresight);
        gait = gaits.Choose(gait, ahead > 0f ? Math.Max(froude, ahead * ahead / (settings.Gravity * body.LegLength)) : 0f);
        told = settings.Walking.Gait;
        Gait wanted = told ?? gaits.Steps[gait].Gait;
        if (ReferenceEquals(wanted, clock.Gait))
        {
            return;
        }

        Lead lead = velocity.Turn < 0f ? Lead.Right : Lead.Left;
        if (!going)
        {
            clock.Restart(wanted, froude, lead);
        }
        else
        {
            clock.Change(wanted, settings.Gravity, lead);
        }
    }

    /// <summary>Gravity in the measure of the model by which it goes: that of a creature so many times as large.</summary>
    private static float GravityOf(in MotionSettings settings, float scale) => settings.Gravity / (scale * settings.Walking.Heft);
}
