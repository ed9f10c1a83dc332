using System;
using System.Numerics;

namespace CreatureGen.Appearance.Textures;

/// <summary>What becomes of the texels of a triangle.</summary>
internal interface ITexelSink
{
    /// <summary>Whether a texel is of no interest.</summary>
    bool Skips(int x, int y);

    /// <summary>Takes a texel whose middle lies in the triangle.</summary>
    void Take(int x, int y, in Barycentric weights);
}

/// <summary>Finds the texels whose middles lie in a triangle of a picture.</summary>
internal static class TriangleRaster
{
    /// <summary>Gives the texels to a sink, row by row.</summary>
    /// <param name="size">Texels along a side of the picture.</param>
    /// <param name="rows">The rows to look at.</param>
    /// <param name="a">First corner, in parts of the side from the left and from the top.</param>
    /// <param name="b">Second corner.</param>
    /// <param name="c">Third corner.</param>
    /// <param name="sink">Takes them.</param>
    public static void Fill<TSink>(int size, RowBand rows, Vector2 a, Vector2 b, Vector2 c, ref TSink sink)
        where TSink : struct, ITexelSink
    {
        Vector2 pa = a * size;
        Vector2 pb = b * size;
        Vector2 pc = c * size;
        float area = Cross(pb - pa, pc - pa);
        if (area == 0f)
        {
            return;
        }

        int top = Math.Max(rows.Top, (int)Math.Floor(Math.Min(pa.Y, Math.Min(pb.Y, pc.Y)) - 0.5));
        int bottom = Math.Min(rows.End - 1, (int)Math.Ceiling(Math.Max(pa.Y, Math.Max(pb.Y, pc.Y)) - 0.5));
        int left = Math.Max(0, (int)Math.Floor(Math.Min(pa.X, Math.Min(pb.X, pc.X)) - 0.5));
        int right = Math.Min(size - 1, (int)Math.Ceiling(Math.Max(pa.X, Math.Max(pb.X, pc.X)) - 0.5));
        for (int y = top; y <= bottom; y++)
        {
            float middle = y + 0.5f;
            float first = left;
            float last = right;
            Narrow(pb, pc, area, middle, ref first, ref last);
            Narrow(pc, pa, area, middle, ref first, ref last);
            Narrow(pa, pb, area, middle, ref first, ref last);
            float ay = pa.Y - middle;
            float by = pb.Y - middle;
            float cy = pc.Y - middle;
            for (int x = (int)first; x <= last; x++)
            {
                if (sink.Skips(x, y))
                {
                    continue;
                }

                float ax = pa.X - (x + 0.5f);
                float bx = pb.X - (x + 0.5f);
                float cx = pc.X - (x + 0.5f);
                float wa = ((bx * cy) - (by * cx)) / area;
                float wb = ((cx * ay) - (cy * ax)) / area;
                float wc = 1f - wa - wb;

                // A hair's breadth outside counts, so that no texel between two faces is missed.
                if (wa >= -1e-4f && wb >= -1e-4f && wc >= -1e-4f)
                {
                    sink.Take(x, y, new Barycentric(wa, wb, wc));
                }
            }
        }
    }

    /// <summary>Narrows a row of texels to those on the inner side of an edge, and a texel more at either end.</summary>
    private static void Narrow(Vector2 from, Vector2 to, float area, float y, ref float first, ref float last)
    {
        float rise = to.Y - from.Y;
        if (rise == 0f)
        {
            return;
        }

        float crossing = from.X + ((to.X - from.X) * (y - from.Y) / rise);
        if (rise < 0f == area > 0f)
        {
            first = Math.Max(first, Math.Min(crossing - 1.5f, last + 1f));
        }
        else
        {
            last = Math.Min(last, crossing + 0.5f);
        }
    }

    private static float Cross(Vector2 a, Vector2 b) => (a.X * b.Y) - (a.Y * b.X);
}
