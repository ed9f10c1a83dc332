using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit.Chains;

namespace CreatureGen.Motion.Flying;

/// <summary>Steps the state of a flier: from the ground into the air and back, and all that swings with it.</summary>
internal static class FlightControl
{
    /// <summary>Shares of the speed of cruise below which a flier hovers more than it flies.</summary>
    private const double HoverFraction = 0.45;

    private const double SteepestPath = 1.2;

    /// <summary>Tangent of the steepest bank of a steady turn, 1.05 rad.</summary>
    private const double TangentOfBank = 1.743;

    /// <summary>Radians that it leans at most, whatever is set.</summary>
    private const double SteepestBank = 1.3;

    /// <summary>How much more sharply than the rest of its motion its turning follows what is asked.</summary>
    private const double TurnSharpness = 1.2;

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

    /// <summary>Deceleration of its fall near the ground, in parts of gravity, and time, √(leg/g), within which it need not wait to come down before it is slow enough to run.</summary>
    private const double Cushion = 0.4;
    private const double ShortBrake = 0.15;

    /// <summary>Leg lengths above the ground at which legs no longer carry it, the time, √(leg/g), after which it takes to its wings for that, and how fast it then comes down, cruises.</summary>
    private const double CliffHeight = 0.6;
    private const double CliffTime = 0.1;
    private const double CliffDescent = 0.3;

    /// <summary>Leg lengths above the ground below which a flier that is to stay in the air does not go.</summary>
    private const double LowestFlight = 1.2;

    /// <summary>Share of its beat that a flier without legs makes on the ground.</summary>
    public const double LowBeat = 0.2;

    /// <summary>Cruises that are missing at which it works its hardest to get faster; cruises too many at which it does to get slower.</summary>
    private const double PushingGap = 0.4;
    private const double BrakingGap = 0.35;

    /// <summary>How far the wings are flared to get slower, 1 to land.</summary>
    private const double BrakingFlare = 0.7;

    /// <summary>Greatest width of the beat, 1 at cruise.</summary>
    private const double WidestBeat = 1.5;

    /// <summary>Fastest climb and dive, cruises.</summary>
    private const double FastestClimb = 0.6;
    private const double FastestDive = 1.5;

    /// <summary>Speed in √(g·leg) from which on a flier that comes down runs, and gives way the less.</summary>
    private const double RunningSpeed = 0.45;
    private const double RunningStiffness = 0.9;

    /// <summary>Speed of touchdown, in √(g·leg).</summary>
    private const double Touchdown = 0.25;

    /// <summary>How much quicker it beats as it hovers, climbs and leaps, parts of the beats at cruise.</summary>
    private const double HoverBeats = 0.22;
    private const double ClimbBeats = 0.15;
    private const double LeapBeats = 0.25;

    /// <summary>Spread below which a turn of the cycle is no beat.</summary>
    private const double SpreadForBeat = 0.3;

    /// <summary>How much it hovers, 0..1, at so many times the speed of cruise.</summary>
    public static double Hover(double cruises) => 1 - Scalar.Smooth(Math.Abs(cruises) / HoverFraction);

