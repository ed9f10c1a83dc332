using System;
using System.Numerics;
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

    private readonly Vector2[] points;
    private readonly int count;

    public SunflowerPattern(int count)
    {
        this.count = count;
        points = new Vector2[Side * Side * count];
        for (int pixel = 0; pixel < Side * Side; pixel++)
        {
            // Multiples that are prime to 16 shuffle turns and radii so that neighbours differ much.
            double turn = ((pixel * 7) % 16) * (PortableMath.Tau / 16);
            double shift = (0.5 + ((pixel * 5) % 16)) / 16.0;
            for (int i = 0; i < count; i++)
            {
                double angle = (i * GoldenAngle) + turn;
                double distance = Math.Sqrt((i + shift) / count);
                points[(pixel * count) + i] = new Vector2((float)(PortableMath.Cos(angle) * distance), (float)(PortableMath.Sin(angle) * distance));
            }
        }
    }

    /// <summary>The points of a pixel, from the middle outwards.</summary>
    public ReadOnlySpan<Vector2> this[int x, int y] => points.AsSpan((((y % Side) * Side) + (x % Side)) * count, count);
}
