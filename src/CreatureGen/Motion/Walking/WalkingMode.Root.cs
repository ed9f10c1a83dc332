using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Footsteps;
using CreatureGen.Motion.Walking.Pace;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Walking;

/// <content>How it travels; and travel and gait alone, as seen from afar: feet are where nobody sees them, and one step of time is as long as the update.</content>
internal sealed partial class WalkingMode
{
    /// <summary>How much quicker than by itself it steps where a game turns or moves it farther than its feet reach.</summary>
    private const float HasteOfPushed = 2f;

    /// <summary>Where the ray begins above the root and ends below it, leg lengths: as far as ground carries the body.</summary>
    private const float Above = 0.8f;
    private const float Below = 0.9f;

    /// <summary>How quickly the slope under the body is taken up, per second.</summary>
    private const float SlopeRate = 6f;

    private Vector3 underfoot = Vector3.UnitY;
    private ExponentialDecay underfootDecay;

    /// <summary>Number of the gait that its speed asks for, slow to fast.</summary>
    public int UsualGait => gait;

    /// <summary>How far it goes in a cycle with its farthest foot, metres of the model; below 0 backwards.</summary>
    public float StrideGone
    {
        get
        {
            float speed = (float)Math.Sqrt((velocity.Speed * velocity.Speed) + (velocity.Sideways * velocity.Sideways)) + Math.Abs(velocity.Turn * body.FarthestFoot);
            return (velocity.Speed < 0f ? -activity : activity) * speed / Math.Max(clock.Frequency, 1e-3f);
        }
    }

    /// <summary>Out of the ground under the body as it was felt last, smoothed, model space, unit.</summary>
    public Vector3 Underfoot => underfoot;

    /// <summary>Forgets the ground under it: it was seen from near.</summary>
    public void BeginDistant() => underfoot = Vector3.UnitY;

    /// <summary>Travels as asked. Nothing has changed where the ground throws or where there is none.</summary>
    /// <param name="place">Where it is.</param>
    /// <param name="dt">Seconds.</param>
    /// <param name="input">What it is to do.</param>
    /// <param name="settings">What can be set.</param>
    /// <param name="ground">What it goes on.</param>
    /// <param name="next">Where it is then.</param>
    /// <returns>Whether there is ground under it.</returns>
    public bool AdvanceRoot(in RootPlace place, float dt, in MotionInput input, MotionSettings settings, IGround ground, out RootPlace next)
    {
        float scale = place.Scale;
        settings.Gravity = GravityOf(settings, scale);
        (float goal, float aside) = Asked(input, scale, settings);
        RootVelocity ahead = velocity;
        ahead.Bounds = VelocityBounds.Of(body, settings);
        ahead.Ask(goal, aside, clock.ReachableTurn(goal, input.YawRate, settings.Gravity));
        Vector3 way = ahead.Advance(dt, out float yaw);

        // Along the slope that it was on.
        way.Y = -((underfoot.X * way.X) + (underfoot.Z * way.Z)) / Math.Max(underfoot.Y, 0.5f);
        Quaternion rotation = yaw == 0f ? place.Rotation : Rotation.Multiply(place.Rotation, AxisRotation.Yaw(yaw));
        next = new RootPlace(place.ToWorld(way), UnitRotation.Upright(rotation, settings.Up), scale);
        if (!Feel(next, settings.Up, ground, out float away, out Vector3 normal))
        {
            return false;
        }

        velocity = ahead;
        FeelAcceleration(dt);
        float rise = height.Part(away, body.LegLength, velocity.Speed, dt);
        next = new RootPlace(next.Position + (settings.Up * (rise * scale)), next.Rotation, scale);
        GoOn(dt, normal, settings);
        return true;
    }

    /// <summary>The same where the game moves it.</summary>
    public bool AdvanceRootAlong(in RootPlace place, float dt, in RootPlace goal, MotionSettings settings, IGround ground)
    {
        settings.Gravity = GravityOf(settings, goal.Scale);
        settings.Up = Rotation.Rotate(goal.Rotation, Vector3.UnitY);
        if (!Feel(goal, settings.Up, ground, out _, out Vector3 normal))
        {
            return false;
        }

        if (dt > 0f)
        {
            Approach(place, dt, goal, out _);
        }

        GoOn(dt, normal, settings);
        return true;
    }