    /// <summary>Steps the state and says how the root moves.</summary>
    public static BodyVelocity Advance(FlightProfile profile, in FlightInput input, ref FlightState state, double dt)
    {
        double gravity = StepCheck.Finite(input.Gravity, "Gravity");
        if (!(gravity > 0))
        {
            throw new ArgumentOutOfRangeException(nameof(input), gravity, "expected a gravity above 0");
        }

        FlyingSettings settings = input.Settings ?? FlyingSettings.Default;
        double speed = StepCheck.Finite(input.Speed, "Speed");
        double yaw = StepCheck.Finite(input.YawRate, "YawRate");
        double climb = StepCheck.Finite(input.ClimbRate, "ClimbRate");
        double height = Math.Max(StepCheck.Finite(input.Height, "Height"), 0);
        double leg = profile.LegLength;
        double tempo = Math.Sqrt(gravity / leg);
        double sinking = Math.Max(-state.Rise.Speed, 0);
        double low = LandingHeight + (sinking * sinking / (2 * Cushion * gravity * leg));
        Decide(input.Intent, height / leg, low, dt * tempo, ref state);

        bool flying = state.Phase is FlightPhase.Airborne or FlightPhase.Leaping or FlightPhase.Landing;
        bool down = state.Phase is FlightPhase.Grounded or FlightPhase.Settling;
        double cruise = profile.CruiseIn(gravity);
        double k = profile.Response * FlightProfile.Tempo(gravity);
        double goal = GoalAhead(state, speed);

        // To land it brakes with all it has.
        double brakes = state.Phase == FlightPhase.Landing ? 1 : settings.Braking;
        double way = state.Ahead.Step(goal, profile.MomentumIn(gravity).Quickened(settings.SpeedResponse).Braked(brakes), dt);
        double turned = Turn(profile, yaw, gravity, settings.YawResponse, dt, ref state);
        climb = Scalar.Clamp(state.Fell ? Math.Min(climb, -CliffDescent * cruise) : climb, -FastestDive * cruise, FastestClimb * cruise);
        double up = Climb(profile, goal, climb, height, gravity, dt, ref state);
        state.Cruises = state.Ahead.Speed / cruise;

        // What is integrated goes by the mean of the step, so that frame rates agree.
        double mean = dt > 0 ? way / dt : state.Ahead.Speed;
        double cruises = mean / cruise;
        double hover = Hover(cruises);
        double path = PortableMath.Atan2(climb, Math.Max(Math.Abs(mean), 0.5 * cruise));
        double rise = Scalar.Clamp(path / 0.5, -1, 1);
        double missing = flying ? (Math.Abs(goal) - Math.Abs(mean)) / cruise : 0;
        double push = Scalar.Smooth(missing / PushingGap);
        double slow = Scalar.Smooth(-missing / BrakingGap);
        double level = profile.GlidesBetweenBeats ? LevelEffort : 1;
        double effort = state.Phase == FlightPhase.Airborne ? Scalar.Clamp(level + (1.4 * path) + hover + (0.5 * Math.Max(0, Math.Abs(cruises) - 1.2)) + push - (0.5 * slow * (1 - hover)), 0, 1) : 1;

        double leap = state.Phase == FlightPhase.Leaping ? LeapBeats : 0;
        double beats = profile.BeatsIn(gravity) * (1 + (HoverBeats * hover) + (ClimbBeats * Math.Max(0, rise)) + Math.Max(leap, 0.12 * push));
        double advance = state.Frequency.Step(flying ? beats : 0, flying ? 2 * k : 4 * k, dt);
        Beat(profile, state.Spread.Value, advance, dt, ref state);
        double width = Math.Min((1 + (0.28 * hover) + (0.22 * Math.Max(0, rise)) + Math.Max(leap, 0.18 * push)) * settings.BeatAmplitude, WidestBeat);
        state.Amplitude.Step(down ? 0 : width * Room(profile, height), 2 * k, dt);
        state.Effort.Step(effort, 1.5 * k, dt);

        // A steep dive half folds the wings.
        double dive = Scalar.Smooth((-path - 0.5) / 0.5) * (1 - hover);
        state.Spread.Step(down ? 0 : 1 - (0.35 * dive), down ? 1.3 * tempo : 2.2 * tempo, dt);
        double landing = state.Phase == FlightPhase.Landing ? Scalar.Smooth((LandingHeight - (height / leg)) / (0.6 * LandingHeight)) : 0;

        // It flares as soon as it means to land: near the ground its body is to be as it stands.
        double flare = state.Phase == FlightPhase.Landing ? 1 : BrakingFlare * slow;
        state.Flare.Step(flying ? flare : 0, 1.5 * k, dt);
        state.Reach.Step(landing, 1.5 * k, dt);
        state.Bank = Scalar.Clamp(settings.Bank * PortableMath.Atan2(state.Ahead.Speed * state.Turn.Value, gravity), -SteepestBank, SteepestBank);
        state.Steer = Curve.Bounded(state.Turn.Value * Math.Max(0.35, 0.5 * cruise / gravity), 1);
        state.Path.Step(Curve.Bounded(PortableMath.Atan2(state.Rise.Speed, Math.Max(Math.Abs(state.Ahead.Speed), 0.5 * cruise)), SteepestPath), k, dt);
        Crouch(tempo, Math.Sqrt(gravity * leg), dt, ref state);
        state.Upright.Step(state.Raised, 4 * tempo, dt);
        state.Air.Step(flying ? 1 : 0, 2 * tempo, dt);
        state.Planting = state.Phase == FlightPhase.Landing ? 1 - Scalar.Smooth(((height / leg) - PlantedHeight) / (PlantingHeight - PlantedHeight)) : flying ? 0 : 1;
        state.Planted.Step(state.Planting, state.Planting > 0 ? 60 * tempo : 4 * tempo, dt);
        state.Height.Step(Math.Min(height, FlightState.HighEnough * leg), 20 * tempo, dt);
        return dt > 0 ? Velocity(way / dt, up / dt, turned / dt) : default;
    }

    /// <summary>Radians per second with which thin wings turn at their root at most: they beat quickest and widest.</summary>
    public static double FastestBlade(FlightProfile profile) =>
        2 * PortableMath.Pi * profile.BeatFrequency * (1 + HoverBeats + ClimbBeats + LeapBeats) * WidestBeat * BuzzPair.WidestSteer * BuzzPair.FastestBlade;

    /// <summary>How much of its beat a flier that has no legs to stand on makes so far above the ground, 0..1: wings of one that lies on it would beat into it.</summary>
    private static double Room(FlightProfile profile, double height) =>
        profile.Stands ? 1 : Scalar.Lerp(LowBeat, 1, Scalar.Smooth(height / (LowestFlight * profile.LegLength)));

    /// <summary>The speed ahead that it goes for: to land, what its legs can run.</summary>
    private static double GoalAhead(in FlightState state, double speed) => state.Phase switch
    {
        FlightPhase.Landing => Scalar.Clamp(speed, 0, state.RunOut),
        FlightPhase.Crouching or FlightPhase.Settling => 0,
        _ => speed,
    };

