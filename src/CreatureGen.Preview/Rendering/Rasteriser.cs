using System;

namespace CreatureGen.Preview.Rendering;

/// <summary>
/// Finds the nearest triangle at every sample of one tile of the picture: edge functions in whole numbers of 1/256 pixel with the top-left rule
/// (no gap and no double cover along shared edges; Pineda 1988, "A parallel algorithm for polygon rasterization"), and a buffer of 1/depth.
/// Of equal depths the earlier triangle stays.
/// </summary>
internal sealed class Rasteriser
{
    /// <summary>Side of a tile, pixels.</summary>
    public const int TileSize = 32;

    private const int SubPixel = ScreenProjection.SubPixel;

    private readonly SamplePattern pattern;
    private readonly float[] depths;
    private readonly int[] triangles;
    private readonly long[] offsets;
    private readonly float[] depthOffsets;
    private int left;
    private int top;
    private int right;
    private int bottom;

    public Rasteriser(SamplePattern pattern)
    {
        this.pattern = pattern;
        depths = new float[TileSize * TileSize * pattern.Count];
        triangles = new int[TileSize * TileSize * pattern.Count];
        offsets = new long[3 * pattern.Count];
        depthOffsets = new float[pattern.Count];
    }

    /// <summary>Empties the buffers for the tile whose pixels are <paramref name="left"/>..<paramref name="right"/> − 1 and <paramref name="top"/>..<paramref name="bottom"/> − 1.</summary>
    public void Begin(int left, int top, int right, int bottom)
    {
        this.left = left;
        this.top = top;
        this.right = right;
        this.bottom = bottom;
        Array.Clear(depths);
        Array.Fill(triangles, -1);
    }

    /// <summary>The triangle seen at each sample of a pixel; −1 for none.</summary>
    public ReadOnlySpan<int> Seen(int x, int y) => triangles.AsSpan((((y - top) * TileSize) + x - left) * pattern.Count, pattern.Count);

    /// <summary>Draws a triangle into the buffers.</summary>
    public void Draw(in ScreenTriangle t, int index)
    {
        int minX = Math.Max(left, t.MinX);
        int minY = Math.Max(top, t.MinY);
        int maxX = Math.Min(right - 1, t.MaxX);
        int maxY = Math.Min(bottom - 1, t.MaxY);
        int centreX = (minX * SubPixel) + (SubPixel / 2);
        int centreY = (minY * SubPixel) + (SubPixel / 2);
        long row0 = Edge(t.X0, t.Y0, t.X1, t.Y1, centreX, centreY);
        long row1 = Edge(t.X1, t.Y1, t.X2, t.Y2, centreX, centreY);
        long row2 = Edge(t.X2, t.Y2, t.X0, t.Y0, centreX, centreY);
        long stepX0 = (long)(t.Y0 - t.Y1) * SubPixel;
        long stepX1 = (long)(t.Y1 - t.Y2) * SubPixel;
        long stepX2 = (long)(t.Y2 - t.Y0) * SubPixel;
        long stepY0 = (long)(t.X1 - t.X0) * SubPixel;
        long stepY1 = (long)(t.X2 - t.X1) * SubPixel;
        long stepY2 = (long)(t.X0 - t.X2) * SubPixel;
        SetOffsets(0, t.X1 - t.X0, t.Y1 - t.Y0, out long least0, out long most0);
        SetOffsets(1, t.X2 - t.X1, t.Y2 - t.Y1, out long least1, out long most1);
        SetOffsets(2, t.X0 - t.X2, t.Y0 - t.Y2, out long least2, out long most2);
        for (int s = 0; s < depthOffsets.Length; s++)
        {
            depthOffsets[s] = ((t.DepthX * pattern.X[s]) + (t.DepthY * pattern.Y[s])) * (1f / SubPixel);
        }

        for (int y = minY; y <= maxY; y++)
        {
            long e0 = row0;
            long e1 = row1;
            long e2 = row2;
            for (int x = minX; x <= maxX; x++)
            {
                if (e0 + most0 >= 0 && e1 + most1 >= 0 && e2 + most2 >= 0)
                {
                    float depth = t.Depth + (t.DepthX * (x - t.MinX)) + (t.DepthY * (y - t.MinY));
                    int at = (((y - top) * TileSize) + x - left) * depthOffsets.Length;
                    if (e0 + least0 >= 0 && e1 + least1 >= 0 && e2 + least2 >= 0)
                    {
                        Cover(at, depth, t.DepthMin, t.DepthMax, index);
                    }
                    else
                    {
                        CoverPart(at, depth, t.DepthMin, t.DepthMax, index, e0, e1, e2);
                    }
                }

                e0 += stepX0;
                e1 += stepX1;
                e2 += stepX2;
            }

            row0 += stepY0;
            row1 += stepY1;
            row2 += stepY2;
        }
    }

    private static long Edge(int ax, int ay, int bx, int by, int x, int y)
    {
        long dx = bx - ax;
        long dy = by - ay;
        bool topLeft = dy < 0 || (dy == 0 && dx > 0);
        return (dx * (y - ay)) - (dy * (x - ax)) - (topLeft ? 0 : 1);
    }

    private void SetOffsets(int edge, long dx, long dy, out long least, out long most)
    {
        least = long.MaxValue;
        most = long.MinValue;
        int count = pattern.Count;
        for (int s = 0; s < count; s++)
        {
            long offset = (dx * pattern.Y[s]) - (dy * pattern.X[s]);
            offsets[(edge * count) + s] = offset;
            least = Math.Min(least, offset);
            most = Math.Max(most, offset);
        }
    }

    private void Cover(int at, float depth, float least, float most, int index)
    {
        Span<float> depthSpan = depths.AsSpan(at, depthOffsets.Length);
        for (int s = 0; s < depthSpan.Length; s++)
        {
            float d = Math.Clamp(depth + depthOffsets[s], least, most);
            if (d > depthSpan[s])
            {
                depthSpan[s] = d;
                triangles[at + s] = index;
            }
        }
    }

    private void CoverPart(int at, float depth, float least, float most, int index, long e0, long e1, long e2)
    {
        int count = depthOffsets.Length;
        for (int s = 0; s < count; s++)
        {
            if ((e0 + offsets[s] | e1 + offsets[count + s] | e2 + offsets[(2 * count) + s]) >= 0)
            {
                float d = Math.Clamp(depth + depthOffsets[s], least, most);
                if (d > depths[at + s])
                {
                    depths[at + s] = d;
                    triangles[at + s] = index;
                }
            }
        }
    }
}
