using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Toolkit.Chains;

namespace CreatureGen.Motion.Flying;

/// <summary>Steps what swings with the way of a flier: beat, effort, spread and flare of its wings, bank, pitch and crouch.</summary>
internal static class FlightControl
{
    /// <summary>Shares of the speed of cruise below which a flier hovers more than it flies.</summary>
    private const double HoverFraction = 0.45;

    private const double SteepestPath = 1.2;

    /// <summary>Radians that it leans at most, whatever is set.</summary>
    private const double SteepestBank = 1.3;

    /// <summary>Effort at level cruise of a flier that glides between beats; 1 never glides, 0 only glides.</summary>
    private const double LevelEffort = 0.66;

    /// <summary>When it pushes itself off out of the crouch, and how far beyond standing, in depths of the crouch.</summary>
    private const double PushTime = 1.0;
    private const double PushRise = 0.25;

    /// <summary>Share of its beat that a flier without legs makes on the ground.</summary>
    public const double LowBeat = 0.2;

    /// <summary>Cruises that are missing at which it works its hardest to get faster; cruises too many at which it does to get slower.</summary>
    private const double PushingGap = 0.4;
    private const double BrakingGap = 0.35;

    /// <summary>How far the wings are flared to get slower, 1 to land.</summary>
    private const double BrakingFlare = 0.7;

    /// <summary>Greatest width of the beat, 1 at cruise.</summary>
    private const double WidestBeat = 1.5;

    /// <summary>Speed in √(g·leg) from which on a flier that leaps or comes down runs, and gives way the less: legs that swing have no room under a body that is low.</summary>
    private const double RunningSpeed = 0.45;
    private const double RunningStiffness = 0.9;

    /// <summary>How much quicker it beats as it hovers, climbs and leaps, parts of the beats at cruise.</summary>
    private const double HoverBeats = 0.22;
    private const double ClimbBeats = 0.15;
    private const double LeapBeats = 0.25;

    /// <summary>Spread below which a turn of the cycle is no beat.</summary>
    private const double SpreadForBeat = 0.3;

    /// <summary>How much it hovers, 0..1, at so many times the speed of cruise.</summary>
    public static double Hover(double cruises) => 1 - Scalar.Smooth(Math.Abs(cruises) / HoverFraction);

    /// <summary>Steps what swings with its way.</summary>
    /// <param name="profile">How the creature flies.</param>
    /// <param name="input">What it is to do.</param>
    /// <param name="way">What it has travelled.</param>
    /// <param name="state">Where it is in its motion, at the end of that way.</param>
    public static void Advance(FlightProfile profile, in FlightInput input, in FlightWay way, ref FlightState state)
    {
        double gravity = input.Gravity;
        FlyingSettings settings = input.Settings ?? FlyingSettings.Default;
        double dt = way.Seconds;
        double height = state.Above;
        double leg = profile.LegLength;
        double tempo = Math.Sqrt(gravity / leg);
        bool flying = state.Phase is FlightPhase.Airborne or FlightPhase.Leaping or FlightPhase.Landing;
        bool down = state.Phase is FlightPhase.Grounded or FlightPhase.Settling;
        double cruise = profile.CruiseIn(gravity);
        double k = profile.Response * FlightProfile.Tempo(gravity);
        double goal = FlightPath.GoalAhead(state, input.Speed);
        double climb = FlightPath.Climb(profile, input, state);
        state.Cruises = state.Ahead.Speed / cruise;

        // What is integrated goes by the mean of the step, so that frame rates agree.
        double mean = dt > 0 ? way.Ahead / dt : state.Ahead.Speed;
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
        double landing = state.Phase == FlightPhase.Landing ? Scalar.Smooth((FlightPath.LandingHeight - (height / leg)) / (0.6 * FlightPath.LandingHeight)) : 0;

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
        state.Planting = FlightPath.Planting(profile, state);
        state.Planted.Step(state.Planting, state.Planting > 0 ? 60 * tempo : 4 * tempo, dt);
        state.Height.Step(Math.Min(height, FlightState.HighEnough * leg), 20 * tempo, dt);
    }

    /// <summary>Radians per second with which thin wings turn at their root at most: they beat quickest and widest.</summary>
    public static double FastestBlade(FlightProfile profile) =>
        2 * PortableMath.Pi * profile.BeatFrequency * (1 + HoverBeats + ClimbBeats + LeapBeats) * WidestBeat * BuzzPair.WidestSteer * BuzzPair.FastestBlade;

    /// <summary>How much of its beat a flier that has no legs to stand on makes so far above the ground, 0..1: wings of one that lies on it would beat into it.</summary>
    private static double Room(FlightProfile profile, double height) =>
        profile.Stands ? 1 : Scalar.Lerp(LowBeat, 1, Scalar.Smooth(height / (FlightPath.LowestFlight * profile.LegLength)));

    /// <summary>Goes down before a leap and pushes off out of that; gives way when it has come down.</summary>
    private static void Crouch(double tempo, double unit, double dt, ref FlightState state)
    {
        double soft = 1 - (RunningStiffness * Scalar.Smooth(Math.Abs(state.Ahead.Speed) / (RunningSpeed * unit)));
        bool pushes = state.Phase == FlightPhase.Crouching && state.Age > PushTime;
        double depth = state.Phase switch
        {
            FlightPhase.Crouching => pushes ? -PushRise : soft,
            FlightPhase.Settling => 0.85 * soft * (1 - Scalar.Smooth(state.Age / (0.6 * FlightPath.SettleTime))),
            _ => 0,
        };
        state.Crouch.Step(depth, pushes || state.Phase == FlightPhase.Leaping ? 6 * tempo : 3.5 * tempo, dt);
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
