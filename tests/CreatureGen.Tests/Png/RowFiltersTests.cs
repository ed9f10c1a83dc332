using System;
using System.Linq;
using CreatureGen.Png;
using Xunit;

namespace CreatureGen.Tests.Png;

public sealed class RowFiltersTests
{
    /// <summary>Lengths around those of a vector, so that some rows are wholly, some partly and some not at all done by vectors.</summary>
    [Theory]
    [InlineData(3, 1)]
    [InlineData(3, 15)]
    [InlineData(3, 16)]
    [InlineData(4, 17)]
    [InlineData(3, 31)]
    [InlineData(4, 64)]
    [InlineData(3, 1000)]
    public void Every_filter_leaves_what_the_standard_says_and_the_best_has_the_smallest_sum(int bytesPerPixel, int length)
    {
        var random = new Random(length);
        var filters = new RowFilters(length, bytesPerPixel);
        byte[] above = new byte[length];
        for (int y = 0; y < 40; y++)
        {
            // Few values: ties between the three neighbours are what Paeth's guess is easiest to get wrong in.
            int values = y % 2 == 0 ? 256 : 4;
            byte[] row = Enumerable.Range(0, length).Select(_ => (byte)(random.Next(values) * (256 / values))).ToArray();
            int best = filters.Best(row);
            int[] sums = new int[RowFilters.Count];
            for (int filter = 0; filter < RowFilters.Count; filter++)
            {
                byte[] expected = Naive(filter, row, above, bytesPerPixel);
                Assert.Equal(expected, filters.Result(filter).ToArray());
                sums[filter] = expected.Sum(b => Math.Abs((int)(sbyte)b));
            }

            Assert.Equal(Array.IndexOf(sums, sums.Min()), best);
            above = row;
        }
    }

    /// <summary>ISO/IEC 15948, 9.2 and 9.4.</summary>
    private static byte[] Naive(int filter, byte[] row, byte[] above, int bytesPerPixel) => row.Select((x, i) =>
    {
        int a = i < bytesPerPixel ? 0 : row[i - bytesPerPixel];
        int b = above[i];
        int c = i < bytesPerPixel ? 0 : above[i - bytesPerPixel];
        return (byte)(x - filter switch { 0 => 0, 1 => a, 2 => b, 3 => (a + b) / 2, _ => Paeth(a, b, c) });
    }).ToArray();

    private static int Paeth(int a, int b, int c)
    {
        int p = a + b - c;
        int pa = Math.Abs(p - a), pb = Math.Abs(p - b), pc = Math.Abs(p - c);
        return pa <= pb && pa <= pc ? a : pb <= pc ? b : c;
    }
}
