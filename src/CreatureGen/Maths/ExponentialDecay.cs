namespace CreatureGen.Maths;

/// <summary>The share 1 − e^(−x) of the way that something damped goes, remembered for as long as x is the same: steps of time seldom change.</summary>
internal struct ExponentialDecay
{
    private float last;
    private float fraction;

    /// <summary>The share for a rate times a time.</summary>
    public float Fraction(float x)
    {
        if (x != last)
        {
            last = x;
            fraction = 1f - (float)PortableMath.Exp(-x);
        }

        return fraction;
    }
}
