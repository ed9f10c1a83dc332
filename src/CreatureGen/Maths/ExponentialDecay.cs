using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>The share 1 − e^(−x) of the way that something damped goes, remembered for as long as x is the same: steps of time seldom change.</summary>
internal struct ExponentialDecay
{
    private float last;
    private float fraction;

    /// <summary>The share for a rate times a time.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public float Fraction(float x) => x == last ? fraction : Find(x);

    private float Find(float x)
    {
        last = x;
        fraction = 1f - (float)PortableMath.Exp(-x);
        return fraction;
    }
}
