using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Preview.Rendering;

/// <summary>How much of the key light reaches points of the creature past the creature itself: shadows are sharp near what throws them and soft far from it.</summary>
/// <remarks>
/// Based on: Fernando 2005, "Percentage-closer soft shadows": the mean distance of what is in the way gives the radius over which to average.
/// Heights are compared with the plane of the surface, not with the point alone, so that a slope does not shade itself.
/// </remarks>
internal sealed class ShadowMap
{
    private const float SmallestRadius = 1.5f;
    private const float LargestRadius = 24f;

    // Part of the height of the map that what throws a shadow may be away for its softness to be found.
    private const float SearchPart = 0.25f;

    // Cosine of the steepest slope to the light whose plane is followed.
    private const float MinCosine = 0.2f;

    private static readonly SunflowerPattern SearchPattern = new(6);
    private static readonly SunflowerPattern AveragePattern = new(8);

    private readonly HeightRaster raster;
    private readonly float searchRadius;
    private readonly float radiusPerMetre;
    private readonly float bias;

    public ShadowMap(HeightRaster raster, float lightSize)
    {
        this.raster = raster;
        radiusPerMetre = lightSize / raster.TexelSize;
        searchRadius = Math.Clamp(raster.Size * SearchPart * lightSize, SmallestRadius, LargestRadius);
        bias = raster.TexelSize * 1.5f;
    }

    /// <summary>The part of the key light, 0..1, that reaches a point with the given unit normal; a rough estimate to be averaged over the square of <see cref="SunflowerPattern"/>.</summary>
    public float Light(Vector3 point, Vector3 normal, int x, int y)
    {
        float cosine = Vec.Dot(normal, raster.Direction);
        if (cosine <= 0f)
        {
            return 0f;
        }

        Vector3 lifted = point + (normal * raster.TexelSize);
        raster.Locate(lifted, out float u, out float v);
        float height = Vec.Dot(lifted, raster.Direction) + bias;
        float slope = -raster.TexelSize / Math.Max(MinCosine, cosine);
        float slopeU = slope * Vec.Dot(normal, raster.AxisU);
        float slopeV = slope * Vec.Dot(normal, raster.AxisV);

        float distance = 0f;
        int blockers = 0;
        SearchPattern.Points(x, y, out ReadOnlySpan<float> offsetX, out ReadOnlySpan<float> offsetY);
        for (int i = 0; i < offsetX.Length; i++)
        {
            float du = offsetX[i] * searchRadius;
            float dv = offsetY[i] * searchRadius;
            float over = HeightAt(u + du, v + dv) - (height + (slopeU * du) + (slopeV * dv));
            distance += Math.Max(0f, over);
            blockers += over > 0f ? 1 : 0;
        }

        if (blockers == 0)
        {
            return 1f;
        }

        float radius = Math.Clamp(distance / blockers * radiusPerMetre, SmallestRadius, searchRadius);
        AveragePattern.Points(x, y, out offsetX, out offsetY);
        int open = 0;
        for (int i = 0; i < offsetX.Length; i++)
        {
            float du = offsetX[i] * radius;
            float dv = offsetY[i] * radius;
            open += HeightAt(u + du, v + dv) <= height + (slopeU * du) + (slopeV * dv) ? 1 : 0;
        }

        return open / (float)offsetX.Length;
    }

    // Beyond the grid its edge is taken, where there is nothing.
    private float HeightAt(float u, float v)
    {
        int last = raster.Size - 1;
        int x = Math.Min(Math.Max((int)u, 0), last);
        int y = Math.Min(Math.Max((int)v, 0), last);
        return raster.Highest[(y * raster.Size) + x];
    }
}
