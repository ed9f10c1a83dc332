using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Modes;

/// <summary>A speed that has weight: it goes towards what is asked with bounded acceleration and bounded jerk, by thrust against drag, and slows down by drag and brakes.</summary>
/// <remarks>
/// Planned for 1/240 s at most; in each of these times the acceleration goes towards what is wanted, by no more than the jerk allows, evenly: the way is a cubic, however it is cut. Wanted is what thrust leaves over
/// drag, or drag and brake together: a push that leads away from the goal may be let go of sooner than it came; and near the goal √(j·e), e the speed that is missing, and then in proportion to it: acceleration that ends there without a step and without going beyond.
/// </remarks>
internal struct Momentum
{
    private const double LongestStep = 1.0 / 240;

    /// <summary>How much of the greatest acceleration is left where the last of the way to the goal begins: 1 over it.</summary>
    private const double Settling = 3;

    /// <summary>Metres per second.</summary>
    public double Speed;

    /// <summary>Metres per second squared.</summary>
    public double Acceleration;

    /// <summary>Something that goes at a steady speed.</summary>
    public static Momentum At(double speed) => new() { Speed = speed };

    /// <summary>Change of the acceleration, metres per second cubed, that <see cref="Plan"/> found.</summary>
    private double jerk;

    /// <summary>Moves on.</summary>
    /// <param name="goal">Metres per second that are asked for.</param>
    /// <param name="limits">What bounds it.</param>
    /// <param name="dt">Seconds, not negative.</param>
    /// <returns>The way gone, metres.</returns>
    public double Step(double goal, in MomentumLimits limits, double dt)
    {
        int steps = (int)Math.Ceiling((dt / LongestStep) - 1e-6);
        double h = dt / Math.Max(steps, 1);
        double way = 0;
        for (int i = 0; i < steps; i++)
        {
            Plan(goal, limits, h);
            way += Advance(h);
        }

        return way;
    }

    /// <summary>Finds how its acceleration is to change in a time, for <see cref="Advance"/> to go through that in steps of any length.</summary>
    /// <param name="goal">Metres per second that are asked for.</param>
    /// <param name="limits">What bounds it.</param>
    /// <param name="period">Seconds until the next plan, above 0 and at most 1/240.</param>
    public void Plan(double goal, in MomentumLimits limits, double period)
    {
        double settle = Settling * limits.Jerk / Math.Max(Math.Max(limits.Thrust, limits.Braking), 1e-9);
        double missing = goal - Speed;
        double size = Math.Abs(missing);
        double drag = limits.Drag * Speed * Speed;
        double max = Speed * missing < 0 ? limits.Braking + drag : limits.Thrust - drag;
        double wanted = Math.Min(max, Math.Min(Math.Sqrt(limits.Jerk * size), settle * size));
        double most = Acceleration * missing < 0 ? Math.Min(limits.LettingGo * limits.Jerk, (Math.Abs(Acceleration) / period) + limits.Jerk) : limits.Jerk;
        jerk = Scalar.Clamp(((missing < 0 ? -wanted : wanted) - Acceleration) / period, -most, most);
    }

    /// <summary>Goes on as planned.</summary>
    /// <param name="dt">Seconds, not negative.</param>
    /// <returns>The way gone, metres.</returns>
    public double Advance(double dt)
    {
        double way = dt * (Speed + (dt * ((0.5 * Acceleration) + (dt * jerk / 6))));
        Speed += dt * (Acceleration + (0.5 * dt * jerk));
        Acceleration += dt * jerk;
        return way;
    }
}
