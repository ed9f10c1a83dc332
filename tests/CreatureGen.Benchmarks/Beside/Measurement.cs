using System;
using System.Linq;

namespace CreatureGen.Benchmarks.Beside;

/// <summary>Times of one row, each as the fastest round of every item.</summary>
/// <param name="Comparison">The row.</param>
/// <param name="Then">Of the earlier commit.</param>
/// <param name="Now">Of this library.</param>
/// <param name="Untiered">The same without the tiers of the compiler.</param>
/// <param name="Peer">Of a peer; null where none was measured.</param>
internal sealed record Measurement(Comparison Comparison, Times Then, Times Now, Times Untiered, Times? Peer)
{
    /// <summary>Of the earlier commit in the runtime for browsers; null where not measured.</summary>
    public Times? BrowserThen { get; init; }

    /// <summary>Of this library there.</summary>
    public Times? BrowserNow { get; init; }
}

/// <summary>Microseconds of the middle item and of the dearest but one in a hundred.</summary>
internal readonly record struct Times(double Median, double P99)
{
    /// <summary>Those of items' nanoseconds.</summary>
    public static Times Of(double[] nanoseconds)
    {
        double[] sorted = nanoseconds.Order().ToArray();
        return new Times(sorted[sorted.Length / 2] / 1000, sorted[(int)(0.99 * (sorted.Length - 1))] / 1000);
    }

    /// <inheritdoc/>
    public override string ToString() => FormattableString.Invariant($"{Median} µs, p99 {P99} µs");
}
