using System;
using System.Globalization;

namespace CreatureGen.Maths;

/// <summary>
/// Piecewise cubic Hermite interpolation that never overshoots its data (PCHIP).
/// </summary>
/// <remarks>Based on: F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic interpolants" (1984); end slopes are the three-point formula of Moler.</remarks>
internal static class MonotoneCubic
{
    /// <summary>Slopes at the knots; all spans have the length of <paramref name="knots"/> (at least 2).</summary>
    /// <param name="knots">Strictly ascending.</param>
    /// <param name="values">Finite values at the knots.</param>
    /// <param name="slopes">Filled with the slopes that both <c>Evaluate</c> methods take.</param>
    /// <exception cref="ArgumentException">The lengths differ or are less than 2, or the knots do not ascend.</exception>
    public static void Slopes(ReadOnlySpan<double> knots, ReadOnlySpan<double> values, Span<double> slopes)
    {
        if (knots.Length < 2 || values.Length != knots.Length || slopes.Length != knots.Length)
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "{0} knots, {1} values and {2} slopes; expected the same number of each, at least 2", knots.Length, values.Length, slopes.Length), nameof(knots));
        }

        for (int i = 1; i < knots.Length; i++)
        {
            if (!(knots[i] > knots[i - 1]))
            {
                throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "knots[{0}] = {1:R} after {2:R}; expected strictly ascending knots", i, knots[i], knots[i - 1]), nameof(knots));
            }
        }

        int last = knots.Length - 1;
        if (last == 1)
        {
            slopes[0] = slopes[1] = (values[1] - values[0]) / (knots[1] - knots[0]);
            return;
        }

        for (int i = 1; i < last; i++)
        {
            double h0 = knots[i] - knots[i - 1];
            double h1 = knots[i + 1] - knots[i];
            double d0 = (values[i] - values[i - 1]) / h0;
            double d1 = (values[i + 1] - values[i]) / h1;
            if (d0 * d1 <= 0)
            {
                slopes[i] = 0;
                continue;
            }

            double w0 = (2 * h1) + h0;
            double w1 = h1 + (2 * h0);
            slopes[i] = (w0 + w1) / ((w0 / d0) + (w1 / d1));
        }

        slopes[0] = EndSlope(knots[1] - knots[0], knots[2] - knots[1], (values[1] - values[0]) / (knots[1] - knots[0]), (values[2] - values[1]) / (knots[2] - knots[1]));
        slopes[last] = EndSlope(
            knots[last] - knots[last - 1],
            knots[last - 1] - knots[last - 2],
            (values[last] - values[last - 1]) / (knots[last] - knots[last - 1]),
            (values[last - 1] - values[last - 2]) / (knots[last - 1] - knots[last - 2]));
    }

    /// <summary>The curve's value at <paramref name="x"/> within the span that starts at knot <paramref name="interval"/>.</summary>
    public static double Evaluate(ReadOnlySpan<double> knots, ReadOnlySpan<double> values, ReadOnlySpan<double> slopes, int interval, double x)
    {
        double h = knots[interval + 1] - knots[interval];
        double t = (x - knots[interval]) / h;
        double u = 1 - t;
        return (values[interval] * u * u * (1 + (2 * t)))
            + (values[interval + 1] * t * t * (3 - (2 * t)))
            + (slopes[interval] * h * t * u * u)
            - (slopes[interval + 1] * h * t * t * u);
    }

    /// <summary>The curve's value at any <paramref name="x"/>, clamped to the ends.</summary>
    public static double Evaluate(ReadOnlySpan<double> knots, ReadOnlySpan<double> values, ReadOnlySpan<double> slopes, double x)
    {
        int last = knots.Length - 1;
        if (x <= knots[0])
        {
            return values[0];
        }

        if (x >= knots[last])
        {
            return values[last];
        }

        int interval = 0;
        while (x >= knots[interval + 1])
        {
            interval++;
        }

        return Evaluate(knots, values, slopes, interval, x);
    }

    private static double EndSlope(double h0, double h1, double d0, double d1)
    {
        double slope = ((((2 * h0) + h1) * d0) - (h0 * d1)) / (h0 + h1);
        if (slope * d0 <= 0)
        {
            return 0;
        }

        return d0 * d1 < 0 && Math.Abs(slope) > Math.Abs(3 * d0) ? 3 * d0 : slope;
    }
}
