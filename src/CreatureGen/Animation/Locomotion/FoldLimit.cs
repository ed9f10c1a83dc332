using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Animation.Locomotion;

/// <summary>How far a hinge turns either way from rest, as cosines and sines: angles are bounded without an inverse function.</summary>
internal readonly struct FoldLimit
{
    private readonly double leastCosine;
    private readonly double leastSine;
    private readonly double mostCosine;
    private readonly double mostSine;

    public FoldLimit(AngleRange range)
    {
        PortableMath.SinCos(range.Min, out leastSine, out leastCosine);
        PortableMath.SinCos(range.Max, out mostSine, out mostCosine);
    }

    /// <summary>Brings an angle in −π..π, given by its cosine and sine, to the nearer end of the range if it is beyond.</summary>
    public void Clamp(ref double cosine, ref double sine)
    {
        if (sine < 0 && cosine < leastCosine)
        {
            cosine = leastCosine;
            sine = leastSine;
        }
        else if (sine > 0 && cosine < mostCosine)
        {
            cosine = mostCosine;
            sine = mostSine;
        }
    }
}
