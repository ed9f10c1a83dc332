using System;
using CreatureGen.Maths;

namespace CreatureGen.Preview.Rendering;

/// <summary>
/// Points spread evenly over the unit disc, turned differently for each pixel of a square of four by four, so that the mean over such a square is
/// that of sixteen times as many points.
/// </summary>
internal sealed class SunflowerPattern
{
    /// <summary>Side of the square of pixels.</summary>
    public const int Side = 4;

    private const double GoldenAngle = 2.39996322972865332;

    private readonly float[] x;
    private readonly float[] y;

    public SunflowerPattern(int count)
    {
        Count = count;
        x = new float[Side * Side * count];
        y = new float[Side * Side * count];
        for (int pixel = 0; pixel < Side * Side; pixel++)
        {
            // Multiples that are prime to 16 shuffle turns and radii so that neighbours differ much.
            double turn = ((pixel * 7) % 16) * (PortableMath.Tau / 16);
            double shift = (0.5 + ((pixel * 5) % 16)) / 16.0;
            for (int i = 0; i < count; i++)
            {
                double angle = (i * GoldenAngle) + turn;
                double distance = Math.Sqrt((i + shift) / count);
                x[(pixel * count) + i] = (float)(PortableMath.Cos(angle) * distance);
                y[(pixel * count) + i] = (float)(PortableMath.Sin(angle) * distance);
            }
        }
    }

    /// <summary>Points of a pixel.</summary>
    public int Count { get; }

    /// <summary>The points of a pixel, from the middle outwards.</summary>
    public void Points(int column, int row, out ReadOnlySpan<float> pointX, out ReadOnlySpan<float> pointY)
    {
        int first = (((row % Side) * Side) + (column % Side)) * Count;
        pointX = x.AsSpan(first, Count);
        pointY = y.AsSpan(first, Count);
    }
}
