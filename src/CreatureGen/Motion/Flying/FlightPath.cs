using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion.Flying;

/// <summary>
/// How a flier travels: from the ground into the air and back, ahead, up and round. What it goes for is decided at fixed moments and gone through exactly between them, so that its way is the same at every
/// frame rate.
/// </summary>
internal static class FlightPath
{
    /// <summary>Leg lengths above the ground at which landing begins.</summary>
    public const double LandingHeight = 2.2;

    /// <summary>Time, √(leg/g), that it crouches, leaps and gives way for after a touchdown.</summary>
    public const double CrouchTime = 1.4;
    public const double LeapTime = 1.2;
    public const double SettleTime = 1.6;

    /// <summary>Leg lengths above the ground below which a flier that is to stay in the air does not go.</summary>
    public const double LowestFlight = 1.2;

    /// <summary>Seconds between two decisions.</summary>
    private const float Period = 1f / 240f;

    /// <summary>Tangent of the steepest bank of a steady turn, 1.05 rad.</summary>
    private const double TangentOfBank = 1.743;

    /// <summary>How much more sharply than the rest of its motion its turning follows what is asked.</summary>
    private const double TurnSharpness = 1.2;

    /// <summary>Leg lengths above the ground at which a leap is over, at which legs begin to be set down, and at which its feet are where they will stand.</summary>
    private const double LeapHeight = 1.2;
    private const double PlantingHeight = 0.4;
    private const double PlantedHeight = 0.03;

    /// <summary>Deceleration of its fall near the ground, in parts of gravity, and time, √(leg/g), within which it need not wait to come down before it is slow enough to run.</summary>
    private const double Cushion = 0.4;
    private const double ShortBrake = 0.15;

    /// <summary>How quickly what stays in the air comes to its lowest height in the end, √(g/leg).</summary>
    private const double FloorResponse = 1;

    /// <summary>Leg lengths above the ground at which legs no longer carry it, the time, √(leg/g), after which it takes to its wings for that, and how fast it then comes down, cruises.</summary>
    private const double CliffHeight = 0.6;
    private const double CliffTime = 0.1;
    private const double CliffDescent = 0.3;

    /// <summary>Fastest climb and dive, cruises.</summary>
    private const double FastestClimb = 0.6;
    private const double FastestDive = 1.5;

    /// <summary>Speed of touchdown, in √(g·leg).</summary>
    private const double Touchdown = 0.25;

    /// <summary>Goes on until the time is over, or until it does something else: what is left of the time then is in the state.</summary>
    /// <param name="profile">How the creature flies.</param>
    /// <param name="input">What it is to do.</param>
    /// <param name="state">Where it is in its motion.</param>
    /// <param name="dt">Seconds.</param>
    public static FlightWay Travel(FlightProfile profile, in FlightInput input, ref FlightState state, float dt)
    {
        double gravity = input.Gravity;
        double tempo = Math.Sqrt(gravity / profile.LegLength);
        MomentumLimits along = profile.MomentumIn(gravity).Quickened((input.Settings ?? FlyingSettings.Default).SpeedResponse);
        FlightPhase phase = state.Phase;
        var way = default(FlightWay);
        state.Above = Math.Max(input.Height, 0);
        state.Left = dt;
        while (state.Left > 0f && state.Phase == phase)
        {
            if (state.Ticker.Begins)
            {
                Plan(profile, input, along, ref state);
            }

            float h = state.Ticker.Next(ref state.Left, Period);
            double ahead = state.Ahead.Advance(h);
            double turned = state.Turn.Step(state.TurnGoal, TurnSpeed(profile, input), h);
            double up = Math.Max(state.Rise.Advance(h), -state.Above);
            state.Above += up;
            way = way.Then(ahead, up, turned, h);
            if (state.Ticker.Decides)
            {
                Decide(input.Intent, state.Above / profile.LegLength, Low(profile, gravity, state), Period * tempo, ref state);
            }
        }

        return way;
    }

    /// <summary>The speed ahead that it goes for: to land, what its legs can run.</summary>
    public static double GoalAhead(in FlightState state, double speed) => state.Phase switch
    {
        FlightPhase.Landing => Scalar.Clamp(speed, 0, state.RunOut),
        FlightPhase.Crouching or FlightPhase.Settling => 0,
        _ => speed,
    };

    /// <summary>The climb that it is asked for, as far as it can: metres per second.</summary>
    public static double Climb(FlightProfile profile, in FlightInput input, in FlightState state)
    {
        double cruise = profile.CruiseIn(input.Gravity);
        double climb = state.Fell ? Math.Min(input.ClimbRate, -CliffDescent * cruise) : input.ClimbRate;
        return Scalar.Clamp(climb, -FastestDive * cruise, FastestClimb * cruise);
    }

