namespace CreatureGen.Maths;

/// <summary>A number that follows a target without overshoot and without a jump of its rate: a critically damped spring, stepped in closed form.</summary>
/// <remarks>
/// The step is the exact solution for a target that holds during the step, so that the value at a time does not depend on how that time was cut into steps,
/// and no step is too long for it. Its integral is exact as well: phases driven by a smoothed frequency agree at every frame rate.
/// </remarks>
internal struct Smoothed
{
    /// <summary>The value.</summary>
    public double Value;

    /// <summary>Its change per second.</summary>
    public double Rate;

    /// <summary>A value at rest.</summary>
    public static Smoothed At(double value) => new() { Value = value };

    /// <summary>Moves on and gives the integral of the value over the step.</summary>
    /// <param name="target">Where to.</param>
    /// <param name="sharpness">Natural frequency, 1/s, above 0: 63 % of a step of the target are done after about 2 / sharpness.</param>
    /// <param name="dt">Seconds, not negative.</param>
    public double Step(double target, double sharpness, double dt)
    {
        if (dt <= 0)
        {
            return 0;
        }

        double away = Value - target;
        double c = Rate + (sharpness * away);
        double decay = PortableMath.Exp(-sharpness * dt);
        double gone = 1 - decay;
        Value = target + ((away + (c * dt)) * decay);
        Rate = (Rate - (sharpness * c * dt)) * decay;
        return (target * dt) + (away * gone / sharpness) + (c * ((gone / sharpness) - (dt * decay)) / sharpness);
    }
}
