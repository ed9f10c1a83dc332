using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;

namespace CreatureGen.Motion.Flying;

/// <summary>Steps the state of a flier: from the ground into the air and back, and all that swings with it.</summary>
internal static class FlightControl
{
    private const double Gravity = 9.81;

    /// <summary>Shares of the speed of cruise below which a flier hovers more than it flies.</summary>
    private const double HoverFraction = 0.45;

    private const double SteepestPath = 1.2;
    private const double SteepestBank = 1.05;

    /// <summary>Effort at level cruise of a flier that glides between beats; 1 never glides, 0 only glides.</summary>
    private const double LevelEffort = 0.66;

    private const double CrouchTime = 1.4;

    /// <summary>When it pushes itself off out of the crouch, and how far beyond standing, in depths of the crouch.</summary>
    private const double PushTime = 1.0;
    private const double PushRise = 0.25;
    private const double LeapTime = 1.2;
    private const double SettleTime = 1.6;

    /// <summary>Leg lengths above the ground at which landing begins and a leap is over.</summary>
    public const double LandingHeight = 2.2;
    private const double LeapHeight = 1.2;
    private const double PlantingHeight = 0.4;

    /// <summary>Leg lengths above the ground at which its feet are where they will stand.</summary>
    private const double PlantedHeight = 0.03;

    /// <summary>Speed in √(g·leg) from which on a flier that comes down runs, and gives way the less.</summary>
    private const double RunningSpeed = 0.45;
    private const double RunningStiffness = 0.9;

    /// <summary>Speed of touchdown, in √(g·leg).</summary>
    private const double Touchdown = 0.25;

    /// <summary>Spread below which a turn of the cycle is no beat.</summary>
    private const double SpreadForBeat = 0.3;

    /// <summary>How much it hovers, 0..1, at so many times the speed of cruise.</summary>
    public static double Hover(double cruises) => 1 - Scalar.Smooth(Math.Abs(cruises) / HoverFraction);

    /// <summary>Steps the state and says how the root moves.</summary>
    public static BodyVelocity Advance(FlightProfile profile, in FlightInput input, ref FlightState state, double dt)
    {
        double speed = StepCheck.Finite(input.Speed, "Speed");
        double yaw = StepCheck.Finite(input.YawRate, "YawRate");
        double climb = StepCheck.Finite(input.ClimbRate, "ClimbRate");
        double height = Math.Max(StepCheck.Finite(input.Height, "Height"), 0);
        double leg = profile.LegLength;
        double tempo = Math.Sqrt(Gravity / leg);
        Decide(profile, input.Intent, height / leg, dt * tempo, ref state);

        bool flying = state.Phase is FlightPhase.Airborne or FlightPhase.Leaping or FlightPhase.Landing;
        bool down = state.Phase is FlightPhase.Grounded or FlightPhase.Settling;
        double k = profile.Response;
        double cruises = speed / profile.CruiseSpeed;
        double hover = Hover(cruises);
        double path = PortableMath.Atan2(climb, Math.Max(Math.Abs(speed), 0.5 * profile.CruiseSpeed));
        double rise = Scalar.Clamp(path / 0.5, -1, 1);
        double level = profile.GlidesBetweenBeats ? LevelEffort : 1;
        double effort = state.Phase == FlightPhase.Airborne ? Scalar.Clamp(level + (1.4 * path) + hover + (0.5 * Math.Max(0, Math.Abs(cruises) - 1.2)), 0, 1) : 1;

        double beats = profile.BeatFrequency * (1 + (0.22 * hover) + (0.15 * Math.Max(0, rise)) + (state.Phase == FlightPhase.Leaping ? 0.25 : 0));
        double advance = state.Frequency.Step(flying ? beats : 0, flying ? 2 * k : 4 * k, dt);
        Beat(profile, state.Spread.Value, advance, dt, ref state);
        double width = 1 + (0.28 * hover) + (0.22 * Math.Max(0, rise)) + (state.Phase == FlightPhase.Leaping ? 0.25 : 0);
        state.Amplitude.Step(down ? 0 : width, 2 * k, dt);
        state.Effort.Step(effort, 1.5 * k, dt);

        // A steep dive half folds the wings.
        double dive = Scalar.Smooth((-path - 0.5) / 0.5) * (1 - hover);
        state.Spread.Step(down ? 0 : 1 - (0.35 * dive), down ? 1.3 * tempo : 2.2 * tempo, dt);
        double landing = state.Phase == FlightPhase.Landing ? Scalar.Smooth((LandingHeight - (height / leg)) / (0.6 * LandingHeight)) : 0;
        state.Flare.Step(landing, 1.5 * k, dt);
        state.Speed.Step(flying ? cruises : 0, 1.2 * k, dt);
        double turn = PortableMath.Atan2(speed * yaw, Gravity);
        state.Bank.Step(Curve.Bounded(turn, SteepestBank), 1.2 * k, dt);
        state.Steer.Step(Curve.Bounded(yaw * Math.Max(0.35, 0.5 * profile.CruiseSpeed / Gravity), 1), 1.5 * k, dt);
        state.Path.Step(Curve.Bounded(path, SteepestPath), k, dt);
        Crouch(tempo, Math.Sqrt(Gravity * leg), dt, ref state);
        state.Upright.Step(state.Raised, 4 * tempo, dt);
        state.Air.Step(flying ? 1 : 0, 2 * tempo, dt);
        bool reaches = state.Phase == FlightPhase.Landing;
        state.Planted.Step(reaches ? 1 - Scalar.Smooth(((height / leg) - PlantedHeight) / (PlantingHeight - PlantedHeight)) : flying ? 0 : 1, reaches || !flying ? 60 * tempo : 4 * tempo, dt);
        state.Height.Step(Math.Min(height, FlightState.HighEnough * leg), 20 * tempo, dt);
        return Root(state, speed, yaw, climb, height, leg, dt);
    }