    /// <summary>How far ahead it comes in a time on level ground in which a speed is asked of it, world metres.</summary>
    /// <param name="pace">Asked, world m/s ahead.</param>
    /// <param name="seconds">The time.</param>
    /// <param name="scale">World metres per model metre.</param>
    /// <param name="settings">What can be set.</param>
    /// <param name="speed">How fast it is then, world m/s ahead.</param>
    public float Foretell(float pace, float seconds, float scale, MotionSettings settings, out float speed)
    {
        settings.Gravity = GravityOf(settings, scale);
        RootVelocity ahead = velocity;
        ahead.Bounds = VelocityBounds.Of(body, settings);
        ahead.Ask(pace / scale, 0f, 0f);
        float way = ahead.Advance(seconds, out _).Z * scale;
        speed = ahead.Speed * scale;
        return way;
    }

    /// <summary>Goes on from there on its feet: these are put where they are in their stride.</summary>
    /// <param name="place">Where the root is.</param>
    /// <param name="settings">What can be set.</param>
    /// <param name="ground">Where feet find footing.</param>
    public void Resume(in RootPlace place, MotionSettings settings, IGround ground)
    {
        settings.Gravity = GravityOf(settings, place.Scale);
        pushed = default;
        ticker = default;
        moving = activity > MinActivity;
        var step = new StepContext(place, velocity, clock, settings, ground, 0f, 0f, 0f, activity, moving, 0f);
        if (moving)
        {
            planner.PlaceInStride(step);
        }
        else
        {
            planner.PlaceAll(step);
        }

        going = true;
        standing = true;
        arrived = true;
        PlaceFeet(place, settings, null);
        placer.Reset(planner.Feet);
        pace.Forget();
        height.Reset();
    }

    private RootPlace Update(RootPlace placement, float dt, in MotionInput input, in MotionSettings asked, IGround ground, BodyLayer? layer)
    {
        // From here on in metres of the model.
        float scale = placement.Scale;
        MotionSettings settings = asked with { Gravity = GravityOf(asked, scale) };
        Begin(placement, settings, ground, layer);
        pushed = default;
        velocity.Bounds = VelocityBounds.Of(body, settings);
        (float goal, float aside) = Asked(input, scale, settings);
        placement = PlatformRide.Carry(planner.Feet, placement, ground, settings.Up);
        float left = dt;
        float since = 0f;
        while (left > 0f)
        {
            if (ticker.Begins)
            {
                bool stops = Brink.IsAhead(body, placement, velocity, new Vector3(aside, 0f, goal), settings.Up, ground);
                (float ahead, float across) = stops ? (0f, 0f) : (goal, aside);
                velocity.Ask(ahead, across, clock.ReachableTurn(ahead, input.YawRate, settings.Gravity));
            }

            float h = ticker.Next(ref left);
            Vector3 way = velocity.Advance(h, out float yaw);
            Quaternion rotation = Rotation.Multiply(placement.Rotation, AxisRotation.Yaw(yaw));
            placement = new RootPlace(placement.ToWorld(way), UnitRotation.Upright(rotation, settings.Up), scale);
            placement = height.Follow(placement, body.LegLength, placer, velocity.Speed, h, settings.Up);
            if (ticker.Decides)
            {
                height.Feel(placement, body, velocity, settings.Up, ground);
            }

            since += h;
            Step(placement, h, since, left, settings, ground);
        }

        FeelAcceleration(dt);
        return placement;
    }

    private void Follow(in RootPlace placement, float dt, in RootPlace goal, in MotionSettings settings, IGround ground, BodyLayer? layer)
    {
        Begin(goal, settings, ground, layer);
        PlatformRide.Carry(planner.Feet, goal, ground, settings.Up);
        if (dt > 0f)
        {
            Approach(placement, dt, goal, out Vector3 way);
            placer.RootRaised((way.Y - (placer.Climb * velocity.Speed)) * dt);
            float left = dt;
            float since = 0f;
            while (left > 0f)
            {
                float h = ticker.Next(ref left);
                since += h;
                Step(goal, h, since, left, settings, ground, HasteOfPushed);
            }
        }
    }

