using System;

namespace CreatureGen.Species;

/// <summary>Lists of choices with their relative probabilities.</summary>
internal static class Weights
{
    /// <summary>The choices in their order.</summary>
    public static Weighted<T>[] Of<T>(params (T Value, double Weight)[] choices) => Array.ConvertAll(choices, choice => new Weighted<T>(choice.Value, choice.Weight));
}

/// <summary>A choice with its relative probability.</summary>
internal readonly struct Weighted<T>
{
    public Weighted(T value, double weight)
    {
        Value = value;
        Weight = weight;
    }

    public T Value { get; }

    public double Weight { get; }
}
