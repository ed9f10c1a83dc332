using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>A jump to a point until its feet leave the ground: it turns there, crouches, and pushes itself off with its feet where they stand. What follows is a fall.</summary>
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
    private float speed;

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

    /// <summary>How far it jumps.</summary>
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
        return new JumpReach((float)Math.Sqrt(squared), squared / gravity, 0.5f * squared / gravity);
    }

    /// <summary>Begins a jump.</summary>
    /// <param name="to">Where the root is to land, world space.</param>
    /// <param name="place">Where it is.</param>
    /// <param name="settings">Up and gravity.</param>
    public JumpResult Begin(Vector3 to, in RootPlace place, in MotionSettings settings)
    {
        JumpReach reach = Reach(place.Scale, settings.Gravity);
        float height = Vec.Dot(to - place.Position, settings.Up);
        float distance = Vec.Length(Vec.Reject(to - place.Position, settings.Up));
        float min = settings.Gravity * (height + (float)Math.Sqrt((height * height) + (distance * distance)));
        if (reach.Speed == 0f)
        {
            return JumpResult.TooHeavy;
        }

        if (min > reach.Speed * reach.Speed)
        {
            return JumpResult.OutOfReach;
        }

        // At the angle of the least speed, but no lower than a jump is.
        float velocity = Math.Min(reach.Speed, Spare * (float)Math.Sqrt(min));
        float slope = distance > 1e-4f ? ((velocity * velocity) + (float)Math.Sqrt(Math.Max((velocity * velocity * velocity * velocity) - (settings.Gravity * ((settings.Gravity * distance * distance) + (2f * height * velocity * velocity))), 0f))) / (settings.Gravity * distance) : 1e4f;
        float lowest = (float)Math.Sqrt(2f * settings.Gravity * (Math.Max(height, 0f) + (MinHeight * body.LegLength * place.Scale)));
        upward = Math.Max(velocity * slope / (float)Math.Sqrt(1f + (slope * slope)), Math.Min(lowest, reach.Speed));
        target = to;
        elapsed = 0f;
        speed = legs.Speed;
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
        float tau = (float)Math.Sqrt(body.LegLength * place.Scale / settings.Gravity);
        float depth = Crouch * profile.CrouchDepth;
        float stretch = Stretched * profile.CrouchDepth;
        float push = 2f * (depth + stretch) * place.Scale / upward;
        float crouch = CrouchTime * tau;
        elapsed += dt;
        off = elapsed >= crouch + push;
        float angle = AngleTo(place, settings.Up);
        if (elapsed < crouch)
        {
            legs.Sink = depth * Scalar.Smooth(elapsed / crouch);
            float rate = Scalar.Clamp(angle / Math.Max(crouch - elapsed, dt), -TurnRate, TurnRate);
            return legs.Update(place, dt, new MotionInput(Math.Max(speed, 0f) * place.Scale, rate), settings, ground, layer, local);
        }

        float u = Math.Min((elapsed - crouch) / push, 1f);
        legs.Sink = depth - ((depth + stretch) * u * u);
        Vector3 ahead = Flight(place, settings, out float seconds);
        Vector3 before = Rotation.Rotate(place.Rotation, legs.Velocity.Linear) * place.Scale;
        Vector3 now = Vec.Lerp(before, ahead, u);
        place = new RootPlace(place.Position + (now * Math.Min(dt, push)), place.Rotation, place.Scale);
        legs.Hold(place, dt, settings, layer, local);
        Velocity = ahead + (settings.Up * upward);
        Turn = angle / Math.Max(seconds, 0.05f);
        return place;
    }

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(Leap other) =>
        (target, elapsed, upward, speed, Velocity, Turn) = (other.target, other.elapsed, other.upward, other.speed, other.Velocity, other.Turn);

    /// <summary>Level velocity of a flight from here to the target.</summary>
    private Vector3 Flight(in RootPlace place, in MotionSettings settings, out float seconds)
    {
        Vector3 way = target - place.Position;
        float height = Vec.Dot(way, settings.Up);
        seconds = (upward + (float)Math.Sqrt(Math.Max((upward * upward) - (2f * settings.Gravity * height), 0f))) / settings.Gravity;
        return Vec.Reject(way, settings.Up) / Math.Max(seconds, 1e-3f);
    }

    /// <summary>Angle to the left to which the target is.</summary>
    private float AngleTo(in RootPlace place, Vector3 up)
    {
        Vector3 way = place.ToModel(target);
        return Vec.Length(Vec.Reject(target - place.Position, up)) < 0.1f * body.LegLength * place.Scale ? 0f : (float)PortableMath.Atan2(way.X, way.Z);
    }
}
