using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>A number that changes along a chain: smoothly from its root through its middle to its tip, or in straight lines through any number of keys.</summary>
public readonly struct ChainCurve
{
    private readonly float root;
    private readonly float middle;
    private readonly float tip;
    private readonly float[]? places;
    private readonly float[]? values;

    /// <summary>The same number all along.</summary>
    /// <exception cref="ArgumentException">The number is not finite.</exception>
    public ChainCurve(float all)
        : this(all, all, all)
    {
    }

    /// <summary>Evenly from root to tip.</summary>
    /// <exception cref="ArgumentException">A number is not finite.</exception>
    public ChainCurve(float root, float tip)
        : this(root, 0.5f * (root + tip), tip)
    {
    }

    /// <summary>The parabola through three numbers.</summary>
    /// <exception cref="ArgumentException">A number is not finite.</exception>
    public ChainCurve(float root, float middle, float tip)
    {
        Finite.Require(root, nameof(root));
        Finite.Require(middle, nameof(middle));
        Finite.Require(tip, nameof(tip));
        this.root = root;
        this.middle = middle;
        this.tip = tip;
        places = values = null;
    }

    private ChainCurve(float[] places, float[] values)
    {
        root = values[0];
        middle = 0f;
        tip = values[values.Length - 1];
        this.places = places;
        this.values = values;
    }

    /// <summary>In straight lines through keys, as curves drawn by hand and values of bone after bone are.</summary>
    /// <param name="places">Ascending, 0 the root, 1 the tip; before the first and after the last the curve is level.</param>
    /// <param name="values">One for each place.</param>
    /// <exception cref="ArgumentException">There is no key, not one value for each place, a place does not ascend or is outside 0 to 1, or a number is not finite.</exception>
    public static ChainCurve Through(ReadOnlySpan<float> places, ReadOnlySpan<float> values)
    {
        if (places.Length == 0 || places.Length != values.Length)
        {
            throw new ArgumentException(FormattableString.Invariant($"{places.Length} places and {values.Length} values; expected one of each, and at least one"), nameof(values));
        }

        for (int i = 0; i < places.Length; i++)
        {
            Finite.RequireWithin(places[i], i > 0 ? places[i - 1] : 0f, 1f, nameof(places));
            Finite.Require(values[i], nameof(values));
        }

        return new ChainCurve(places.ToArray(), values.ToArray());
    }

    /// <summary>The number at a place, 0 the root, 1 the tip.</summary>
    public float At(float along)
    {
        if (places != null)
        {
            return Between(places, values!, along);
        }

        float bend = (2f * (root + tip)) - (4f * middle);
        float slope = tip - root - bend;
        return root + (along * (slope + (along * bend)));
    }

    /// <summary>Whether two curves are the same.</summary>
    internal bool Is(ChainCurve other)
    {
        return root == other.root && middle == other.middle && tip == other.tip
            && (places == other.places || (places != null && other.places != null && places.AsSpan().SequenceEqual(other.places) && values.AsSpan().SequenceEqual(other.values)));
    }

    private static float Between(float[] places, float[] values, float along)
    {
        int next = 0;
        while (next < places.Length && places[next] < along)
        {
            next++;
        }

        if (next == 0 || next == places.Length)
        {
            return values[next == 0 ? 0 : next - 1];
        }

        float part = (along - places[next - 1]) / (places[next] - places[next - 1]);
        return Scalar.Lerp(values[next - 1], values[next], part);
    }
}
