using System;
using System.Numerics;

namespace CreatureGen.Preview.Rendering;

/// <summary>
/// The shadow that the key light throws on the floor: sharp where the creature touches it, softer the farther away what throws it is.
/// </summary>
/// <remarks>
/// Everything is above the floor, so that the shadow is the outline of the creature seen from the light, smoothed. The smoothing of each place
/// follows from the mean distance between floor and creature around it (Fernando 2005, "Percentage-closer soft shadows"), read from a pyramid of
/// smoothed outlines instead of many samples.
/// </remarks>
internal sealed class GroundShadow
{
    // Standard deviation of level 0 in texels of the full grid: that of one smoothing.
    private const float FinestSpread = 1f;
    private const int LevelCount = 6;
    private const int DistanceLevel = 3;

    // How much the wide surroundings count for the distance; decides it only where there is nothing near.
    private const float WideWeight = 0.02f;

    private readonly HeightRaster raster;
    private readonly SoftGrid[] levels = new SoftGrid[LevelCount];
    private readonly SoftGrid[] distances = new SoftGrid[LevelCount];
    private readonly float spreadPerMetre;

    /// <summary>Takes the creature as the light sees it.</summary>
    /// <param name="raster">Heights along the direction to the light.</param>
    /// <param name="lightSize">Radius of the light divided by its distance.</param>
    public GroundShadow(HeightRaster raster, float lightSize)
    {
        this.raster = raster;

        // A disc of radius r has a standard deviation of r/2 along each axis.
        spreadPerMetre = lightSize * 0.5f / raster.TexelSize;
        var outline = new SoftGrid(raster.Size);
        var weighted = new SoftGrid(raster.Size);
        for (int y = 0; y < raster.Size; y++)
        {
            for (int x = 0; x < raster.Size; x++)
            {
                int at = (y * raster.Size) + x;
                if (raster.Lowest[at] < float.PositiveInfinity)
                {
                    // The floor along this ray is where y is zero.
                    float floor = -raster.PointAt(x + 0.5f, y + 0.5f).Y / raster.Direction.Y;
                    outline.Values[at] = 1f;
                    weighted.Values[at] = Math.Max(0f, raster.Lowest[at] - floor);
                }
            }
        }

        outline.Smooth();
        levels[0] = outline;
        distances[0] = weighted;
        for (int i = 1; i < LevelCount; i++)
        {
            levels[i] = levels[i - 1].Halved();
            levels[i].Smooth();
            distances[i] = distances[i - 1].Halved();
            if (i >= DistanceLevel)
            {
                distances[i].Smooth();
            }
        }
    }

    /// <summary>The part of the key light, 0..1, that is kept from a point of the floor.</summary>
    public float Shade(Vector3 floorPoint)
    {
        raster.Locate(floorPoint, out float u, out float v);
        float wide = Read(levels, LevelCount - 1, u, v);
        if (wide <= 0f)
        {
            return 0f;
        }

        float near = Read(levels, DistanceLevel, u, v);
        float distance = (Read(distances, DistanceLevel, u, v) + (WideWeight * Read(distances, LevelCount - 1, u, v))) / (near + (WideWeight * wide));
        float spread = distance * spreadPerMetre;

        // Level i has a standard deviation of about FinestSpread·2^i texels (1, 2.2, 4.6, …).
        int level = 0;
        float finer = FinestSpread;
        while (level < LevelCount - 1 && spread > finer * 2.15f)
        {
            finer *= 2.15f;
            level++;
        }

        float part = Math.Clamp((spread - finer) / (finer * 1.15f), 0f, 1f);
        float sharp = Read(levels, level, u, v);
        return part > 0f && level < LevelCount - 1 ? sharp + ((Read(levels, level + 1, u, v) - sharp) * part) : sharp;
    }

    private static float Read(SoftGrid[] grids, int level, float u, float v)
    {
        float scale = 1f / (1 << level);
        return grids[level].At(u * scale, v * scale);
    }
}
