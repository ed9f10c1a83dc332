namespace CreatureGen.Motion.Modes;

/// <summary>What bounds how a body gains and loses speed.</summary>
/// <param name="Thrust">Greatest acceleration from rest, m/s²; drag leaves the less of it the faster it goes.</param>
/// <param name="Braking">Deceleration by brakes, on top of drag, m/s²; 0 glides out.</param>
/// <param name="Drag">Deceleration by drag for each square of the speed, 1/m: a body that only glides loses half of its speed on 0.69 / Drag metres.</param>
/// <param name="Jerk">Greatest change of the acceleration, m/s³, above 0.</param>
internal readonly record struct MomentumLimits(double Thrust, double Braking, double Drag, double Jerk)
{
    /// <summary>How many times as quickly as it comes a push is let go of that leads away from what is asked.</summary>
    public double LettingGo { get; init; } = 1;

    /// <summary>The same with brakes so many times as strong.</summary>
    public MomentumLimits Braked(double factor) => this with { Braking = factor * Braking };

    /// <summary>The same where time runs so many times quicker and speeds are alike: what it reaches stays, and comes so much sooner.</summary>
    public MomentumLimits Quickened(double factor) => this with { Thrust = Thrust * factor, Braking = Braking * factor, Drag = Drag * factor, Jerk = Jerk * factor * factor };
}
