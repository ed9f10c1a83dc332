using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>How long a stride is by the Froude number Fr = v²/(gℓ), in leg lengths: factor·Fr^exponent.</summary>
/// <remarks>Based on: R. McN. Alexander and A. S. Jayes, "A dynamic similarity hypothesis for the gaits of quadrupedal mammals" (1983).</remarks>
/// <param name="Factor">Leg lengths at Fr = 1.</param>
/// <param name="Exponent">Below one half, so that faster means quicker steps too.</param>
public readonly record struct StrideLaw(float Factor, float Exponent)
{
    /// <summary>Walks, trots and runs: 2.4·Fr^0.34.</summary>
    public static StrideLaw Symmetric { get; } = new(2.4f, 0.34f);

    /// <summary>Canters, gallops, bounds and hops: 1.9·Fr^0.40.</summary>
    public static StrideLaw Asymmetric { get; } = new(1.9f, 0.40f);

    /// <summary>Stride in leg lengths.</summary>
    public float At(float froude) => froude > 0f ? Factor * (float)PortableMath.Pow(froude, Exponent) : 0f;
}
