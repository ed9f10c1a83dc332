using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Floating;

/// <summary>A body on legs in water too deep to stand in: it floats at the surface, bobs, and paddles where it is asked to go.</summary>
internal sealed class Paddling
{
    /// <summary>Speed of a cruise, √(gℓ), and beats of a leg in τ = √(ℓ/g) and a second at most.</summary>
    private const double CruiseFroude = 0.42;
    private const double CruiseBeats = 0.35;
    private const double QuickestBeat = 10;

    /// <summary>The fastest ahead and back, cruises; the least part of tempo and width that treading water takes.</summary>
    private const double Fastest = 1.2;
    private const double Backing = 0.4;
    private const double TreadTempo = 0.6;
    private const float TreadWidth = 0.55f;

    /// <summary>Cruises by which one beat makes it faster from rest, how much of that brakes, and beats in which thrust comes up.</summary>
    private const double PushOff = 0.8;
    private const double BrakingFraction = 0.6;
    private const double PushRise = 0.35;

    /// <summary>Radians that it turns on the spot with a beat at most, and how quickly it comes to turn, beats.</summary>
    private const double TurnPerBeat = 0.6;
    private const double TurnResponse = 2;

    /// <summary>How quickly it bobs up, 1/τ, and how soon that dies away; fastest rise from the deep, cruises.</summary>
    private const float BobRate = 1.5f;
    private const float BobDamping = 0.6f;
    private const float FastestRise = 2f;

    /// <summary>How quickly tempo and width follow, beats.</summary>
    private const double Response = 2;

    /// <summary>Depth of the bed below that at which it floats in which legs begin to reach for it, leg lengths, and how quickly they do, 1/τ.</summary>
    private const float ReachDepth = 0.4f;
    private const double ReachRate = 5;

    private readonly FloatProfile profile;
    private readonly LeggedBody body;
    private readonly PaddlePose pose;
    private Momentum ahead;
    private CriticallyDampedSpring turn;
    private CriticallyDampedSpring effort;
    private CriticallyDampedSpring reach;
    private double phase;
    private float sinking;

    public Paddling(FloatProfile profile)
    {
        this.profile = profile;
        body = profile.Body;
        pose = new PaddlePose(profile);
    }

    /// <summary>Metres per second ahead, of the model.</summary>
    public float Speed => (float)ahead.Speed;

    /// <summary>Radians per second.</summary>
    public float Turn => (float)turn.Value;

    /// <summary>Place in the cycle of the legs, 0..1.</summary>
    public float Phase => (float)phase;

    /// <summary>Cycles per second.</summary>
    public float Frequency { get; private set; }

    /// <summary>Begins to float.</summary>
    /// <param name="velocity">Of the model, in its own axes.</param>
    /// <param name="yawRate">Radians per second.</param>
    public void Begin(Vector3 velocity, float yawRate)
    {
        ahead = Momentum.At(velocity.Z);
        turn = CriticallyDampedSpring.At(yawRate);
        effort = CriticallyDampedSpring.At(1);
        reach = CriticallyDampedSpring.At(1);
        sinking = -velocity.Y;
        phase = 0;
    }

    /// <summary>Moves on.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="input">What it is to do.</param>
    /// <param name="settings">Gravity and up.</param>
    /// <param name="ground">The water and its bed.</param>
    public RootPlace Advance(in RootPlace place, float dt, in MotionInput input, in MotionSettings settings, IWaterGround ground)
    {
        float scale = place.Scale;
        double tau = Tau(scale, settings.Gravity);
        double cruise = CruiseOf(body, tau);
        double goal = Scalar.Clamp(input.Speed / scale, -Backing * cruise, Fastest * cruise);
        double way = ahead.Step(goal, Limits(cruise, tau), dt);
        double sharpest = TurnPerBeat * BeatOf(tau);
        double turned = turn.Step(Scalar.Clamp(input.YawRate, -sharpest, sharpest), TurnResponse * BeatOf(tau), dt);
        Work(goal / cruise, Math.Abs(input.YawRate) / sharpest, tau, dt);
        Quaternion rotation = UnitRotation.Upright(Rotation.Multiply(place.Rotation, AxisRotation.Yaw((float)turned)), settings.Up);
        float risen = Bob(ground.DepthAt(place.Position) / scale, (float)tau, (float)cruise, dt);
        Vector3 to = place.Position + (Rotation.Rotate(rotation, Vector3.UnitZ) * (float)(way * scale)) + (settings.Up * (risen * scale));
        return new RootPlace(to, rotation, scale);
    }

