using System;

namespace CreatureGen.Lattices;

internal static class RingLattice
{
    public static void Evaluate(ReadOnlySpan<double> sliceWidths, ReadOnlySpan<double> sliceHeights, ReadOnlySpan<double> sliceLengths, ReadOnlySpan<double> t, Span<double> widthFactor, Span<double> heightFactor, Span<double> position)
    {
        Span<double> z = stackalloc double[11];
        for (int k = 1; k < 11; k++)
        {
            z[k] = z[k - 1] + (0.1 * sliceLengths[k]);
        }

        Span<double> b = stackalloc double[11];
        for (int i = 0; i < t.Length; i++)
        {
            double u = t[i];
            b.Clear();
            b[0] = 1;
            for (int d = 1; d <= 10; d++)
            {
                for (int k = d; k >= 0; k--)
                {
                    b[k] = (b[k] * (1 - u)) + (k > 0 ? b[k - 1] * u : 0);
                }
            }

            double w = 0, h = 0, p = 0;
            for (int k = 0; k < 11; k++)
            {
                w += b[k] * sliceWidths[k];
                h += b[k] * sliceHeights[k];
                p += b[k] * z[k];
            }

            widthFactor[i] = w;
            heightFactor[i] = h;
            position[i] = p;
        }
    }
}