    private static BodyVelocity Root(in FlightState state, double speed, double yaw, double climb, double height, double leg, double dt)
    {
        double unit = Math.Sqrt(Gravity * leg);
        double part = Scalar.Smooth(state.Age / LeapTime);
        return state.Phase switch
        {
            FlightPhase.Leaping => Velocity(Scalar.Lerp(state.RunUp, speed, part), Math.Max(climb, 1.5 * unit) * (0.35 + (0.65 * Scalar.Smooth(2 * state.Age / LeapTime))), yaw * part),
            FlightPhase.Landing => Velocity(
                Scalar.Lerp(Scalar.Clamp(speed, 0, state.RunOut), speed, Scalar.Smooth(((height / leg) - PlantingHeight) / (LandingHeight - PlantingHeight))),
                -Math.Min(height / Math.Max(dt, 1e-4), Scalar.Clamp(0.9 * unit * height / leg, Touchdown * unit, 1.4 * unit)),
                yaw),
            FlightPhase.Crouching or FlightPhase.Settling => default,
            _ => Velocity(speed, state.Phase == FlightPhase.Grounded ? 0 : climb, yaw),
        };
    }

    private static BodyVelocity Velocity(double ahead, double up, double turn) => new(new Vector3(0f, (float)up, (float)ahead), (float)turn);

    /// <summary>Goes down before a leap and pushes off out of that; gives way when it has come down.</summary>
    private static void Crouch(double tempo, double unit, double dt, ref FlightState state)
    {
        double running = Scalar.Smooth(Math.Abs(state.RunUp) / (RunningSpeed * unit));
        bool pushes = state.Phase == FlightPhase.Crouching && state.Age > PushTime;
        double depth = state.Phase switch
        {
            FlightPhase.Crouching => pushes ? -PushRise : 1,
            FlightPhase.Settling => 0.85 * (1 - (RunningStiffness * running)) * (1 - Scalar.Smooth(state.Age / (0.6 * SettleTime))),
            _ => 0,
        };
        state.Crouch.Step(depth, pushes || state.Phase == FlightPhase.Leaping ? 6 * tempo : 3.5 * tempo, dt);
    }

    /// <summary>Goes from one phase to the next. Heights are in leg lengths, time in √(leg/g).</summary>
    private static void Decide(FlightProfile profile, FlightIntent intent, double height, double time, ref FlightState state)
    {
        state.Age += time;
        bool up = intent == FlightIntent.Air;
        FlightPhase next = state.Phase switch
        {
            FlightPhase.Grounded => up ? FlightPhase.Crouching : FlightPhase.Grounded,
            FlightPhase.Crouching => !up ? FlightPhase.Settling : state.Age >= CrouchTime ? FlightPhase.Leaping : FlightPhase.Crouching,
            FlightPhase.Leaping => height >= LeapHeight || state.Age >= 2 * LeapTime ? FlightPhase.Airborne : FlightPhase.Leaping,
            FlightPhase.Airborne => !up && height <= LandingHeight ? FlightPhase.Landing : FlightPhase.Airborne,
            FlightPhase.Landing => up ? FlightPhase.Airborne : height <= 0.02 ? FlightPhase.Settling : FlightPhase.Landing,
            _ => up ? FlightPhase.Crouching : state.Age >= SettleTime ? FlightPhase.Grounded : FlightPhase.Settling,
        };
        if (next != state.Phase)
        {
            state.Phase = next;
            state.Age = 0;
        }
    }

    /// <summary>Runs the cycle on and counts the downstrokes. Folded wings wait at the top of the beat.</summary>
    private static void Beat(FlightProfile profile, double spread, double beats, double dt, ref FlightState state)
    {
        state.BeatsBegun = 0;
        state.SecondsSinceBeat = 0f;
        if (spread < 0.02 && state.Phase is FlightPhase.Grounded or FlightPhase.Crouching)
        {
            state.Cycle = 0;
            return;
        }

        double before = state.Cycle * profile.BeatsPerCycle;
        double after = before + beats;
        long begun = (long)(Math.Floor(after) - Math.Floor(before));
        if (begun > 0 && spread > SpreadForBeat)
        {
            state.Beats += begun;
            state.BeatsBegun = (int)begun;
            state.SecondsSinceBeat = (float)(dt * (after - Math.Floor(after)) / beats);
        }

        state.Cycle = after / profile.BeatsPerCycle;
        state.Cycle -= Math.Floor(state.Cycle);
    }
}
