using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Motion.Walking;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Falling;

/// <summary>
/// A walker without ground under it: its body flies as a stone does, its legs are drawn up, tread the air where it takes long, and reach for the ground before it comes; then they take up the fall as a damped spring.
/// </summary>
/// <remarks>Landing: y″ + 2ζωy′ + ω²y = 0 from y′ = −v, which lets the body down by at most 0.42 v/ω at ζ = 0.8; ω is as soft as the depth of the crouch allows, and no harder than the legs bear.</remarks>
internal sealed class FreeFall
{
    /// <summary>Longest step in which contact with the ground is looked for, seconds.</summary>
    private const float LongestStep = 1f / 60f;

    /// <summary>How far legs are drawn up as it falls, and stretched as they reach for the ground, parts of the depth of a crouch.</summary>
    private const float Drawn = 0.45f;
    private const float Reaching = 0.06f;

    /// <summary>How long before the ground comes they reach for it, and how quickly they do either, τ = √(ℓ/g).</summary>
    private const float ReachTime = 1.1f;
    private const float LegRate = 4f;

    /// <summary>The softest landing, 1/τ, and the damping of all.</summary>
    private const float SoftestBraking = 2.2f;
    private const float DampingRatio = 0.8f;

    /// <summary>Depth, part of that of a crouch, and rate, the same in τ, below which a landing is over.</summary>
    private const float Over = 0.02f;

    /// <summary>How far above and below its feet ground counts that they reach for, leg lengths.</summary>
    private const float StepHeight = 0.6f;

    /// <summary>How far above its root it may be that a falling body meets ground, leg lengths.</summary>
    private const float HigherFooting = 0.2f;

    /// <summary>How far down the ground is looked for, leg lengths.</summary>
    private const float Lookout = 60f;

    /// <summary>How quickly the pose goes over to that of falling, τ.</summary>
    private const float FadeTime = 1.5f;

    private readonly LeggedBody body;
    private readonly FallProfile profile;
    private readonly WalkingMode legs;
    private readonly FallingFloor floor = new();
    private readonly PoseFade fade;
    private readonly LocalPose last;
    private readonly Flail flail;
    private CriticallyDampedSpring sink;
    private Vector3 velocity;
    private AirTurn turn;
    private float sinkRate;
    private float braking;
    private bool astray;

    public FreeFall(LeggedBody body, FallProfile profile, WalkingMode legs)
    {
        this.body = body;
        this.profile = profile;
        this.legs = legs;
        fade = new PoseFade(body.Skeleton);
        last = new LocalPose(body.Skeleton);
        flail = new Flail(body);
    }

    /// <summary>Velocity of the body, world m/s.</summary>
    public Vector3 Velocity => velocity;

    /// <summary>Begins to fall.</summary>
    /// <param name="shown">The pose shown last, in the parents' space.</param>
    /// <param name="start">Velocity of the body, world m/s.</param>
    /// <param name="yaw">How it turns.</param>
    public void Begin(in Pose shown, Vector3 start, in AirTurn yaw)
    {
        velocity = start;
        turn = yaw;
        sink = new CriticallyDampedSpring { Value = legs.Sink, Rate = 0 };
        fade.Keep(shown);
        last.Take(shown);
        flail.Begin();
        astray = false;
    }

    /// <summary>Changes its velocity, world m/s.</summary>
    public void Push(Vector3 change)
    {
        velocity += change;
        astray = true;
    }

