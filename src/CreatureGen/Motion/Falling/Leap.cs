using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// A jump to a point until its feet leave the ground: it turns there, crouches, and pushes itself off with its feet where they stand. Out of a run its feet go on stepping (<see cref="RunningLeap"/>). What follows is a fall.
/// </summary>
/// <remarks>The least speed to a point d ahead and h up is v² = g(h + √(h² + d²)). Mean force of the push in weights of the body 3.6 (M/30 kg)^−0.18, a law that fits its look, over a way of 0.45 ℓ.</remarks>
internal sealed class Leap
{
    /// <summary>Force of the push, weights of the body, of an animal of the usual mass, and its bounds.</summary>
    private const float PushForce = 3.6f;
    private const float UsualMass = 30f;
    private const double ForcePower = -0.18;
    private const float MinForce = 1.15f;
    private const float GreatestForce = 4.5f;

    /// <summary>Way of the push, leg lengths.</summary>
    private const float PushWay = 0.45f;

    /// <summary>Kilograms above which nobody jumps.</summary>
    private const float HeaviestJumper = 3000f;

    /// <summary>Part of the speed of a fall that its legs take up with which it takes off at most.</summary>
    private const float Landable = 0.9f;

    /// <summary>Speed to the target from which on it jumps out of a run, √(gℓ).</summary>
    private const float Running = 0.3f;

    /// <summary>How quickly it turns to its target at most, radians per second.</summary>
    private const float TurnRate = 2.5f;

    /// <summary>Factor on the least speed to a point: it comes down from above.</summary>
    private const float Spare = 1.03f;

    private readonly LeggedBody body;
    private readonly FallProfile profile;
    private readonly WalkingMode legs;
    private Vector3 target;
    private float elapsed;
    private LeapPlan plan;

    public Leap(LeggedBody body, FallProfile profile, WalkingMode legs)
    {
        this.body = body;
        this.profile = profile;
        this.legs = legs;
    }

    /// <summary>Velocity at the take-off, world m/s.</summary>
    public Vector3 Velocity { get; private set; }

    /// <summary>How it turns in the air until it faces the way that it flies.</summary>
    public AirTurn Turn { get; private set; }

    /// <summary>How far it jumps: out of a run by the way on which it crouches as well, and as far as that carries it.</summary>
    /// <param name="scale">World metres per model metre.</param>
    /// <param name="gravity">World m/s².</param>
    public JumpReach Reach(float scale, float gravity)
    {
        float mass = profile.Mass * scale * scale * scale;
        if (mass > HeaviestJumper)
        {
            return default;
        }

        float force = (float)Scalar.Clamp(PushForce * PortableMath.Pow(mass / UsualMass, ForcePower), MinForce, GreatestForce);
        float squared = 2f * gravity * (force - 1f) * PushWay * body.LegLength * scale;
        float borne = Landable * profile.BorneSpeed;
        squared = Math.Min(squared, borne * borne * gravity * body.LegLength * scale);
        float fastest = (float)Math.Sqrt(squared);
        float ahead = Math.Max(legs.Speed, 0f) * scale;
        float length = squared / gravity;
        if (IsRun(ahead, scale, gravity))
        {
            LeapTiming timing = Timing(scale, gravity);
            length = Math.Max(length, ahead * timing.FlightSeconds(fastest * (float)Math.Sqrt(0.5), 0f)) + (ahead * timing.WindUpSeconds(RunningLeap.UsualCrouch, fastest));
        }

        return new JumpReach(fastest, length, 0.5f * squared / gravity);
    }

    /// <summary>Begins a jump.</summary>
    /// <param name="to">Where the root is to land, world space.</param>
    /// <param name="place">Where it is.</param>
    /// <param name="settings">Up and gravity.</param>
    public JumpResult Begin(Vector3 to, in RootPlace place, in MotionSettings settings)
    {
        JumpReach reach = Reach(place.Scale, settings.Gravity);
        if (reach.Speed == 0f)
        {
            return JumpResult.TooHeavy;
        }

        Vector3 way = to - place.Position;
        float height = Vec.Dot(way, settings.Up);
        Vector3 level = Vec.Reject(way, settings.Up);
        float distance = Vec.Length(level);
        float towards = Math.Max(legs.Speed * place.Scale * Vec.Dot(Rotation.Rotate(place.Rotation, Vector3.UnitZ), Vec.Normalize(level, Vector3.Zero)), 0f);
        LeapTiming timing = Timing(place.Scale, settings.Gravity);
        float runUp = 0f;
        var usual = new LeapPlan(0f, 0f, 1f);
        if (IsRun(towards, place.Scale, settings.Gravity))
        {
            var run = new RunningLeap(timing, legs, settings, place.Scale, towards, height);
            if (distance < run.Nearest)
            {
                return JumpResult.OutOfReach;
            }

            if (run.Over(distance, reach.Speed) is { } carried)
            {
                (target, elapsed, plan) = (to, 0f, carried);
                return JumpResult.Begun;
            }

            // The push has to add to the run.
            usual = new LeapPlan(0f, towards, RunningLeap.UsualCrouch);
            runUp = towards * timing.WindUpSeconds(usual.Crouch, reach.Speed);
        }

        float flight = Math.Max(distance - runUp, 0f);
        float min = settings.Gravity * (height + (float)Math.Sqrt((height * height) + (flight * flight)));
        if (min > reach.Speed * reach.Speed)
        {
            return JumpResult.OutOfReach;
        }

        // At the angle of the least speed, but no lower than a jump is.
        float velocity = Math.Min(reach.Speed, Spare * (float)Math.Sqrt(min));
        float squared = velocity * velocity;
        float slope = flight > 1e-4f ? (squared + (float)Math.Sqrt(Math.Max((squared * squared) - (settings.Gravity * ((settings.Gravity * flight * flight) + (2f * height * squared))), 0f))) / (settings.Gravity * flight) : 1e4f;
        float upward = Math.Max(velocity * slope / (float)Math.Sqrt(1f + (slope * slope)), Math.Min(timing.Lowest(height), reach.Speed));
        (target, elapsed, plan) = (to, 0f, usual with { Upward = upward });
        return JumpResult.Begun;
    }

