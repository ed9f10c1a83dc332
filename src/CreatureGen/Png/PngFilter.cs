using System;

namespace CreatureGen.Png;

/// <summary>The row filters of PNG: each byte becomes its difference from a guess made of its neighbours.</summary>
internal static class PngFilter
{
    /// <summary>
    /// Filters a rectangle of bytes row by row, each row with the filter whose differences, taken as signed, have the smallest sum of absolute values.
    /// </summary>
    /// <param name="bytes">Rows, top first.</param>
    /// <param name="stride">Distance between the starts of rows, bytes.</param>
    /// <param name="rowBytes">Bytes used of each row.</param>
    /// <param name="rows">Number of rows.</param>
    /// <param name="bytesPerPixel">Distance to the left neighbour.</param>
    /// <returns>For each row the number of its filter, then its bytes.</returns>
    public static byte[] Apply(ReadOnlySpan<byte> bytes, int stride, int rowBytes, int rows, int bytesPerPixel)
    {
        var filtered = new byte[checked((rowBytes + 1) * rows)];
        var trial = new byte[rowBytes];
        var zeros = new byte[rowBytes];
        ReadOnlySpan<byte> above = zeros;
        for (int y = 0; y < rows; y++)
        {
            ReadOnlySpan<byte> row = bytes.Slice(y * stride, rowBytes);
            Span<byte> best = filtered.AsSpan((y * (rowBytes + 1)) + 1, rowBytes);
            int least = int.MaxValue;
            for (int filter = 0; filter < 5; filter++)
            {
                int sum = filter switch
                {
                    0 => None(row, trial),
                    1 => Sub(row, trial, bytesPerPixel),
                    2 => Up(row, above, trial),
                    3 => Average(row, above, trial, bytesPerPixel),
                    _ => Paeth(row, above, trial, bytesPerPixel),
                };
                if (sum < least)
                {
                    least = sum;
                    trial.CopyTo(best);
                    filtered[y * (rowBytes + 1)] = (byte)filter;
                }
            }

            above = row;
        }

        return filtered;
    }

    private static int None(ReadOnlySpan<byte> row, Span<byte> target)
    {
        row.CopyTo(target);
        int sum = 0;
        foreach (byte value in row)
        {
            sum += Weight(value);
        }

        return sum;
    }

    private static int Sub(ReadOnlySpan<byte> row, Span<byte> target, int step)
    {
        int sum = 0;
        for (int i = 0; i < row.Length; i++)
        {
            byte difference = (byte)(row[i] - (i < step ? 0 : row[i - step]));
            target[i] = difference;
            sum += Weight(difference);
        }

        return sum;
    }

    private static int Up(ReadOnlySpan<byte> row, ReadOnlySpan<byte> above, Span<byte> target)
    {
        int sum = 0;
        for (int i = 0; i < row.Length; i++)
        {
            byte difference = (byte)(row[i] - above[i]);
            target[i] = difference;
            sum += Weight(difference);
        }

        return sum;
    }

    private static int Average(ReadOnlySpan<byte> row, ReadOnlySpan<byte> above, Span<byte> target, int step)
    {
        int sum = 0;
        for (int i = 0; i < row.Length; i++)
        {
            int left = i < step ? 0 : row[i - step];
            byte difference = (byte)(row[i] - ((left + above[i]) >> 1));
            target[i] = difference;
            sum += Weight(difference);
        }

        return sum;
    }

    private static int Paeth(ReadOnlySpan<byte> row, ReadOnlySpan<byte> above, Span<byte> target, int step)
    {
        int sum = 0;
        for (int i = 0; i < row.Length; i++)
        {
            int left = i < step ? 0 : row[i - step];
            int corner = i < step ? 0 : above[i - step];
            int up = above[i];
            int toLeft = Math.Abs(up - corner);
            int toUp = Math.Abs(left - corner);
            int toCorner = Math.Abs(left + up - (2 * corner));
            int guess = toLeft <= toUp && toLeft <= toCorner ? left : toUp <= toCorner ? up : corner;
            byte difference = (byte)(row[i] - guess);
            target[i] = difference;
            sum += Weight(difference);
        }

        return sum;
    }

    private static int Weight(byte difference) => difference < 128 ? difference : 256 - difference;
}
