using System;

namespace CreatureGen.Motion;

/// <summary>How large a part of the cycle a foot is down, by the Froude number Fr = v²/(gℓ): intercept − slope·√Fr between two ends.</summary>
/// <param name="Intercept">Part of the cycle at no speed.</param>
/// <param name="Slope">By how much it falls with √Fr.</param>
/// <param name="Min">Lower end, above 0.</param>
/// <param name="Max">Upper end, below 1.</param>
public readonly record struct DutyLaw(float Intercept, float Slope, float Min, float Max)
{
    /// <summary>Part of the cycle that a foot is down.</summary>
    public float At(float froude) => Math.Min(Math.Max(Intercept - (Slope * (float)Math.Sqrt(froude)), Min), Max);
}
