using System.Runtime.CompilerServices;

namespace CreatureGen.Maths;

/// <summary>Sums and products of doubles together with their rounding errors.</summary>
/// <remarks>Based on: T. J. Dekker, "A floating-point technique for extending the available precision" (1971); D. E. Knuth, "The Art of Computer Programming", volume 2, section 4.2.2.</remarks>
internal static class ErrorFree
{
    private const double Splitter = (1 << 27) + 1;

    /// <summary>a + b rounded, and the exact rest; |a| must not be less than |b| unless a is zero.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static double OrderedSum(double a, double b, out double rest)
    {
        double sum = a + b;
        rest = (a - sum) + b;
        return sum;
    }

    /// <summary>a + b rounded, and the exact rest, whichever is larger.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static double Sum(double a, double b, out double rest)
    {
        double sum = a + b;
        double part = sum - a;
        rest = (a - (sum - part)) + (b - part);
        return sum;
    }

    /// <summary>a · b rounded, and the exact rest; both must stay below 2^996, and their product above 2^−900.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static double Product(double a, double b, out double rest)
    {
        double product = a * b;
        double c = a * Splitter;
        double aHigh = c - (c - a);
        double aLow = a - aHigh;
        c = b * Splitter;
        double bHigh = c - (c - b);
        double bLow = b - bHigh;
        rest = (((aHigh * bHigh) - product) + (aHigh * bLow) + (aLow * bHigh)) + (aLow * bLow);
        return product;
    }

    /// <summary>a² rounded, and the exact rest; the limits of <see cref="Product"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static double Square(double a, out double rest)
    {
        double product = a * a;
        double c = a * Splitter;
        double high = c - (c - a);
        double low = a - high;
        rest = (((high * high) - product) + (2.0 * high * low)) + (low * low);
        return product;
    }
}