    /// <summary>Turns as far as its bank lets it, and gives the angle.</summary>
    private static double Turn(FlightProfile profile, double yaw, double gravity, double response, double dt, ref FlightState state)
    {
        double agility = profile.Response * FlightProfile.Tempo(gravity);
        double fastest = Math.Min(agility, gravity * TangentOfBank / Math.Max(Math.Abs(state.Ahead.Speed), 1e-6));
        bool steers = state.Phase is not (FlightPhase.Crouching or FlightPhase.Settling);
        return state.Turn.Step(steers ? Scalar.Clamp(yaw, -fastest, fastest) : 0, TurnSharpness * agility * response, dt);
    }

    /// <summary>Rises and sinks, and gives the way up.</summary>
    private static double Climb(FlightProfile profile, double goal, double climb, double height, double gravity, double dt, ref FlightState state)
    {
        double leg = profile.LegLength;
        double unit = Math.Sqrt(gravity * leg);
        switch (state.Phase)
        {
            case FlightPhase.Leaping:
                // Its legs push it.
                double leap = Math.Max(climb, 1.5 * unit) * (0.35 + (0.65 * Scalar.Smooth(2 * state.Age / LeapTime)));
                state.Rise = Momentum.At(leap);
                return leap * dt;
            case FlightPhase.Landing:
                return Math.Max(state.Rise.Step(-Descent(profile, goal, height, gravity, state), profile.LiftIn(gravity), dt), -height);
            case FlightPhase.Airborne:
                return state.Rise.Step(Math.Max(climb, LowestClimb(height - (LowestFlight * leg), leg, gravity)), profile.LiftIn(gravity), dt);
            default:
                state.Rise = default;
                return 0;
        }
    }

    /// <summary>How fast it comes down to land: not before it is slow enough to run, and ever slower near the ground.</summary>
    private static double Descent(FlightProfile profile, double goal, double height, double gravity, in FlightState state)
    {
        double unit = Math.Sqrt(gravity * profile.LegLength);
        double touch = Touchdown * unit;
        double braking = Math.Max(state.Ahead.Speed - goal, 0) / (profile.Braking * gravity);
        double soft = Math.Sqrt((touch * touch) + (2 * Cushion * gravity * height));
        double wait = ShortBrake * profile.LegLength / unit;
        return braking <= wait ? soft : Math.Min(soft, height / (braking - wait));
    }

    /// <summary>The least climb of a flier that stays in the air: it does not fly into the ground.</summary>
    private static double LowestClimb(double room, double leg, double gravity)
    {
        double steady = Math.Sqrt(2 * Cushion * gravity * Math.Abs(room));
        return room > 0 ? -steady : Math.Min(steady, Math.Sqrt(gravity * leg));
    }

    private static BodyVelocity Velocity(double ahead, double up, double turn) => new(new Vector3(0f, (float)up, (float)ahead), (float)turn);

    /// <summary>Goes down before a leap and pushes off out of that; gives way when it has come down.</summary>
    private static void Crouch(double tempo, double unit, double dt, ref FlightState state)
    {
        double running = Scalar.Smooth(Math.Abs(state.Ahead.Speed) / (RunningSpeed * unit));
        bool pushes = state.Phase == FlightPhase.Crouching && state.Age > PushTime;
        double depth = state.Phase switch
        {
            FlightPhase.Crouching => pushes ? -PushRise : 1,
            FlightPhase.Settling => 0.85 * (1 - (RunningStiffness * running)) * (1 - Scalar.Smooth(state.Age / (0.6 * SettleTime))),
            _ => 0,
        };
        state.Crouch.Step(depth, pushes || state.Phase == FlightPhase.Leaping ? 6 * tempo : 3.5 * tempo, dt);
    }

    /// <summary>Goes from one phase to the next. Heights, that below which it lands among them, are in leg lengths, time in √(leg/g).</summary>
    private static void Decide(FlightIntent intent, double height, double low, double time, ref FlightState state)
    {
        state.Age += time;
        bool up = intent == FlightIntent.Air;
        state.Unsupported = state.IsOnFeet && height > CliffHeight ? state.Unsupported + time : 0;
        bool falls = state.Unsupported > CliffTime;
        state.Fell = falls || (state.Fell && !up && state.Phase == FlightPhase.Airborne);
        FlightPhase next = falls ? FlightPhase.Airborne : state.Phase switch
        {
            FlightPhase.Grounded => up ? FlightPhase.Crouching : FlightPhase.Grounded,
            FlightPhase.Crouching => !up ? FlightPhase.Settling : state.Age >= CrouchTime ? FlightPhase.Leaping : FlightPhase.Crouching,
            FlightPhase.Leaping => height >= LeapHeight || state.Age >= 2 * LeapTime ? FlightPhase.Airborne : FlightPhase.Leaping,
            FlightPhase.Airborne => !up && height <= low ? FlightPhase.Landing : FlightPhase.Airborne,
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
