using System;

namespace CreatureGen.Genetics;

/// <summary>How offspring is bred.</summary>
public sealed record BreedingSettings
{
    private readonly double mutation = 0.2;

    /// <summary>A mutation of 0.2.</summary>
    public static BreedingSettings Default { get; } = new();

    /// <summary>How much a child differs from what it inherits, 0..1: 0 not at all, 0.2 as brothers and sisters do, 1 wildly, with new limbs now and then.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The value is not in 0..1.</exception>
    public double Mutation
    {
        get => mutation;
        init => mutation = value >= 0 && value <= 1 ? value : throw new ArgumentOutOfRangeException(nameof(value), value, "expected 0..1");
    }
}
