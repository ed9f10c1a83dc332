using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Slithering;

/// <summary>Moves a body without legs over the ground: every joint follows the track of the head, so that nothing slips sideways.</summary>
internal static class SlitherMotion
{
    private const double Response = 6;

    /// <summary>How quickly one way of crawling goes over into another, per body length of way.</summary>
    private const double ModeSharpness = 6;

    /// <summary>Least way for each metre along the track.</summary>
    private const double MinProgress = 0.1;

    /// <summary>Breaths per second of a body of one metre.</summary>
    private const double BreathRate = 0.3;

    /// <summary>Moves on and writes the body's root and axis of a local pose.</summary>
    /// <param name="profile">How the creature crawls.</param>
    /// <param name="input">What it is to do, and where its root is. A root that is not where the last update put it takes the whole track along.</param>
    /// <param name="ground">What it crawls on; it is below the crawler along −Y.</param>
    /// <param name="state">Where it is in its motion.</param>
    /// <param name="dt">Seconds, not negative; longer steps than 0.25 s count as that.</param>
    /// <param name="local">Pose in the parents' space, one entry per joint of the creature's skeleton; it is right for a root at the returned place.</param>
    /// <returns>Where to put the root.</returns>
    /// <exception cref="ArgumentException">The pose does not fit, or a number is not finite.</exception>
    public static RootPlace Update(SlitherProfile profile, in SlitherInput input, IGround ground, SlitherState state, float dt, in Pose local)
    {
        if (profile == null || ground == null || state == null)
        {
            throw new ArgumentNullException(profile == null ? nameof(profile) : ground == null ? nameof(ground) : nameof(state));
        }

        local.Require(profile.Skeleton);
        double time = StepCheck.Step(dt);
        double speed = Math.Max(StepCheck.Finite(input.Speed, "Speed"), 0);
        double yaw = StepCheck.Finite(input.YawRate, "YawRate");
        input.Root.Require(nameof(input));
        var floor = new CrawlFloor(ground, input.Root.Scale, profile.BodyLength);
        Follow(profile, input, floor, state);
        Crawl(profile, input, speed, yaw, floor, state, time);
        SlitherPose.Write(profile, state, floor, local);
        state.Root = new RootPlace(state.Middle * input.Root.Scale, AxisRotation.Yaw(state.Yaw), input.Root.Scale);
        return state.Root;
    }

    /// <summary>Lays the track at first, and takes it along when the root was moved by others.</summary>
    private static void Follow(SlitherProfile profile, in SlitherInput input, in CrawlFloor floor, SlitherState state)
    {
        RootPlace root = input.Root;
        RootPlace was = state.Root;
        if (state.Placed && root.Position == was.Position && root.Rotation == was.Rotation && root.Scale == was.Scale)
        {
            return;
        }

        Vector3 ahead = Rotation.Rotate(root.Rotation, Vector3.UnitZ);
        double yaw = PortableMath.Atan2(ahead.X, ahead.Z);
        Vector3 middle = root.Position / root.Scale;
        if (!state.Placed)
        {
            state.Placed = true;
            state.CourseAngle = yaw;
            state.Winding = CriticallyDampedSpring.At(WindingOf(profile, input.Mode));
            state.Sidewinding = CriticallyDampedSpring.At(SidewindingOf(input.Mode));
            Lay(profile, input.Mode, middle, yaw, floor, state);
            return;
        }

        double turn = yaw - state.Yaw;
        PortableMath.SinCos(turn, out double s, out double c);
        Vector3 p = state.Middle;

        // By the height of the ground: a root is not always where it lies, and the track does.
        double height = floor.HeightAt(middle.X, middle.Y, middle.Z, out _);
        state.Track.Carry(turn, middle.X - ((p.X * c) + (p.Z * s)), height - p.Y, middle.Z - ((p.Z * c) - (p.X * s)));
        state.CourseAngle += turn;
    }

    /// <summary>Lays the body about a place, as it would have come there; what does not undulate begins straight.</summary>
    private static void Lay(SlitherProfile profile, SlitherGait mode, Vector3 middle, double yaw, in CrawlFloor floor, SlitherState state)
    {
        double alpha = mode == SlitherGait.Undulating ? state.Winding.Value : 0;
        TrackSteering.Mean(alpha, 0, out double along, out _);
        state.Progress = Math.Max(along, MinProgress);
        PortableMath.SinCos(yaw, out double sine, out double cosine);
        double lead = SlitherPose.Lead(profile) * state.Progress;
        double x = middle.X + (lead * sine);
        double z = middle.Z + (lead * cosine);
        var steer = new TrackSteering(yaw, yaw, 0, alpha, 0);
        state.Track.Lay(x, middle.Y, z, steer, floor);
        SlitherPose.FindMiddle(profile, state, floor);
        state.Track.Lay(x + middle.X - state.Middle.X, middle.Y, z + middle.Z - state.Middle.Z, steer, floor);
    }

    /// <summary>How far the track swings, radians.</summary>
    private static double WindingOf(SlitherProfile profile, SlitherGait mode) => mode switch
    {
        SlitherGait.Undulating => profile.Alpha,
        SlitherGait.Sidewinding => profile.SidewindAlpha,
        _ => 0,
    };

    private static double SidewindingOf(SlitherGait mode) => mode == SlitherGait.Sidewinding ? 1 : 0;

    private static void Crawl(SlitherProfile profile, in SlitherInput input, double speed, double yaw, in CrawlFloor floor, SlitherState state, double dt)
    {
        SlitherGait mode = input.Mode;
        double sharpness = Response / Math.Sqrt(profile.BodyLength);
        double sides = state.Sidewinding.Value;
        double alpha = state.Winding.Value;
        double way = state.Speed.Step(speed, sharpness * input.SpeedResponse, dt);

        // Modes change with the way, not with time: a body that lies still keeps its shape.
        double lengths = way / profile.BodyLength;
        state.Sidewinding.Step(SidewindingOf(mode), ModeSharpness, lengths);
        state.Winding.Step(WindingOf(profile, mode), ModeSharpness, lengths);
        state.Idle.Step(speed > 0.02 * profile.BodyLength ? 0 : 1, sharpness, dt);
        state.Breath += dt * BreathRate / Math.Sqrt(profile.BodyLength);
        state.Breath -= Math.Floor(state.Breath);

        // Along its body it goes further than along its way. In sidewinding the track drifts over the ground so that what heads furthest to the left rests.
        TrackSteering.Mean(alpha, sides, out double along, out double across);
        PortableMath.SinCos(alpha, out double sine, out double cosine);
        along -= sides * cosine;
        across -= sides * sine;
        state.Progress = Math.Max(Math.Sqrt((along * along) + (across * across)), MinProgress);
        double slant = -PortableMath.Atan2(across, along);
        state.Slant = slant;
        double arc = way / state.Progress;
        double turn = Scalar.Clamp(yaw * dt, -profile.TightestTurn * way, profile.TightestTurn * way);
        if (arc > 0)
        {
            state.Track.Advance(arc, new TrackSteering(state.CourseAngle, state.CourseAngle + turn, slant, alpha, sides), floor);
            state.CourseAngle += turn;
            if (sides > 1e-6)
            {
                PortableMath.SinCos(state.CourseAngle + slant + alpha, out double x, out double z);
                state.Track.Drift(-sides * arc * x, -sides * arc * z);
            }
        }

        SlitherPose.FindMiddle(profile, state, floor);
    }
}
