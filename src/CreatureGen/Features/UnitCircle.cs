using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Features;

/// <summary>Equally spaced directions around a circle, exactly symmetric about the x axis: entry n − k is entry k with y negated.</summary>
internal static class UnitCircle
{
    /// <summary>The largest number of directions.</summary>
    public const int MaxCount = 24;

    private static readonly Vector2[][] tables = BuildAll();

    /// <summary><paramref name="count"/> directions (3..<see cref="MaxCount"/>), counter-clockwise from (1, 0).</summary>
    public static ReadOnlySpan<Vector2> Directions(int count) => tables[count];

    private static Vector2[][] BuildAll()
    {
        var all = new Vector2[MaxCount + 1][];
        for (int count = 0; count <= MaxCount; count++)
        {
            all[count] = Build(count);
        }

        return all;
    }

    private static Vector2[] Build(int count)
    {
        var table = new Vector2[count];
        for (int k = 0; k < count; k++)
        {
            if (2 * k <= count)
            {
                double angle = PortableMath.Tau * k / count;
                table[k] = new Vector2(4 * k == count ? 0f : (float)PortableMath.Cos(angle), 2 * k == count ? 0f : (float)PortableMath.Sin(angle));
            }
            else
            {
                table[k] = new Vector2(table[count - k].X, -table[count - k].Y);
            }
        }

        return table;
    }
}
