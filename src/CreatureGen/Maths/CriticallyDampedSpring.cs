namespace CreatureGen.Maths;

/// <summary>A number that goes to its goal as fast as it can without swinging through, starting and arriving smoothly: a critically damped spring, exact for any time step.</summary>
/// <remarks>
/// <para>x″ = ω²(goal − x) − 2ωx′, with d = x − goal: x(t) = goal + (d + (x′ + ωd)t)e^(−ωt), x′(t) = (x′ − ω(x′ + ωd)t)e^(−ωt). 90 % of the way is done at t = 3.9/ω.</para>
/// <para>The step is the exact solution for a goal that holds during it, so that the value at a time does not depend on how that time was cut into steps, and no step is too long for it. Its integral is
/// exact as well: phases driven by such a frequency agree at every frame rate.</para>
/// <para>Based on: R. Juckett, "Damped springs" (2012).</para>
/// </remarks>
public struct CriticallyDampedSpring
{
    /// <summary>The value.</summary>
    public double Value;

    /// <summary>Its change per second.</summary>
    public double Rate;

    /// <summary>A value at rest.</summary>
    public static CriticallyDampedSpring At(double value) => new() { Value = value };

    /// <summary>Moves on and gives the integral of the value over the step.</summary>
    /// <param name="goal">Where to, the same during the whole step.</param>
    /// <param name="frequency">ω, s⁻¹, above 0.</param>
    /// <param name="seconds">Not negative.</param>
    public double Step(double goal, double frequency, double seconds)
    {
        if (seconds <= 0)
        {
            return 0;
        }

        double away = Value - goal;
        double c = Rate + (frequency * away);

        // What rests has nothing that could fade: most springs of a walker and of a fish do, and half of a flier's.
        double decay = away == 0 && Rate == 0 ? 0 : PortableMath.Exp(-frequency * seconds);
        double gone = 1 - decay;
        Value = goal + ((away + (c * seconds)) * decay);
        Rate = (Rate - (frequency * c * seconds)) * decay;
        return (goal * seconds) + (away * gone / frequency) + (c * ((gone / frequency) - (seconds * decay)) / frequency);
    }

    /// <summary>Lets time pass for a number in single precision.</summary>
    /// <param name="x">The number.</param>
    /// <param name="velocity">Its change per second.</param>
    /// <param name="goal">Where it goes, the same during the whole step.</param>
    /// <param name="frequency">ω, s⁻¹, not negative.</param>
    /// <param name="seconds">Not negative.</param>
    public static void Advance(ref float x, ref float velocity, float goal, float frequency, float seconds) =>
        Advance(ref x, ref velocity, goal, frequency, seconds, PortableMath.Exp(-(double)frequency * seconds));

    /// <summary>The same, with e^(−ω · seconds) given: several numbers on the same spring share it.</summary>
    internal static void Advance(ref float x, ref float velocity, float goal, float frequency, float seconds, double decay)
    {
        double away = (double)x - goal;
        double push = velocity + (frequency * away);
        x = (float)(goal + ((away + (push * seconds)) * decay));
        velocity = (float)((velocity - (frequency * push * seconds)) * decay);
    }
}
