using System;
using System.Numerics;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>How open a visible place is to the light around it, from the depths of the picture.</summary>
/// <remarks>Based on: McGuire, Mara and Luebke 2012, "Scalable ambient obscurance", the estimate of section 2.4.</remarks>
internal sealed class AmbientOcclusion
{
    private const float LargestRadiusPixels = 96f;
    private const float SmallestRadiusPixels = 1.5f;
    private const float Strength = 2.6f;

    // Part of the radius by which a sample must rise above the surface to count: hides the facets.
    private const float Bias = 0.02f;

    private static readonly SunflowerPattern Pattern = new(12);

    private readonly VisibleSurface surface;
    private readonly float radius;
    private readonly float pixelsPerTangent;
    private readonly int width;
    private readonly int height;

    /// <summary>Prepares it for what a camera sees.</summary>
    /// <param name="surface">What is seen.</param>
    /// <param name="camera">From where.</param>
    /// <param name="radius">Distance within which surfaces shade each other, metres.</param>
    public AmbientOcclusion(VisibleSurface surface, Camera camera, float radius)
    {
        this.surface = surface;
        this.radius = radius;
        width = surface.Bins.Width;
        height = surface.Bins.Height;
        pixelsPerTangent = camera.PixelsPerTangent(height);
    }

    /// <summary>1 where a place is open, 0 where it is closed in; a rough estimate to be averaged over the square of <see cref="SunflowerPattern"/>.</summary>
    public float Measure(int x, int y)
    {
        float[] depths = surface.Depths;
        int pixel = (y * width) + x;
        float z = depths[pixel];
        float reach = Math.Min(LargestRadiusPixels, radius * pixelsPerTangent / z);
        if (reach < SmallestRadiusPixels)
        {
            return 1f;
        }

        float scale = 1f / pixelsPerTangent;
        float halfWidth = (width * 0.5f) - 0.5f;
        float halfHeight = (height * 0.5f) - 0.5f;
        float zScale = z * scale;
        float px = (x - halfWidth) * zScale;
        float py = (halfHeight - y) * zScale;
        Vector3 normal = surface.Normals[pixel];
        float inverseSquare = 1f / (radius * radius);
        float bias = radius * Bias;
        float sum = 0f;
        ReadOnlySpan<Vector2> points = Pattern[x, y];
        foreach (Vector2 point in points)
        {
            // Rounded by way of positive numbers.
            int sx = (int)(x + (point.X * reach) + 256.5f) - 256;
            int sy = (int)(y + (point.Y * reach) + 256.5f) - 256;
            if ((uint)sx >= (uint)width || (uint)sy >= (uint)height)
            {
                continue;
            }

            float sz = depths[(sy * width) + sx];
            if (sz == 0f)
            {
                continue;
            }

            float sScale = sz * scale;
            float dx = ((sx - halfWidth) * sScale) - px;
            float dy = ((halfHeight - sy) * sScale) - py;
            float dz = sz - z;
            float rise = (dx * normal.X) + (dy * normal.Y) + (dz * normal.Z) - bias;
            float square = ((dx * dx) + (dy * dy) + (dz * dz)) * inverseSquare;
            float near = 1f - square;
            if (rise > 0f && near > 0f)
            {
                sum += near * near * near * rise / (square + 0.01f);
            }
        }

        return Math.Max(0f, 1f - (sum * (Strength / (points.Length * radius))));
    }
}
