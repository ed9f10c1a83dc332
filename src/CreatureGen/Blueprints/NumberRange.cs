using CreatureGen.Json;

namespace CreatureGen.Blueprints;

/// <summary>The numbers from a least to a greatest, both included.</summary>
internal readonly struct NumberRange
{
    public NumberRange(double minimum, double maximum)
    {
        Minimum = minimum;
        Maximum = maximum;
    }

    public double Minimum { get; }

    public double Maximum { get; }

    /// <summary>Whether the number is in the range; NaN is in none.</summary>
    public bool Contains(double value) => value >= Minimum && value <= Maximum;

    /// <summary>What is expected of a number, as a message says it.</summary>
    public override string ToString() => NumberText.Of(Minimum) + ".." + NumberText.Of(Maximum);
}
