using CreatureGen.Maths;
using CreatureGen.Motion.Modes;

namespace CreatureGen.Motion.Flying;

/// <summary>Where a flier is in its motion. The default stands on the ground with folded wings; one for each creature on the scene, changed by <see cref="FlightMotion"/> alone.</summary>
internal struct FlightState
{
    /// <summary>Leg lengths above which height does not matter.</summary>
    internal const double HighEnough = 3;

    private const double Settled = 1e-3;

    internal double Cycle;
    internal double Age;

    /// <summary>When it is decided how it goes on, and what is left of the update where it has begun to do something else, seconds.</summary>
    internal DecisionClock Ticker;
    internal float Left;

    internal CriticallyDampedSpring Frequency;
    internal CriticallyDampedSpring Amplitude;
    internal CriticallyDampedSpring Effort;
    internal CriticallyDampedSpring Spread;
    internal CriticallyDampedSpring Flare;
    internal CriticallyDampedSpring Reach;
    internal Momentum Ahead;
    internal Momentum Rise;
    internal CriticallyDampedSpring Turn;
    internal double TurnGoal;

    /// <summary>Height of the root above the ground, metres of the model.</summary>
    internal double Above;

    /// <summary>Speed at which it began to reach for the ground, metres of the model per second; null while it does not.</summary>
    internal float? Foreseen;

    internal CriticallyDampedSpring Path;
    internal CriticallyDampedSpring Crouch;
    internal CriticallyDampedSpring Air;

    /// <summary>Share of how it is posed on its legs, and the share to which that goes.</summary>
    internal CriticallyDampedSpring Planted;
    internal double Planting;

    internal CriticallyDampedSpring Height;
    internal CriticallyDampedSpring Upright;

    /// <summary>For how long its feet have had no ground below them, √(leg/g), and whether it is coming down for that.</summary>
    internal double Unsupported;
    internal bool Fell;

    /// <summary>Speed ahead in those of cruise.</summary>
    internal double Cruises;

    /// <summary>Roll into its turn, radians, positive to the left.</summary>
    internal double Bank;

    /// <summary>−1..1, positive in a turn to the left.</summary>
    internal double Steer;

    /// <summary>Fastest speed ahead at which its legs can take over from its wings, metres per second; 0 where it comes to a stop as it lands.</summary>
    internal double RunOut;

    /// <summary>How much of its posture for standing its legs would have it in at this speed, 0..1.</summary>
    internal double Raised;

    /// <summary>Whether it has ground under its feet.</summary>
    internal readonly bool IsOnFeet => Phase is FlightPhase.Grounded or FlightPhase.Crouching or FlightPhase.Settling;

    /// <summary>How far it is down, in depths of a crouch; negative where it stretches.</summary>
    internal readonly double CrouchDepth => Scalar.Clamp(Crouch.Value, -0.3, 1);

    /// <summary>What it is doing between standing and flying.</summary>
    public FlightPhase Phase { get; internal set; }

    /// <summary>Downstrokes begun so far.</summary>
    public long Beats { get; internal set; }

    /// <summary>How many of them began in the last update.</summary>
    public int BeatsBegun { get; internal set; }

    /// <summary>How long before the end of the last update the latest of those began, seconds; 0 when none did.</summary>
    public float SecondsSinceBeat { get; internal set; }

    /// <summary>Metres of the model per second ahead at present.</summary>
    public readonly float Speed => (float)Ahead.Speed;

    /// <summary>Metres of the model per second up at present.</summary>
    public readonly float ClimbRate => (float)Rise.Speed;

    /// <summary>Beats per second at present.</summary>
    public readonly float BeatFrequency => (float)Frequency.Value;

    /// <summary>Width of the beat at present, 1 at cruise.</summary>
    public readonly float BeatWidth => (float)Amplitude.Value;

    /// <summary>How far it is off the ground in its posture: 0 stands, 1 flies. Where it is 0, legs, neck and tail may be moved by a walk instead.</summary>
    public readonly float Airborne => Phase == FlightPhase.Grounded && Air.Value < Settled ? 0f : (float)Air.Value;

    /// <summary>0 folded wings, 1 spread.</summary>
    public readonly float WingSpread => (float)Spread.Value;

    /// <summary>A flier that stands, as if it had always stood.</summary>
    internal static FlightState OnGround => new() { Planting = 1, Planted = CriticallyDampedSpring.At(1), Upright = CriticallyDampedSpring.At(1), Raised = 1 };

    /// <summary>A flier that hangs in the air on its wings, and begins to beat them.</summary>
    internal static FlightState Hovering(FlightProfile profile)
    {
        FlightState state = InAir(profile);
        state.Ahead = default;
        state.Cruises = 0;
        state.Amplitude = CriticallyDampedSpring.At(FlightControl.LowBeat);
        return state;
    }

    /// <summary>A flier in the air at cruise in standard gravity.</summary>
    /// <param name="profile">How the creature flies.</param>
    /// <exception cref="System.ArgumentNullException">There is no profile.</exception>
    public static FlightState InAir(FlightProfile profile)
    {
        if (profile == null)
        {
            throw new System.ArgumentNullException(nameof(profile));
        }

        return new FlightState
        {
            Phase = FlightPhase.Airborne,
            Frequency = CriticallyDampedSpring.At(profile.BeatFrequency),
            Amplitude = CriticallyDampedSpring.At(1),
            Effort = CriticallyDampedSpring.At(1),
            Spread = CriticallyDampedSpring.At(1),
            Ahead = Momentum.At(profile.CruiseSpeed),
            Cruises = 1,
            Air = CriticallyDampedSpring.At(1),
            Height = CriticallyDampedSpring.At(HighEnough * profile.LegLength),
        };
    }
}