    /// <summary>Falls on.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="settings">Gravity and up.</param>
    /// <param name="ground">What it may fall on.</param>
    /// <param name="layer">What an act asks of trunk and feet.</param>
    /// <param name="local">Receives the pose.</param>
    /// <param name="impact">Speed at which it came down, m/s; 0 while it falls.</param>
    /// <returns>Where the root is then.</returns>
    public RootPlace Fall(RootPlace place, float dt, in MotionSettings settings, IGround ground, BodyLayer? layer, in Pose local, out float impact)
    {
        impact = 0f;
        Vector3 up = settings.Up;
        float gravity = settings.Gravity / place.Scale;
        float tau = (float)Math.Sqrt(body.LegLength / gravity);
        float left = dt;
        while (left > 0f && impact == 0f)
        {
            float h = Math.Min(left, LongestStep);
            left -= h;
            double before = sink.Value;
            bool reaches = Reaches(place, tau, settings, ground);
            sink.Step((reaches ? -Reaching : Drawn) * profile.CrouchDepth, LegRate / tau, h);
            flail.Step(reaches, h, tau);

            // The body flies the parabola: what the legs draw up the root rises.
            Vector3 way = (velocity - (up * (0.5f * settings.Gravity * h))) * h;
            way += up * ((float)(sink.Value - before) * place.Scale);
            velocity -= up * (settings.Gravity * h);
            Quaternion rotation = UnitRotation.Renormalize(Rotation.Multiply(place.Rotation, AxisRotation.Yaw(turn.Step(h))));
            Vector3 next = place.Position + way;
            if (TryLand(place, next, up, ground, out Vector3 landed))
            {
                impact = Math.Max(-Vec.Dot(velocity, up), 1e-3f);
                next = landed;
            }

            place = new RootPlace(next, rotation, place.Scale);
        }

        bool down = impact > 0f;
        float step = StepHeight * body.LegLength * place.Scale;
        if (down)
        {
            floor.Meet(place.Position, up, ground, step);
        }
        else
        {
            floor.Lay(place.Position, up, ground, step);
        }

        // As it will face when it comes down: turning, its legs would change from standing to going in the air.
        Quaternion facing = down ? place.Rotation : Rotation.Multiply(place.Rotation, AxisRotation.Yaw(turn.Left));
        Vector3 ahead = Rotation.Rotate(Rotation.Inverse(facing), velocity) / place.Scale;
        legs.Sink = (float)sink.Value;
        legs.Bow = 0f;
        legs.Arrive(place, ahead.Z, ahead.Z, turn.Spin, settings, floor, flail.On(layer, tau), local);
        if (astray)
        {
            // Legs that fall at another speed, or come down on what there is beside them, take another pose, and are not there at once.
            fade.Keep(last.Pose);
            astray = false;
        }

        fade.Apply(dt, FadeTime * tau, local);
        last.Take(local);
        if (down)
        {
            // From here on the legs brake: the body goes on as it came.
            sinkRate = impact / place.Scale;
            braking = Math.Max(SoftestBraking / tau, sinkRate * FallProfile.DepthOfLanding / (FallProfile.DeepestLanding * profile.CrouchDepth));
        }

        return place;
    }

    /// <summary>Greatest force of a landing on all feet together, weights of the body.</summary>
    /// <param name="impact">World m/s.</param>
    /// <param name="gravity">World m/s².</param>
    public float ForceOf(float impact, float gravity) => 1f + (2f * DampingRatio * impact * braking / gravity);

    /// <summary>Lets the legs take up the fall; the pose is the walk's, which is driven afterwards.</summary>
    /// <param name="dt">Seconds.</param>
    /// <returns>Whether it is over.</returns>
    public bool Absorb(float dt)
    {
        float depth = legs.Sink;
        var spring = new DampedSpring(braking, DampingRatio, dt);
        (depth, sinkRate) = ((depth * spring.PlaceOfPlace) + (sinkRate * spring.PlaceOfVelocity), (depth * spring.VelocityOfPlace) + (sinkRate * spring.VelocityOfVelocity));
        bool over = Math.Abs(depth) < Over * profile.CrouchDepth && Math.Abs(sinkRate) < Over * profile.CrouchDepth * braking;
        legs.Sink = over ? 0f : depth;
        return over;
    }

    /// <summary>Lays what is left of the pose in which it began to fall on one.</summary>
    public void Fade(float dt, in Pose local) => fade.Apply(dt, 0f, local);

    /// <summary>Goes on from where another is.</summary>
    public void CopyFrom(FreeFall other)
    {
        fade.CopyFrom(other.fade);
        last.Take(other.last.Pose);
        flail.CopyFrom(other.flail);
        (sink, velocity, turn, sinkRate, braking, astray) = (other.sink, other.velocity, other.turn, other.sinkRate, other.braking, other.astray);
    }

    /// <summary>Whether the ground comes, so that legs are to be stretched to it instead of drawn up.</summary>
    private bool Reaches(in RootPlace place, float tau, in MotionSettings settings, IGround ground)
    {
        float speed = -Vec.Dot(velocity, settings.Up);
        var range = new GroundRange(place, settings.Up, ground, 0f, Lookout * body.LegLength);
        bool found = range.Has(Vector3.Zero, out float away);
        for (int i = 0; i < body.Legs.Length && !found; i++)
        {
            found = range.Has(body.Legs[i].Home, out away);
        }

        if (!found)
        {
            return false;
        }

        float height = Math.Max(-away, 0f) * place.Scale;
        float time = ((float)Math.Sqrt((speed * speed) + (2f * settings.Gravity * height)) - speed) / settings.Gravity;
        return time < ReachTime * tau;
    }

    /// <summary>Whether the root comes to the ground on its way, or feet do around it.</summary>
    private bool TryLand(in RootPlace from, Vector3 to, Vector3 up, IGround ground, out Vector3 landed)
    {
        landed = to;
        float fall = Vec.Dot(from.Position - to, up);
        if (fall <= 0f)
        {
            return false;
        }

        var range = new GroundRange(new RootPlace(to, from.Rotation, from.Scale), up, ground, (fall / from.Scale) + (HigherFooting * body.LegLength), 0f);
        if (!range.Has(body.Middle, out float height))
        {
            FootingSpread spread = FootingSpread.None;
            if (!GroundNearFeet.Carries(body, range, ref spread, out height))
            {
                return false;
            }

            astray = true;
        }

        landed = to + (up * (height * from.Scale));
        return height >= 0f;
    }
}