    /// <summary>Has its legs reach for the ground that comes up under them.</summary>
    /// <param name="bed">Depth of the bed, metres of the model; infinite where it is far.</param>
    /// <param name="scale">World metres per model metre.</param>
    /// <param name="gravity">World m/s².</param>
    /// <param name="dt">Seconds.</param>
    public void Reach(float bed, float scale, float gravity, float dt) =>
        reach.Step(1 - Scalar.Smooth(Math.Min((bed - profile.Draught) / (ReachDepth * body.LegLength), 1f)), ReachRate / Tau(scale, gravity), dt);

    /// <summary>Goes on as the game moved it.</summary>
    /// <param name="velocity">Of the model, in its own axes.</param>
    /// <param name="yawRate">Radians per second.</param>
    /// <param name="scale">World metres per model metre.</param>
    /// <param name="gravity">World m/s².</param>
    /// <param name="dt">Seconds.</param>
    public void Follow(Vector3 velocity, float yawRate, float scale, float gravity, float dt)
    {
        double tau = Tau(scale, gravity);
        ahead = Momentum.At(velocity.Z);
        turn.Step(yawRate, TurnResponse * BeatOf(tau), dt);
        sinking = 0f;
        Work(velocity.Z / CruiseOf(body, tau), Math.Abs(yawRate) / (TurnPerBeat * BeatOf(tau)), tau, dt);
    }

    /// <summary>Writes trunk, neck and legs.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="settings">Gravity and up.</param>
    /// <param name="bed">What is under the water.</param>
    /// <param name="local">Pose in the parents' space of the body as it stands; receives the joints that move.</param>
    public void Pose(in RootPlace place, in MotionSettings settings, IGround bed, in Pose local)
    {
        float sharpest = (float)(TurnPerBeat * BeatOf(Tau(place.Scale, settings.Gravity)));
        var stroke = new PaddleStroke
        {
            Phase = phase,
            Width = TreadWidth + ((1f - TreadWidth) * (float)effort.Value),
            Steer = Scalar.Clamp((float)turn.Value / sharpest, -1f, 1f),
            Reach = (float)reach.Value,
        };
        pose.Write(stroke, place, settings.Up, bed, local);
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Paddling other) => (ahead, turn, effort, reach, phase, sinking, Frequency) = (other.ahead, other.turn, other.effort, other.reach, other.phase, other.sinking, other.Frequency);

    /// <summary>Speed of a cruise, metres of the model per second.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="tau">√(ℓ/g) of the model, seconds.</param>
    public static double CruiseOf(LeggedBody body, double tau) => CruiseFroude * body.LegLength / tau;

    /// <summary>√(ℓ/g) of the model, seconds.</summary>
    public double Tau(float scale, float gravity) => Math.Sqrt(body.LegLength * scale / gravity);

    private static double BeatOf(double tau) => Math.Min(CruiseBeats / tau, QuickestBeat);

    /// <summary>Thrust and drag that are even where it goes its fastest.</summary>
    private static MomentumLimits Limits(double cruise, double tau)
    {
        double beat = CruiseBeats / tau;
        double thrust = PushOff * cruise * beat;
        double max = Fastest * cruise;
        return new MomentumLimits(1.1 * thrust, BrakingFraction * thrust, thrust / (max * max), thrust * beat / PushRise);
    }

    /// <summary>Has its legs go as hard as is asked of it.</summary>
    private void Work(double cruises, double turns, double tau, float dt)
    {
        double beat = BeatOf(tau);
        double hard = Math.Min(Math.Max(Math.Abs(cruises), turns), 1);
        effort.Step(hard, Response * beat, dt);
        double tempo = beat * (TreadTempo + ((1 - TreadTempo) * effort.Value));
        phase += (cruises < 0 ? -tempo : tempo) * dt;
        phase -= Math.Floor(phase);
        Frequency = (float)tempo;
    }

    /// <summary>Lets water carry it.</summary>
    /// <returns>How far it rises, metres of the model.</returns>
    private float Bob(float depth, float tau, float cruise, float dt)
    {
        if (!(depth > float.MinValue))
        {
            return 0f;
        }

        float away = depth - profile.Draught;
        var spring = new DampedSpring(BobRate / tau, BobDamping, dt);
        float after = (away * spring.PlaceOfPlace) + (sinking * spring.PlaceOfVelocity);
        sinking = (away * spring.VelocityOfPlace) + (sinking * spring.VelocityOfVelocity);
        float fastest = FastestRise * cruise;
        if (sinking < -fastest)
        {
            sinking = -fastest;
            after = Math.Max(after, away - (fastest * dt));
        }

        return away - after;
    }
}
