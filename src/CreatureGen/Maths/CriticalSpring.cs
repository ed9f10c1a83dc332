namespace CreatureGen.Maths;

/// <summary>A number that goes to its goal as fast as it can without swinging through, starting and arriving smoothly: a critically damped spring, exact for any time step.</summary>
/// <remarks>
/// x″ = ω²(goal − x) − 2ωx′, with d = x − goal: x(t) = goal + (d + (x′ + ωd)t)e^(−ωt), x′(t) = (x′ − ω(x′ + ωd)t)e^(−ωt). 90 % of the way is done at t = 3.9/ω.
/// Based on: R. Juckett, "Damped springs" (2012).
/// </remarks>
public static class CriticalSpring
{
    /// <summary>Lets time pass.</summary>
    /// <param name="x">The number.</param>
    /// <param name="velocity">Its change per second.</param>
    /// <param name="goal">Where it goes, the same during the whole step.</param>
    /// <param name="rate">ω, s⁻¹, not negative.</param>
    /// <param name="seconds">Not negative.</param>
    public static void Advance(ref float x, ref float velocity, float goal, float rate, float seconds) => Advance(ref x, ref velocity, goal, rate, seconds, PortableMath.Exp(-(double)rate * seconds));

    /// <summary>The same, with e^(−ω · seconds) given: several numbers on the same spring share it.</summary>
    internal static void Advance(ref float x, ref float velocity, float goal, float rate, float seconds, double left)
    {
        double away = (double)x - goal;
        double push = velocity + (rate * away);
        x = (float)(goal + ((away + (push * seconds)) * left));
        velocity = (float)((velocity - (rate * push * seconds)) * left);
    }
}
