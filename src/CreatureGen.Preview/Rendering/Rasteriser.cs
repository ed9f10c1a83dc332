using System;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace CreatureGen.Preview.Rendering;

/// <summary>
/// Finds the nearest triangle at every sample of one tile of the picture: edge functions in whole numbers of 1/256 pixel with the top-left rule
/// (no gap and no double cover along shared edges; Pineda 1988, "A parallel algorithm for polygon rasterization"), and a buffer of 1/depth.
/// Of equal depths the earlier triangle stays.
/// </summary>
/// <remarks>
/// The samples of a pixel are the lanes of a vector; with fewer than eight the last are never covered. SimdKernels only add, multiply and compare, so that
/// the result does not depend on what the processor offers.
/// </remarks>
internal sealed class Rasteriser
{
    /// <summary>Side of a tile, pixels.</summary>
    public const int TileSize = 32;

    /// <summary>Places for samples in each pixel, used or not.</summary>
    public const int SimdKernels = 8;

    private const int SubPixel = ScreenProjection.SubPixel;

    // Sides up to which edge functions fit 32 bits, 1/256 pixel: 2 · (2^14 + 2^8) · 2^14 < 2^31.
    private const int LargestSmall = 1 << 14;

    // Below every value of an edge function: keeps a lane from being covered.
    private const int Never = int.MinValue / 2;

    private readonly SamplePattern pattern;
    private readonly Vector256<int> sampleX;
    private readonly Vector256<int> sampleY;
    private readonly Vector256<float> sampleXInPixels;
    private readonly Vector256<float> sampleYInPixels;
    private readonly Vector256<int> unused;
    private readonly Vector256<float>[] depths = new Vector256<float>[TileSize * TileSize];
    private readonly Vector256<int>[] triangles = new Vector256<int>[TileSize * TileSize];
    private int left;
    private int top;
    private int right;
    private int bottom;

    public Rasteriser(SamplePattern pattern)
    {
        this.pattern = pattern;
        Span<int> x = stackalloc int[SimdKernels];
        Span<int> y = stackalloc int[SimdKernels];
        Span<int> never = stackalloc int[SimdKernels];
        x.Clear();
        y.Clear();
        never.Fill(-1);
        pattern.X.CopyTo(x);
        pattern.Y.CopyTo(y);
        never[..pattern.Count].Clear();
        sampleX = Vector256.Create<int>(x);
        sampleY = Vector256.Create<int>(y);
        unused = Vector256.Create<int>(never);
        sampleXInPixels = Vector256.ConvertToSingle(sampleX) * Vector256.Create(1f / SubPixel);
        sampleYInPixels = Vector256.ConvertToSingle(sampleY) * Vector256.Create(1f / SubPixel);
    }

    /// <summary>Empties the buffers for the tile whose pixels are <paramref name="left"/>..<paramref name="right"/> − 1 and <paramref name="top"/>..<paramref name="bottom"/> − 1.</summary>
    public void Begin(int left, int top, int right, int bottom)
    {
        this.left = left;
        this.top = top;
        this.right = right;
        this.bottom = bottom;
        Array.Clear(depths);
        MemoryMarshal.Cast<Vector256<int>, int>(triangles.AsSpan()).Fill(-1);
    }

    /// <summary>The triangle seen at each sample of a pixel; −1 for none and at lanes that are not used.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vector256<int> Seen(int x, int y) => triangles[((y - top) * TileSize) + x - left];

    /// <summary>Draws a triangle into the buffers.</summary>
    public void Draw(in ScreenTriangle t, int index)
    {
        int spanX = Math.Max(t.X0, Math.Max(t.X1, t.X2)) - Math.Min(t.X0, Math.Min(t.X1, t.X2));
        int spanY = Math.Max(t.Y0, Math.Max(t.Y1, t.Y2)) - Math.Min(t.Y0, Math.Min(t.Y1, t.Y2));
        if (spanX <= LargestSmall && spanY <= LargestSmall)
        {
            DrawSmall(in t, index);
        }
        else
        {
            DrawLarge(in t, index);
        }
    }

    private static long Edge(int ax, int ay, int bx, int by, int x, int y)
    {
        long dx = bx - ax;
        long dy = by - ay;
        bool topLeft = dy < 0 || (dy == 0 && dx > 0);
        return (dx * (y - ay)) - (dy * (x - ax)) - (topLeft ? 0 : 1);
    }

