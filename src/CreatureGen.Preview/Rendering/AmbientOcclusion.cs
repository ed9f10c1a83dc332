using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>How open each visible place is to the light around it, from depths and normals of the picture.</summary>
/// <remarks>
/// Based on: McGuire, Mara and Luebke 2012, "Scalable ambient obscurance": the estimate of their section 2.4 over a sunflower of samples that is
/// turned in a pattern of four by four pixels, which a mean over four by four pixels of the same surface then takes out.
/// </remarks>
internal sealed class AmbientOcclusion
{
    private const int SampleTotal = 12;
    private const int PatternSide = 4;
    private const float LargestRadiusPixels = 96f;
    private const float Strength = 2.6f;

    // Part of the radius by which a sample must rise above the surface to count: hides the facets.
    private const float Bias = 0.02f;

    private static readonly Vector2[] Offsets = MakeOffsets();

    private readonly VisibleSurface surface;
    private readonly float radius;
    private readonly float pixelsPerTangent;
    private readonly int width;
    private readonly int height;
    private readonly float[] raw;

    private AmbientOcclusion(VisibleSurface surface, float radius, float pixelsPerTangent)
    {
        this.surface = surface;
        this.radius = radius;
        this.pixelsPerTangent = pixelsPerTangent;
        width = surface.Bins.Width;
        height = surface.Bins.Height;
        raw = new float[width * height];
        Openness = new float[width * height];
    }

    /// <summary>1 where a place is open, 0 where it is closed in, at each pixel where something is seen.</summary>
    public float[] Openness { get; }

    /// <summary>Measures it for what a camera sees.</summary>
    /// <param name="surface">What is seen.</param>
    /// <param name="camera">From where.</param>
    /// <param name="radius">Distance within which surfaces shade each other, metres.</param>
    /// <param name="threads">Threads that share the work.</param>
    public static AmbientOcclusion Measure(VisibleSurface surface, Camera camera, float radius, int threads)
    {
        var occlusion = new AmbientOcclusion(surface, radius, camera.PixelsPerTangent(surface.Bins.Height));
        Work.Share(surface.Bins.Count, threads, tile => occlusion.ForPixels(tile, occlusion.MeasurePixel));
        Work.Share(surface.Bins.Count, threads, tile => occlusion.ForPixels(tile, occlusion.SmoothPixel));
        return occlusion;
    }

    private static Vector2[] MakeOffsets()
    {
        var offsets = new Vector2[PatternSide * PatternSide * SampleTotal];
        for (int turn = 0; turn < PatternSide * PatternSide; turn++)
        {
            for (int i = 0; i < SampleTotal; i++)
            {
                // The golden angle; turns are shuffled so that neighbours differ much.
                double angle = (i * 2.39996322972865332) + (((turn * 7) % 16) * (PortableMath.Tau / 16));
                double distance = Math.Sqrt((i + 0.3 + ((turn * 5) % 16 / 32.0)) / SampleTotal);
                offsets[(turn * SampleTotal) + i] = new Vector2((float)(PortableMath.Cos(angle) * distance), (float)(PortableMath.Sin(angle) * distance));
            }
        }

        return offsets;
    }

    private void ForPixels(int tile, Action<int, int, int> job)
    {
        if (surface.Fragments[tile].Length == 0)
        {
            return;
        }

        surface.Bins.Pixels(tile, out int left, out int top, out int right, out int bottom);
        for (int y = top; y < bottom; y++)
        {
            for (int x = left; x < right; x++)
            {
                int pixel = (y * width) + x;
                if (surface.Depths[pixel] > 0f)
                {
                    job(x, y, pixel);
                }
            }
        }
    }

    private void MeasurePixel(int x, int y, int pixel)
    {
        float[] depths = surface.Depths;
        float z = depths[pixel];
        float scale = 1f / pixelsPerTangent;
        float halfWidth = width * 0.5f;
        float halfHeight = height * 0.5f;
        float px = (x + 0.5f - halfWidth) * z * scale;
        float py = (halfHeight - y - 0.5f) * z * scale;
        Vector3 normal = surface.Normals[pixel];
        float reach = Math.Min(LargestRadiusPixels, radius * pixelsPerTangent / z);
        if (reach < 1.5f)
        {
            raw[pixel] = 1f;
            return;
        }

        ReadOnlySpan<Vector2> offsets = Offsets.AsSpan((((y % PatternSide) * PatternSide) + (x % PatternSide)) * SampleTotal, SampleTotal);
        float inverseSquare = 1f / (radius * radius);
        float bias = radius * Bias;
        float sum = 0f;
        for (int i = 0; i < offsets.Length; i++)
        {
            int sx = x + (int)MathF.Floor((offsets[i].X * reach) + 0.5f);
            int sy = y + (int)MathF.Floor((offsets[i].Y * reach) + 0.5f);
            if ((uint)sx >= (uint)width || (uint)sy >= (uint)height)
            {
                continue;
            }

            float sz = depths[(sy * width) + sx];
            if (sz == 0f)
            {
                continue;
            }

            float dx = ((sx + 0.5f - halfWidth) * sz * scale) - px;
            float dy = ((halfHeight - sy - 0.5f) * sz * scale) - py;
            float dz = sz - z;
            float square = ((dx * dx) + (dy * dy) + (dz * dz)) * inverseSquare;
            float rise = (dx * normal.X) + (dy * normal.Y) + (dz * normal.Z) - bias;
            float near = 1f - square;
            if (near > 0f && rise > 0f)
            {
                sum += near * near * near * rise / (radius * (square + 0.01f));
            }
        }

        raw[pixel] = Math.Max(0f, 1f - (sum * (Strength / SampleTotal)));
    }

    private void SmoothPixel(int x, int y, int pixel)
    {
        float[] depths = surface.Depths;
        float z = depths[pixel];
        float limit = radius * 0.35f;
        float sum = 0f;
        int count = 0;
        int lastX = Math.Min(width - 1, x + 2);
        int lastY = Math.Min(height - 1, y + 2);
        for (int sy = Math.Max(0, y - 1); sy <= lastY; sy++)
        {
            for (int sx = Math.Max(0, x - 1); sx <= lastX; sx++)
            {
                int at = (sy * width) + sx;
                float sz = depths[at];
                if (sz > 0f && Math.Abs(sz - z) < limit)
                {
                    sum += raw[at];
                    count++;
                }
            }
        }

        Openness[pixel] = sum / count;
    }
}
