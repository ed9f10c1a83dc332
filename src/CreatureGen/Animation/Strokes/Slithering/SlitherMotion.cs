using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Strokes.Slithering;

/// <summary>Moves a body without legs over the ground: every joint follows the track of the head, so that nothing slips sideways.</summary>
public static class SlitherMotion
{
    private const double Response = 6;

    /// <summary>Breaths per second of a body of one metre.</summary>
    private const double BreathRate = 0.3;

    /// <summary>Moves on and writes the body's root and axis of a local pose.</summary>
    /// <param name="profile">How the creature crawls.</param>
    /// <param name="input">What it is to do, and where its root is. A root that is not where the last update put it takes the whole track along.</param>
    /// <param name="ground">What it crawls on.</param>
    /// <param name="state">Where it is in its motion.</param>
    /// <param name="dt">Seconds, not negative; longer steps than 0.25 s count as that.</param>
    /// <param name="local">Pose in the parents' space, one entry per joint of the creature's skeleton; it is right for a root at the returned place.</param>
    /// <returns>Where to put the root.</returns>
    /// <exception cref="ArgumentException">The pose does not fit, or a number is not finite.</exception>
    public static RootPlace Update(SlitherProfile profile, in SlitherInput input, ISlitherGround ground, SlitherState state, float dt, in Pose local)
    {
        if (profile == null || ground == null || state == null)
        {
            throw new ArgumentNullException(profile == null ? nameof(profile) : ground == null ? nameof(ground) : nameof(state));
        }

        local.Require(profile.Skeleton);
        double time = StrokeInput.Step(dt);
        double speed = Math.Max(StrokeInput.Finite(input.Speed, "Speed"), 0);
        double yaw = StrokeInput.Finite(input.YawRate, "YawRate");
        StrokeInput.Finite(input.RootPosition.X + input.RootPosition.Y + input.RootPosition.Z, "RootPosition");
        StrokeInput.Finite(input.RootYaw, "RootYaw");
        Follow(profile, input, ground, state);
        Crawl(profile, input.Mode, speed, yaw, ground, state, time);
        SlitherPose.Write(profile, state, ground, local);
        return state.Root;
    }

    /// <summary>Lays the track at first, and takes it along when the root was moved by others.</summary>
    private static void Follow(SlitherProfile profile, in SlitherInput input, ISlitherGround ground, SlitherState state)
    {
        if (!state.Placed)
        {
            state.Placed = true;
            state.Travel = input.RootYaw;
            PortableMath.SinCos(state.Travel, out double sine, out double cosine);
            double lead = SlitherPose.Lead(profile);
            state.Track.Lay(input.RootPosition.X + (lead * sine), input.RootPosition.Z + (lead * cosine), state.Travel, ground);
            state.Root = new RootPlace(input.RootPosition, input.RootYaw);
            return;
        }

        RootPlace was = state.Root;
        if (input.RootPosition == was.Position && input.RootYaw == was.Yaw)
        {
            return;
        }

        double turn = input.RootYaw - (double)was.Yaw;
        PortableMath.SinCos(turn, out double s, out double c);
        Vector3 p = was.Position;
        state.Track.Carry(turn, input.RootPosition.X - ((p.X * c) + (p.Z * s)), input.RootPosition.Y - p.Y, input.RootPosition.Z - ((p.Z * c) - (p.X * s)));
        state.Travel += turn;
        state.Root = new RootPlace(input.RootPosition, input.RootYaw);
    }

    private static void Crawl(SlitherProfile profile, SlitherMode mode, double speed, double yaw, ISlitherGround ground, SlitherState state, double dt)
    {
        double sharpness = Response / Math.Sqrt(profile.BodyLength);
        double sidewind = mode == SlitherMode.Sidewinding ? 1 : 0;
        double sides = state.Sidewinding.Value;
        double alpha = state.Winding.Value;
        double way = state.Speed.Step(speed, sharpness, dt);

        // Modes change with the way, not with time: a body that lies still keeps its shape.
        double lengths = way / profile.BodyLength;
        state.Sidewinding.Step(sidewind, 6, lengths);
        state.Winding.Step(mode == SlitherMode.Undulating ? profile.Alpha : mode == SlitherMode.Sidewinding ? profile.SidewindAlpha : 0, 6, lengths);
        state.Idle.Step(speed > 0.02 * profile.BodyLength ? 0 : 1, sharpness, dt);
        state.Breath += dt * BreathRate / Math.Sqrt(profile.BodyLength);
        state.Breath -= Math.Floor(state.Breath);

        // Along its body it goes further than along its way. In sidewinding the track drifts over the ground so that what heads furthest to the left rests.
        TrackSteering.Mean(alpha, sides, out double along, out double across);
        PortableMath.SinCos(alpha, out double sine, out double cosine);
        along -= sides * cosine;
        across -= sides * sine;
        double progress = Math.Sqrt((along * along) + (across * across));
        double slant = -PortableMath.Atan2(across, along);
        double arc = way / Math.Max(progress, 0.1);
        double turn = Scalar.Clamp(yaw * dt, -profile.TightestTurn * way, profile.TightestTurn * way);
        if (arc > 0)
        {
            state.Track.Advance(arc, new TrackSteering(state.Travel, state.Travel + turn, slant, alpha, sides), ground);
            state.Travel += turn;
            if (sides > 1e-6)
            {
                PortableMath.SinCos(state.Travel + slant + alpha, out double x, out double z);
                state.Track.Drift(-sides * arc * x, -sides * arc * z);
            }
        }

        state.Root = SlitherPose.RootOf(profile, state, ground);
    }
}
