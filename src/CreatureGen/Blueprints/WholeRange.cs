using System.Globalization;

namespace CreatureGen.Blueprints;

/// <summary>The whole numbers, or the even ones, from a least to a greatest, both included.</summary>
internal readonly struct WholeRange
{
    private readonly int step;

    /// <summary>All whole numbers of the range.</summary>
    public WholeRange(int minimum, int maximum)
        : this(minimum, maximum, 1)
    {
    }

    private WholeRange(int minimum, int maximum, int step)
    {
        Minimum = minimum;
        Maximum = maximum;
        this.step = step;
    }

    public int Minimum { get; }

    public int Maximum { get; }

    /// <summary>The even numbers of the range.</summary>
    public static WholeRange Even(int minimum, int maximum) => new(minimum, maximum, 2);

    /// <summary>Whether the number is in the range.</summary>
    public bool Contains(int value) => value >= Minimum && value <= Maximum && value % step == 0;

    /// <summary>The bounds, as a message says them.</summary>
    public string Bounds() => Text(Minimum) + (Minimum == Maximum ? "" : ".." + Text(Maximum));

    /// <summary>What is expected of a number, as a message says it.</summary>
    public override string ToString() => Minimum == Maximum ? Bounds() : (step == 2 ? "an even number " : "a whole number ") + Bounds();

    private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);
}