    /// <summary>What it goes over to, of what is asked: metres per second of the model, ahead and to its left.</summary>
    private (float Ahead, float Aside) Asked(in MotionInput input, float scale, in MotionSettings settings)
    {
        float top = settings.Walking.Gait == null ? gaits.TopSpeed / (float)Math.Sqrt(settings.Walking.Heft) : (float)Math.Sqrt(settings.Walking.Gait.Fastest * settings.Gravity * body.LegLength);
        float back = 0.5f * (float)Math.Sqrt(0.3f * settings.Gravity * body.LegLength);
        return (clock.OnSlope(Scalar.Clamp(input.Speed / scale, -back, top), settings.Gravity), Scalar.Clamp(input.Sideways / scale, -back, back));
    }

    /// <summary>Takes over the velocity with which the game moves it, smoothed.</summary>
    /// <param name="before">Where it was.</param>
    /// <param name="dt">Seconds, above 0.</param>
    /// <param name="goal">Where it is.</param>
    /// <param name="way">Metres per second of the model.</param>
    private void Approach(in RootPlace before, float dt, in RootPlace goal, out Vector3 way)
    {
        way = before.ToModel(goal.Position) / dt;
        Quaternion turn = Rotation.Multiply(Rotation.Inverse(before.Rotation), goal.Rotation);
        float yaw = 2f * (turn.W < 0f ? -turn.Y : turn.Y) / dt;
        float fraction = 1f - (float)PortableMath.Exp(-20f * dt);
        float speed = velocity.Speed;
        velocity = RootVelocity.At(speed + ((way.Z - speed) * fraction), velocity.Sideways + ((way.X - velocity.Sideways) * fraction), velocity.Turn + ((yaw - velocity.Turn) * fraction));
        acceleration += (((velocity.Speed - speed) / dt) - acceleration) * fraction;
    }

    /// <summary>The acceleration that the body shows, which changes no quicker than where it does what it intends: after a push it is not there at once.</summary>
    private void FeelAcceleration(float dt)
    {
        SpeedBounds along = velocity.Bounds.Along;
        float most = (along.Rise + along.Fall) / along.Lag * dt;
        acceleration = Scalar.Clamp(velocity.Acceleration, acceleration - most, acceleration + most);
    }

    /// <summary>Feels the ground under a place.</summary>
    /// <param name="at">The place.</param>
    /// <param name="up">Unit, world space.</param>
    /// <param name="ground">The ground.</param>
    /// <param name="away">Its height above the place, metres of the model.</param>
    /// <param name="normal">Out of it, model space.</param>
    private bool Feel(in RootPlace at, Vector3 up, IGround ground, out float away, out Vector3 normal)
    {
        float reach = body.LegLength * at.Scale;
        if (!ground.Cast(at.Position + (up * (Above * reach)), -up, (Above + Below) * reach, out GroundHit hit))
        {
            (away, normal) = (0f, Vector3.UnitY);
            return false;
        }

        away = Vec.Dot(hit.Point - at.Position, up) / at.Scale;
        normal = hit.Normal == up ? Vector3.UnitY : Rotation.Rotate(Rotation.Inverse(at.Rotation), hit.Normal);
        return true;
    }

    /// <summary>Lets gait and slope go on.</summary>
    private void GoOn(float dt, Vector3 normal, in MotionSettings settings)
    {
        float unit = settings.Gravity * body.LegLength;
        float squared = (velocity.Speed * velocity.Speed) + (velocity.Sideways * velocity.Sideways);
        float pace = Math.Min((float)Math.Sqrt(squared / (SlowWalk * unit)), 1f);
        moving = going = pace > 0.05f || Math.Abs(velocity.Turn) > 0.03f;
        ChooseGait(squared / unit, settings);
        activity += ((moving ? Math.Min(pace + (0.35f * Math.Abs(velocity.Turn)), 1f) : 0f) - activity) * activityDecay.Fraction(ActivityRate * dt);
        clock.Slide(dt, velocity, settings.Gravity, pace, 0f, settings.Walking.Stride);
        double phase = clock.Phase + (clock.Frequency * dt);
        clock.Phase = phase - Math.Floor(phase);
        if (underfoot != normal)
        {
            Vector3 mixed = Vec.Lerp(underfoot, normal, underfootDecay.Fraction(SlopeRate * dt));
            underfoot = Vec.LengthSquared(mixed - normal) < 1e-8f ? normal : Vec.Normalize(mixed, normal);
        }
    }
}