    // Code for eight lanes is not compiled ahead; the just-in-time compiler does not optimise at first, and a first picture is over before it does.
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private void DrawSmall(in ScreenTriangle t, int index)
    {
        int minX = Math.Max(left, t.MinX);
        int minY = Math.Max(top, t.MinY);
        int maxX = Math.Min(right - 1, t.MaxX);
        int maxY = Math.Min(bottom - 1, t.MaxY);
        int centreX = (minX * SubPixel) + (SubPixel / 2);
        int centreY = (minY * SubPixel) + (SubPixel / 2);
        Vector256<int> off0 = Offsets(t.X1 - t.X0, t.Y1 - t.Y0, (int)Edge(t.X0, t.Y0, t.X1, t.Y1, centreX, centreY));
        Vector256<int> off1 = Offsets(t.X2 - t.X1, t.Y2 - t.Y1, (int)Edge(t.X1, t.Y1, t.X2, t.Y2, centreX, centreY));
        Vector256<int> off2 = Offsets(t.X0 - t.X2, t.Y0 - t.Y2, (int)Edge(t.X2, t.Y2, t.X0, t.Y0, centreX, centreY));
        off0 = Vector256.ConditionalSelect(unused, Vector256.Create(Never), off0);
        Vector256<int> stepX0 = Vector256.Create((t.Y0 - t.Y1) * SubPixel);
        Vector256<int> stepX1 = Vector256.Create((t.Y1 - t.Y2) * SubPixel);
        Vector256<int> stepX2 = Vector256.Create((t.Y2 - t.Y0) * SubPixel);
        Vector256<int> stepY0 = Vector256.Create((t.X1 - t.X0) * SubPixel);
        Vector256<int> stepY1 = Vector256.Create((t.X2 - t.X1) * SubPixel);
        Vector256<int> stepY2 = Vector256.Create((t.X0 - t.X2) * SubPixel);
        stepX0 = Vector256.ConditionalSelect(unused, Vector256<int>.Zero, stepX0);
        stepY0 = Vector256.ConditionalSelect(unused, Vector256<int>.Zero, stepY0);
        Vector256<float> depthOffsets = DepthOffsets(in t);
        Vector256<float> min = Vector256.Create(t.DepthMin);
        Vector256<float> max = Vector256.Create(t.DepthMax);
        Vector256<int> name = Vector256.Create(index);
        for (int y = minY; y <= maxY; y++)
        {
            Vector256<int> e0 = off0;
            Vector256<int> e1 = off1;
            Vector256<int> e2 = off2;
            Span<Vector256<float>> depthRow = depths.AsSpan(((y - top) * TileSize) + minX - left, maxX - minX + 1);
            Span<Vector256<int>> triangleRow = triangles.AsSpan(((y - top) * TileSize) + minX - left, depthRow.Length);
            float rowDepth = t.Depth + (t.DepthY * (y - t.MinY));
            for (int x = 0; x < depthRow.Length; x++)
            {
                // Covered lanes are those where no edge function is negative.
                Vector256<int> outside = (e0 | e1 | e2) >> 31;
                if (outside != Vector256<int>.AllBitsSet)
                {
                    Vector256<float> d = Vector256.Create(rowDepth + (t.DepthX * (x + minX - t.MinX))) + depthOffsets;
                    d = Vector256.Min(Vector256.Max(d, min), max);
                    ref Vector256<float> depth = ref depthRow[x];
                    Vector256<float> nearer = Vector256.AndNot(Vector256.GreaterThan(d, depth), outside.AsSingle());
                    depth = Vector256.ConditionalSelect(nearer, d, depth);
                    triangleRow[x] = Vector256.ConditionalSelect(nearer.AsInt32(), name, triangleRow[x]);
                }

                e0 += stepX0;
                e1 += stepX1;
                e2 += stepX2;
            }

            off0 += stepY0;
            off1 += stepY1;
            off2 += stepY2;
        }
    }

    private Vector256<int> Offsets(int dx, int dy, int atCentre) =>
        Vector256.Create(atCentre) + (Vector256.Create(dx) * sampleY) - (Vector256.Create(dy) * sampleX);

    private Vector256<float> DepthOffsets(in ScreenTriangle t) =>
        (Vector256.Create(t.DepthX) * sampleXInPixels) + (Vector256.Create(t.DepthY) * sampleYInPixels);

    private void DrawLarge(in ScreenTriangle t, int index)
    {
        Span<float> offsets = stackalloc float[SimdKernels];
        DepthOffsets(in t).CopyTo(offsets);
        for (int y = Math.Max(top, t.MinY); y <= Math.Min(bottom - 1, t.MaxY); y++)
        {
            float rowDepth = t.Depth + (t.DepthY * (y - t.MinY));
            for (int x = Math.Max(left, t.MinX); x <= Math.Min(right - 1, t.MaxX); x++)
            {
                int at = ((y - top) * TileSize) + x - left;
                Span<float> depth = MemoryMarshal.Cast<Vector256<float>, float>(depths.AsSpan(at, 1));
                Span<int> seen = MemoryMarshal.Cast<Vector256<int>, int>(triangles.AsSpan(at, 1));
                float centreDepth = rowDepth + (t.DepthX * (x - t.MinX));
                for (int s = 0; s < pattern.Count; s++)
                {
                    int sx = (x * SubPixel) + (SubPixel / 2) + pattern.X[s];
                    int sy = (y * SubPixel) + (SubPixel / 2) + pattern.Y[s];
                    if ((Edge(t.X0, t.Y0, t.X1, t.Y1, sx, sy) | Edge(t.X1, t.Y1, t.X2, t.Y2, sx, sy) | Edge(t.X2, t.Y2, t.X0, t.Y0, sx, sy)) >= 0)
                    {
                        float d = Math.Min(Math.Max(centreDepth + offsets[s], t.DepthMin), t.DepthMax);
                        if (d > depth[s])
                        {
                            depth[s] = d;
                            seen[s] = index;
                        }
                    }
                }
            }
        }
    }
}
