using System;
using System.Numerics;
using CreatureGen.Geometry;

namespace CreatureGen.Appearance;

/// <summary>
/// Lays the texture charts of a surface side by side in the unit square, all at one density.
/// </summary>
/// <remarks>Charts stand on shelves, the tallest first; the density is the largest, found by bisection, at which all shelves fit.</remarks>
internal sealed class ChartPacking
{
    /// <summary>Free space around a chart, as a part of the picture's side: two texels of a picture of 512.</summary>
    private const float Margin = 2f / 512f;

    private const int Bisections = 16;

    private readonly Vector2[] low;
    private readonly Vector2[] place;
    private readonly float density;

    private ChartPacking(Vector2[] low, Vector2[] place, float density)
    {
        this.low = low;
        this.place = place;
        this.density = density;
    }

    /// <summary>Part of the picture's side that one metre takes.</summary>
    public float Density => density;

    /// <summary>Where a point of a chart lies in the picture, 0..1.</summary>
    public Vector2 Map(int chart, Vector2 texcoord) => place[chart] + ((texcoord - low[chart]) * density);

    /// <summary>Packs all charts of a surface.</summary>
    public static ChartPacking Pack(Surface surface)
    {
        int count = surface.Charts;
        var low = new Vector2[count];
        var high = new Vector2[count];
        Array.Fill(low, new Vector2(float.MaxValue));
        Array.Fill(high, new Vector2(float.MinValue));
        for (int f = 0; f < surface.Faces.Length; )
        {
            // The faces of a chart mostly follow one another.
            int chart = surface.Faces[f].Chart;
            Vector2 least = low[chart];
            Vector2 most = high[chart];
            for (; f < surface.Faces.Length && surface.Faces[f].Chart == chart; f++)
            {
                FaceTexcoords t = surface.Texcoords[f];
                least = new Vector2(Least(least.X, t.A.X, t.B.X, t.C.X, t.D.X), Least(least.Y, t.A.Y, t.B.Y, t.C.Y, t.D.Y));
                most = new Vector2(Most(most.X, t.A.X, t.B.X, t.C.X, t.D.X), Most(most.Y, t.A.Y, t.B.Y, t.C.Y, t.D.Y));
            }

            low[chart] = least;
            high[chart] = most;
        }

        int[] order = new int[count];
        float[] height = new float[count];
        float area = 0f;
        for (int i = 0; i < count; i++)
        {
            order[i] = i;
            bool used = high[i].X >= low[i].X;
            Vector2 size = used ? high[i] - low[i] : Vector2.Zero;
            low[i] = used ? low[i] : Vector2.Zero;
            high[i] = low[i] + size;
            height[i] = size.Y;
            area += size.X * size.Y;
        }

        Array.Sort(order, (a, b) => height[a] != height[b] ? height[b].CompareTo(height[a]) : a.CompareTo(b));
        var place = new Vector2[count];
        float fits = 0f;
        float tooLarge = 1f / (float)Math.Sqrt(Math.Max(area, 1e-6f));
        for (int round = 0; round < Bisections; round++)
        {
            float middle = (fits + tooLarge) / 2f;
            if (Shelve(order, low, high, middle, place))
            {
                fits = middle;
            }
            else
            {
                tooLarge = middle;
            }
        }

        Shelve(order, low, high, fits, place);
        return new ChartPacking(low, place, fits);
    }

    private static float Least(float bound, float a, float b, float c, float d) => Math.Min(bound, Math.Min(Math.Min(a, b), Math.Min(c, d)));

    private static float Most(float bound, float a, float b, float c, float d) => Math.Max(bound, Math.Max(Math.Max(a, b), Math.Max(c, d)));

    private static bool Shelve(int[] order, Vector2[] low, Vector2[] high, float density, Vector2[] place)
    {
        float x = Margin;
        float y = Margin;
        float shelf = 0f;
        foreach (int chart in order)
        {
            Vector2 size = (high[chart] - low[chart]) * density;
            if (x + size.X + Margin > 1f)
            {
                x = Margin;
                y += shelf + Margin;
                shelf = 0f;
            }

            if (x + size.X + Margin > 1f || y + size.Y + Margin > 1f)
            {
                return false;
            }

            place[chart] = new Vector2(x, y);
            x += size.X + Margin;
            shelf = Math.Max(shelf, size.Y);
        }

        return true;
    }
}