    /// <summary>How far it is to be posed on its legs as it comes down to them, 0..1.</summary>
    public static double Planting(FlightProfile profile, in FlightState state) => state.Phase switch
    {
        FlightPhase.Landing => 1 - Scalar.Smooth(((state.Above / profile.LegLength) - PlantedHeight) / (PlantingHeight - PlantedHeight)),
        FlightPhase.Airborne or FlightPhase.Leaping => 0,
        _ => 1,
    };

    /// <summary>Finds what it goes for until the next decision.</summary>
    private static void Plan(FlightProfile profile, in FlightInput input, in MomentumLimits along, ref FlightState state)
    {
        double gravity = input.Gravity;
        double goal = GoalAhead(state, input.Speed);

        // To land it brakes with all it has.
        double brakes = state.Phase == FlightPhase.Landing ? 1 : (input.Settings ?? FlyingSettings.Default).Braking;
        state.Ahead.Plan(goal, along.Braked(brakes), Period);
        PlanTurn(profile, input, ref state);
        PlanRise(profile, goal, Climb(profile, input, state), gravity, ref state);
        if (state.Phase != FlightPhase.Landing)
        {
            state.Foreseen = null;
        }
        else if (Planting(profile, state) > 0)
        {
            state.Foreseen ??= state.Speed;
        }
    }

    /// <summary>ω of its turning, s⁻¹.</summary>
    private static double TurnSpeed(FlightProfile profile, in FlightInput input) =>
        TurnSharpness * profile.Response * FlightProfile.Tempo(input.Gravity) * (input.Settings ?? FlyingSettings.Default).YawResponse;

    /// <summary>Turns as far as its bank lets it.</summary>
    private static void PlanTurn(FlightProfile profile, in FlightInput input, ref FlightState state)
    {
        double agility = profile.Response * FlightProfile.Tempo(input.Gravity);
        double fastest = Math.Min(agility, input.Gravity * TangentOfBank / Math.Max(Math.Abs(state.Ahead.Speed), 1e-6));
        bool steers = state.Phase is not (FlightPhase.Crouching or FlightPhase.Settling);
        state.TurnGoal = steers ? Scalar.Clamp(input.YawRate, -fastest, fastest) : 0;
    }

    /// <summary>Rises and sinks.</summary>
    private static void PlanRise(FlightProfile profile, double goal, double climb, double gravity, ref FlightState state)
    {
        double leg = profile.LegLength;
        switch (state.Phase)
        {
            case FlightPhase.Leaping:
                // Its legs push it.
                state.Rise = Momentum.At(Math.Max(climb, 1.5 * Math.Sqrt(gravity * leg)) * (0.35 + (0.65 * Scalar.Smooth(2 * state.Age / LeapTime))));
                break;
            case FlightPhase.Landing:
                state.Rise.Plan(-Descent(profile, goal, gravity, state), profile.LiftIn(gravity), Period);
                break;
            case FlightPhase.Airborne:
                state.Rise.Plan(Math.Max(climb, LowestClimb(state.Above - (LowestFlight * leg), leg, gravity)), profile.LiftIn(gravity), Period);
                break;
            default:
                state.Rise = default;
                break;
        }
    }

    /// <summary>How fast it comes down to land: not before it is slow enough to run, and ever slower near the ground.</summary>
    private static double Descent(FlightProfile profile, double goal, double gravity, in FlightState state)
    {
        double unit = Math.Sqrt(gravity * profile.LegLength);
        double touch = Touchdown * unit;
        double braking = Math.Max(state.Ahead.Speed - goal, 0) / (profile.Braking * gravity);
        double soft = Math.Sqrt((touch * touch) + (2 * Cushion * gravity * state.Above));
        double wait = ShortBrake * profile.LegLength / unit;
        return braking <= wait ? soft : Math.Min(soft, state.Above / (braking - wait));
    }

    /// <summary>The least climb of a flier that stays in the air: it does not fly into the ground. Where there is much room it slows down evenly; the last of it it goes in proportion, or it would go up and down about its lowest height for good.</summary>
    private static double LowestClimb(double room, double leg, double gravity)
    {
        double rate = FloorResponse * Math.Sqrt(gravity / leg);
        double even = Cushion * gravity;
        double last = even / (rate * rate);
        double far = Math.Abs(room);
        double steady = far < last ? rate * far : Math.Sqrt(2 * even * (far - (0.5 * last)));
        return room > 0 ? -steady : Math.Min(steady, Math.Sqrt(gravity * leg));
    }

    /// <summary>Leg lengths above the ground at which it begins to land: the higher the faster it sinks.</summary>
    private static double Low(FlightProfile profile, double gravity, in FlightState state)
    {
        double sinking = Math.Max(-state.Rise.Speed, 0);
        return LandingHeight + (sinking * sinking / (2 * Cushion * gravity * profile.LegLength));
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
}
