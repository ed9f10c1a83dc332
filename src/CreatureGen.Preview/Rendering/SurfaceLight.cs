using System;
using System.Numerics;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>At each pixel that shows the creature: how open the place is to the light around it, and how much of the key light reaches it.</summary>
internal sealed class SurfaceLight
{
    // Depths that differ by more than this part of the occlusion radius are not averaged.
    private const float SameSurfacePart = 0.3f;

    private readonly VisibleSurface surface;
    private readonly Camera camera;
    private readonly AmbientOcclusion occlusion;
    private readonly ShadowMap shadow;
    private readonly float depthLimit;
    private readonly int width;
    private readonly int height;
    private readonly Vector2[] raw;
    private readonly Vector2[] smooth;

    private SurfaceLight(VisibleSurface surface, Camera camera, AmbientOcclusion occlusion, ShadowMap shadow, float radius)
    {
        this.surface = surface;
        this.camera = camera;
        this.occlusion = occlusion;
        this.shadow = shadow;
        depthLimit = radius * SameSurfacePart;
        width = surface.Bins.Width;
        height = surface.Bins.Height;
        raw = new Vector2[width * height];
        smooth = new Vector2[width * height];
    }

    /// <summary>Measures it.</summary>
    /// <param name="surface">What is seen.</param>
    /// <param name="camera">From where.</param>
    /// <param name="shadow">The creature as the key light sees it.</param>
    /// <param name="radius">Distance within which surfaces hide the light around from each other, metres.</param>
    /// <param name="threads">Threads that share the work.</param>
    public static SurfaceLight Measure(VisibleSurface surface, Camera camera, ShadowMap shadow, float radius, int threads)
    {
        var light = new SurfaceLight(surface, camera, new AmbientOcclusion(surface, camera, radius), shadow, radius);
        Work.Share(surface.Bins.Count, threads, light.MeasureTile);
        Work.Share(surface.Bins.Count, threads, light.SmoothTile);
        return light;
    }

    /// <summary>Openness (X) and key light (Y), both 0..1, of a fragment that fills most of its pixel.</summary>
    public Vector2 AtPixel(int pixel) => smooth[pixel];

    /// <summary>Openness (X) and key light (Y) of a fragment that does not: those of the pixel around it whose depth is nearest.</summary>
    public Vector2 Near(int pixel, float depth)
    {
        int x = pixel % width;
        int y = pixel / width;
        float min = float.PositiveInfinity;
        Vector2 result = smooth[pixel];
        for (int sy = Math.Max(0, y - 1); sy <= Math.Min(height - 1, y + 1); sy++)
        {
            for (int sx = Math.Max(0, x - 1); sx <= Math.Min(width - 1, x + 1); sx++)
            {
                int at = (sy * width) + sx;
                float difference = Math.Abs(surface.Depths[at] - depth);
                if (surface.Depths[at] > 0f && difference < min)
                {
                    min = difference;
                    result = smooth[at];
                }
            }
        }

        return result;
    }

    private void MeasureTile(int tile)
    {
        if (surface.Fragments[tile].Length == 0)
        {
            return;
        }

        float scale = 1f / camera.PixelsPerTangent(height);
        surface.Bins.Pixels(tile, out int left, out int top, out int right, out int bottom);
        for (int y = top; y < bottom; y++)
        {
            for (int x = left; x < right; x++)
            {
                int pixel = (y * width) + x;
                float z = surface.Depths[pixel];
                if (z > 0f)
                {
                    Vector3 n = surface.Normals[pixel];
                    Vector3 normal = (camera.Right * n.X) + (camera.Up * n.Y) + (camera.Forward * n.Z);
                    Vector3 point = camera.Eye + (((camera.Right * ((x + 0.5f - (width * 0.5f)) * scale)) + (camera.Up * (((height * 0.5f) - y - 0.5f) * scale)) + camera.Forward) * z);
                    raw[pixel] = new Vector2(occlusion.Measure(x, y), shadow.Light(point, normal, x, y));
                }
            }
        }
    }

    private void SmoothTile(int tile)
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
                    smooth[pixel] = Mean(x, y, surface.Depths[pixel]);
                }
            }
        }
    }

    private Vector2 Mean(int x, int y, float z)
    {
        const int Before = (SunflowerPattern.Side / 2) - 1;
        const int After = SunflowerPattern.Side / 2;
        int lastX = Math.Min(width - 1, x + After);
        int lastY = Math.Min(height - 1, y + After);
        float openness = 0f;
        float key = 0f;
        int count = 0;
        for (int sy = Math.Max(0, y - Before); sy <= lastY; sy++)
        {
            for (int sx = Math.Max(0, x - Before); sx <= lastX; sx++)
            {
                int at = (sy * width) + sx;
                if (Math.Abs(surface.Depths[at] - z) < depthLimit)
                {
                    openness += raw[at].X;
                    key += raw[at].Y;
                    count++;
                }
            }
        }

        return new Vector2(openness / count, key / count);
    }
}
