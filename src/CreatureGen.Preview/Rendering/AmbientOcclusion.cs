using System;
using System.Numerics;
using System.Runtime.Intrinsics;
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

    // A multiple of four points, which are measured four at a time.
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

        // Where nothing is seen depth is zero: beyond the radius, as long as that is smaller than the distance to the camera.
        float within = Math.Min(radius, z * 0.5f);
        float reach = Math.Min(LargestRadiusPixels, within * pixelsPerTangent / z);
        if (reach < SmallestRadiusPixels)
        {
            return 1f;
        }

        float scale = 1f / pixelsPerTangent;
        float halfWidth = (width * 0.5f) - 0.5f;
        float halfHeight = (height * 0.5f) - 0.5f;
        Vector128<float> px = Vector128.Create((x - halfWidth) * z * scale);
        Vector128<float> py = Vector128.Create((halfHeight - y) * z * scale);
        Vector3 normal = surface.Normals[pixel];
        Vector128<float> inverseSquare = Vector128.Create(1f / (within * within));
        Vector128<float> bias = Vector128.Create(within * Bias);
        Vector128<float> sum = Vector128<float>.Zero;
        Vector128<int> lastX = Vector128.Create(width - 1);
        Vector128<int> lastY = Vector128.Create(height - 1);
        Pattern.Points(x, y, out ReadOnlySpan<float> pointX, out ReadOnlySpan<float> pointY);
        for (int i = 0; i < Pattern.Count; i += Vector128<float>.Count)
        {
            // Rounded to the nearest pixel by way of positive numbers; beyond the frame its edge is taken.
            Vector128<int> sx = Round(Vector128.Create(pointX.Slice(i, 4)) * reach, x);
            Vector128<int> sy = Round(Vector128.Create(pointY.Slice(i, 4)) * reach, y);
            sx = Vector128.Min(Vector128.Max(sx, Vector128<int>.Zero), lastX);
            sy = Vector128.Min(Vector128.Max(sy, Vector128<int>.Zero), lastY);
            Vector128<int> at = (sy * width) + sx;
            Vector128<float> sz = Vector128.Create(depths[at[0]], depths[at[1]], depths[at[2]], depths[at[3]]);
            Vector128<float> sScale = sz * scale;
            Vector128<float> dx = ((Vector128.ConvertToSingle(sx) - Vector128.Create(halfWidth)) * sScale) - px;
            Vector128<float> dy = ((Vector128.Create(halfHeight) - Vector128.ConvertToSingle(sy)) * sScale) - py;
            Vector128<float> dz = sz - Vector128.Create(z);
            Vector128<float> rise = (dx * normal.X) + (dy * normal.Y) + (dz * normal.Z) - bias;
            Vector128<float> square = ((dx * dx) + (dy * dy) + (dz * dz)) * inverseSquare;
            Vector128<float> near = Vector128.Max(Vector128<float>.One - square, Vector128<float>.Zero);
            sum += near * near * near * Vector128.Max(rise, Vector128<float>.Zero) / (square + Vector128.Create(0.01f));
        }

        float total = (sum[0] + sum[1]) + (sum[2] + sum[3]);
        return Math.Max(0f, 1f - (total * (Strength / (Pattern.Count * within))));
    }

    private static Vector128<int> Round(Vector128<float> offset, int centre)
    {
        const int Positive = 256;
        return Vector128.ConvertToInt32(offset + Vector128.Create(centre + Positive + 0.5f)) - Vector128.Create(Positive);
    }
}
