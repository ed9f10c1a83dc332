using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Modes;

/// <summary>A speed that has weight: it goes towards what is asked with bounded acceleration and bounded jerk, by thrust against drag, and slows down by drag and brakes.</summary>
/// <remarks>
/// Inner steps of 1/240 s at most; in each the acceleration goes towards what is wanted, by no more than the jerk allows, and the speed follows by the trapezoidal rule. Wanted is what thrust leaves over drag, or
/// drag and brake together; and near the goal √(j·e), e the speed that is missing, and then in proportion to it: acceleration that ends there without a step and without going beyond.
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

    /// <summary>Moves on.</summary>
    /// <param name="goal">Metres per second that are asked for.</param>
    /// <param name="limits">What bounds it.</param>
    /// <param name="dt">Seconds, not negative.</param>
    /// <returns>The way gone, metres.</returns>
    public double Step(double goal, in MomentumLimits limits, double dt)
    {
        int steps = (int)Math.Ceiling((dt / LongestStep) - 1e-6);
        double h = dt / Math.Max(steps, 1);
        double jerk = limits.Jerk;
        double settle = Settling * jerk / Math.Max(Math.Max(limits.Thrust, limits.Braking), 1e-9);
        double way = 0;
        for (int i = 0; i < steps; i++)
        {
            double missing = goal - Speed;
            double size = Math.Abs(missing);
            double drag = limits.Drag * Speed * Speed;
            double max = Speed * missing < 0 ? limits.Braking + drag : limits.Thrust - drag;
            double wanted = Math.Min(max, Math.Min(Math.Sqrt(jerk * size), settle * size));
            double change = Scalar.Clamp((missing < 0 ? -wanted : wanted) - Acceleration, -jerk * h, jerk * h);
            double next = Speed + (h * (Acceleration + (0.5 * change)));
            Acceleration += change;
            way += 0.5 * h * (Speed + next);
            Speed = next;
        }

        return way;
    }
}
