using System;

namespace CreatureGen.Maths;

/// <summary>Order statistics without sorting everything.</summary>
internal static class Selection
{
    /// <summary>The value below which the given share of the values lies. Reorders the span.</summary>
    /// <param name="values">At least one number, none NaN.</param>
    /// <param name="fraction">0 for the least value, 1 for the greatest.</param>
    /// <remarks>Based on: C. A. R. Hoare, "Algorithm 65: Find" (1961), with the median of three as pivot.</remarks>
    public static float Percentile(Span<float> values, double fraction)
    {
        int n = (int)((fraction * (values.Length - 1)) + 0.5);
        int low = 0;
        int high = values.Length - 1;
        while (low < high)
        {
            float pivot = Median(values[low], values[(low + high) >> 1], values[high]);
            int i = low;
            int j = high;
            while (i <= j)
            {
                while (values[i] < pivot)
                {
                    i++;
                }

                while (values[j] > pivot)
                {
                    j--;
                }

                if (i <= j)
                {
                    (values[i], values[j]) = (values[j], values[i]);
                    i++;
                    j--;
                }
            }

            if (n <= j)
            {
                high = j;
            }
            else if (n >= i)
            {
                low = i;
            }
            else
            {
                break;
            }
        }

        return values[n];
    }

    private static float Median(float a, float b, float c) => Math.Max(Math.Min(a, b), Math.Min(Math.Max(a, b), c));
}
