using System;

namespace CreatureGen.Sampling;

/// <summary>Lists of choices with their relative probabilities.</summary>
internal static class Weights
{
    /// <summary>The choices in their order.</summary>
    public static Weighted<T>[] Of<T>(params (T Value, double Weight)[] choices) => Array.ConvertAll(choices, choice => new Weighted<T>(choice.Value, choice.Weight));
}
