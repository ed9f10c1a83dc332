using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// A jump to a point until its feet leave the ground: it turns there, crouches, and pushes itself off with its feet where they stand. Out of a run its feet go on stepping, it crouches half as long, and it slows down to
/// the speed at which it flies. What follows is a fall.
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

    /// <summary>Seconds of the crouch, τ = √(ℓ/g); its depth, and how far legs are stretched at the end, parts of the deepest crouch.</summary>
    private const float CrouchTime = 1.6f;
    private const float Crouch = 0.8f;
    private const float Stretched = 0.08f;

    /// <summary>Speed to the target from which on it jumps out of a run, √(gℓ), and the part of a crouch that this takes.</summary>
    private const float Running = 0.3f;
    private const float RunningCrouch = 0.5f;

    /// <summary>How often the speed upwards of a jump out of a run is halved in on.</summary>
    private const int Halvings = 16;

    /// <summary>How quickly it turns to its target at most, radians per second.</summary>
    private const float TurnRate = 2.5f;

    /// <summary>Factor on the least speed to a point: it comes down from above.</summary>
    private const float Spare = 1.03f;

    /// <summary>Least height of a jump, leg lengths.</summary>
    private const float MinHeight = 0.12f;

    private readonly LeggedBody body;
    private readonly FallProfile profile;
    private readonly WalkingMode legs;
    private Vector3 target;
    private float elapsed;
    private float upward;
    private float pace;
    private float part = 1f;

    public Leap(LeggedBody body, FallProfile profile, WalkingMode legs)
    {
        this.body = body;
        this.profile = profile;
        this.legs = legs;
    }

    /// <summary>Velocity at the take-off, world m/s.</summary>
    public Vector3 Velocity { get; private set; }

    /// <summary>Turn that is left to be made in the air, radians per second.</summary>
    public float Turn { get; private set; }

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
            length = Math.Max(length, ahead * FlightSeconds(fastest * (float)Math.Sqrt(0.5), 0f, gravity)) + (ahead * WindUpSeconds(RunningCrouch, fastest, scale, gravity));
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
        bool runs = IsRun(towards, place.Scale, settings.Gravity);
        if (runs && Carried(distance, height, towards, reach.Speed, place.Scale, settings.Gravity) is { } carried)
        {
            (target, elapsed, upward, pace, part) = (to, 0f, carried.Upward, carried.Pace, RunningCrouch);
            return JumpResult.Begun;
        }

        float runUp = runs ? towards * WindUpSeconds(RunningCrouch, reach.Speed, place.Scale, settings.Gravity) : 0f;
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
        upward = Math.Max(velocity * slope / (float)Math.Sqrt(1f + (slope * slope)), Math.Min(Lowest(height, place.Scale, settings.Gravity), reach.Speed));
        (target, elapsed, pace, part) = (to, 0f, runs ? towards : 0f, runs ? RunningCrouch : 1f);
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
        float crouch = part * CrouchTime * Tau(place.Scale, settings.Gravity);
        float depth = part * Crouch * profile.CrouchDepth;
        float push = PushSeconds(part, upward, place.Scale);
        elapsed += dt;
        off = elapsed >= crouch + push;
        float angle = AngleTo(place, settings.Up);
        if (elapsed < crouch)
        {
            legs.Sink = depth * Scalar.Smooth(elapsed / crouch);
            return legs.Update(place, dt, new MotionInput(pace, RateOf(angle, crouch - elapsed, dt)), settings, ground, layer, local);
        }

        float u = Math.Min((elapsed - crouch) / push, 1f);
        legs.Sink = depth - ((depth + (Stretched * profile.CrouchDepth)) * u * u);
        Vector3 ahead = Flight(place, settings, out float seconds);
        if (part < 1f)
        {
            float even = Vec.Length(ahead) * seconds / (seconds + (push * (1f - u)));
            place = legs.Update(place, dt, new MotionInput(even, RateOf(angle, push, dt)), settings, ground, layer, local);
        }
        else
        {
            Vector3 before = Rotation.Rotate(place.Rotation, legs.Velocity.Linear) * place.Scale;
            Vector3 now = Vec.Lerp(before, ahead, u);
            place = new RootPlace(place.Position + (now * Math.Min(dt, push)), place.Rotation, place.Scale);
            legs.Hold(place, dt, settings, layer, local);
        }

        Velocity = ahead + (settings.Up * upward);
        Turn = angle / Math.Max(seconds, 0.05f);
        return place;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Leap other) =>
        (target, elapsed, upward, pace, part, Velocity, Turn) = (other.target, other.elapsed, other.upward, other.pace, other.part, other.Velocity, other.Turn);

    /// <summary>The yaw rate that turns it by an angle in a time.</summary>
    private static float RateOf(float angle, float seconds, float dt) => Scalar.Clamp(angle / Math.Max(seconds, dt), -TurnRate, TurnRate);

    /// <summary>Seconds from the take-off until it is as high as its target, on the way down.</summary>
    private static float FlightSeconds(float upward, float height, float gravity) => (upward + (float)Math.Sqrt(Math.Max((upward * upward) - (2f * gravity * height), 0f))) / gravity;

    /// <summary>A jump that a run carries to its target: as low as it may be at the speed that it has, and slower where the target is nearer. None where that is too far for it.</summary>
    private (float Upward, float Pace)? Carried(float distance, float height, float towards, float fastest, float scale, float gravity)
    {
        float low = Lowest(height, scale, gravity);
        float high = fastest;
        if (low > high || PaceOf(high) > towards)
        {
            return null;
        }

        if (PaceOf(low) > towards)
        {
            for (int i = 0; i < Halvings; i++)
            {
                float middle = 0.5f * (low + high);
                (low, high) = PaceOf(middle) > towards ? (middle, high) : (low, middle);
            }

            low = high;
        }

        return (low, Math.Max(PaceOf(low), 0f));

        // It goes over to its pace evenly while it crouches and pushes, and keeps that in the air.
        float PaceOf(float speed)
        {
            float windUp = WindUpSeconds(RunningCrouch, speed, scale, gravity);
            return (distance - (0.5f * towards * windUp)) / ((0.5f * windUp) + FlightSeconds(speed, height, gravity));
        }
    }

    /// <summary>Least speed upwards of a jump to a height, world m/s.</summary>
    private float Lowest(float height, float scale, float gravity) => (float)Math.Sqrt(2f * gravity * (Math.Max(height, 0f) + (MinHeight * body.LegLength * scale)));

    /// <summary>Time from the order until its feet leave the ground, with a part of a whole crouch.</summary>
    private float WindUpSeconds(float crouch, float speed, float scale, float gravity) => (crouch * CrouchTime * Tau(scale, gravity)) + PushSeconds(crouch, speed, scale);

    /// <summary>Time of a push out of a part of a whole crouch that ends at a speed upwards.</summary>
    private float PushSeconds(float crouch, float speed, float scale) => 2f * ((crouch * Crouch) + Stretched) * profile.CrouchDepth * scale / speed;

    private float Tau(float scale, float gravity) => (float)Math.Sqrt(body.LegLength * scale / gravity);

    private bool IsRun(float speed, float scale, float gravity) => speed > Running * (float)Math.Sqrt(gravity * body.LegLength * scale);

    /// <summary>Level velocity of a flight from here to the target.</summary>
    private Vector3 Flight(in RootPlace place, in MotionSettings settings, out float seconds)
    {
        Vector3 way = target - place.Position;
        float height = Vec.Dot(way, settings.Up);
        seconds = FlightSeconds(upward, height, settings.Gravity);
        return Vec.Reject(way, settings.Up) / Math.Max(seconds, 1e-3f);
    }

    /// <summary>Angle to the left to which the target is.</summary>
    private float AngleTo(in RootPlace place, Vector3 up)
    {
        Vector3 way = place.ToModel(target);
        return Vec.Length(Vec.Reject(target - place.Position, up)) < 0.1f * body.LegLength * place.Scale ? 0f : (float)PortableMath.Atan2(way.X, way.Z);
    }
}