    /// <summary>Crouches and pushes.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="settings">Up and gravity.</param>
    /// <param name="ground">What it stands on.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    /// <param name="local">Receives the pose.</param>
    /// <param name="off">Whether its feet leave the ground.</param>
    /// <returns>Where the root is then.</returns>
    public RootPlace Advance(RootPlace place, float dt, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local, out bool off)
    {
        LeapTiming timing = Timing(place.Scale, settings.Gravity);
        float crouch = timing.CrouchSeconds(plan.Crouch);
        float depth = timing.DepthOf(plan.Crouch) / place.Scale;
        float push = timing.PushSeconds(plan.Crouch, plan.Upward);
        float left = crouch + push - elapsed;
        elapsed += dt;
        off = dt >= left;
        float angle = AngleTo(place, settings.Up);
        if (elapsed < crouch)
        {
            legs.Sink = depth * Scalar.Smooth(elapsed / crouch);
            return legs.Update(place, dt, new MotionInput(plan.Pace, RateOf(angle, crouch - elapsed, dt)), settings, ground, layer, local);
        }

        float u = Math.Min((elapsed - crouch) / push, 1f);
        legs.Sink = depth - (timing.PushOf(plan.Crouch) / place.Scale * u * u);
        Vector3 ahead = Flight(place, settings, timing, out float seconds);
        Vector3 before = Rotation.Rotate(place.Rotation, legs.Velocity.Linear) * place.Scale;
        if (plan.Crouch < 1f)
        {
            // What the push adds to the run comes evenly: D = ½(v + v′)t + v′T until it lands, where it goes at v now and flies at v′.
            Vector3 missing = ((ahead * seconds) - (before * (seconds + left))) / (seconds + (0.5f * left));
            legs.Push(Rotation.Rotate(Rotation.Inverse(place.Rotation), missing * Math.Min(dt / left, 1f) / place.Scale), 0f);
            place = legs.Update(place, dt, new MotionInput(plan.Pace, RateOf(angle, push, dt)), settings, ground, layer, local);
        }
        else
        {
            Vector3 now = Vec.Lerp(before, ahead, u);
            place = new RootPlace(place.Position + (now * Math.Min(dt, push)), place.Rotation, place.Scale);
            legs.Hold(place, dt, settings, layer, local);
        }

        Velocity = ahead + (settings.Up * plan.Upward);
        Turn = off ? AirTurn.To(plan.Crouch < 1f ? legs.Velocity.YawRate : 0f, AngleTo(place, settings.Up), seconds) : default;
        return place;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Leap other) =>
        (target, elapsed, plan, Velocity, Turn) = (other.target, other.elapsed, other.plan, other.Velocity, other.Turn);

    /// <summary>The yaw rate that turns it by an angle in a time.</summary>
    private static float RateOf(float angle, float seconds, float dt) => Scalar.Clamp(angle / Math.Max(seconds, dt), -TurnRate, TurnRate);

    private LeapTiming Timing(float scale, float gravity) => new(body.LegLength * scale, profile.CrouchDepth * scale, gravity);

    private bool IsRun(float speed, float scale, float gravity) => speed > Running * (float)Math.Sqrt(gravity * body.LegLength * scale);

    /// <summary>Level velocity of a flight from here to the target.</summary>
    private Vector3 Flight(in RootPlace place, in MotionSettings settings, in LeapTiming timing, out float seconds)
    {
        Vector3 way = target - place.Position;
        float height = Vec.Dot(way, settings.Up);
        seconds = timing.FlightSeconds(plan.Upward, height);
        return Vec.Reject(way, settings.Up) / Math.Max(seconds, 1e-3f);
    }

    /// <summary>Angle to the left to which the target is.</summary>
    private float AngleTo(in RootPlace place, Vector3 up)
    {
        Vector3 way = place.ToModel(target);
        return Vec.Length(Vec.Reject(target - place.Position, up)) < 0.1f * body.LegLength * place.Scale ? 0f : (float)PortableMath.Atan2(way.X, way.Z);
    }
}
