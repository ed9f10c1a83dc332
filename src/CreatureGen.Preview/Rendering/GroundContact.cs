using System;
using System.Numerics;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>How much of the sky the creature hides from each point of the floor: dark and narrow under soles, faint and wide under a floating body.</summary>
/// <remarks>
/// A small horizontal patch at height h hides the part h²/(π(r²+h²)²) per area of a floor point at horizontal distance r: the whole part is its
/// area, spread over a width of about h. So the underside is sorted into layers of doubling height, and each layer is smoothed by its own height.
/// </remarks>
internal sealed class GroundContact
{
    private const int GridSize = 256;
    private const int LayerCount = 7;

    // Room for the widest layer around the creature, part of the grid at each edge.
    private const float Border = 0.25f;

    private readonly HeightRaster raster;
    private readonly SoftGrid total;

    public GroundContact(RenderMesh mesh)
    {
        raster = new HeightRaster(mesh, Vector3.UnitY, GridSize, Border);
        var layers = new SoftGrid[LayerCount];
        for (int i = 0; i < LayerCount; i++)
        {
            layers[i] = new SoftGrid(GridSize >> i);
        }

        for (int y = 0; y < GridSize; y++)
        {
            for (int x = 0; x < GridSize; x++)
            {
                float height = raster.Lowest[(y * GridSize) + x];
                if (height < float.PositiveInfinity)
                {
                    Sort(layers, x, y, height / raster.TexelSize);
                }
            }
        }

        // From the widest down, each added to the next finer one between its texels.
        for (int i = LayerCount - 1; i > 0; i--)
        {
            layers[i].Smooth();
            AddEnlarged(layers[i], layers[i - 1]);
        }

        layers[0].Smooth();
        total = layers[0];
    }

    /// <summary>The part of the sky, 0..1, that is hidden from the floor under a point.</summary>
    public float Hidden(Vector3 point)
    {
        raster.Locate(point, out float u, out float v);
        return Math.Min(1f, total.At(u, v));
    }

    // Shares a texel's area between the two layers next to its height; layer i stands for heights of about 2^i texels.
    private static void Sort(SoftGrid[] layers, int x, int y, float heightInTexels)
    {
        int layer = 0;
        float scaled = Math.Max(1f, heightInTexels);
        while (scaled >= 2f && layer < LayerCount - 1)
        {
            scaled *= 0.5f;
            layer++;
        }

        float upper = layer == LayerCount - 1 ? 0f : scaled - 1f;

        // Above the highest layer what is hidden spreads too wide to show.
        float part = layer == LayerCount - 1 && scaled > 1f ? 1f / (scaled * scaled) : 1f;
        Put(layers[layer], x >> layer, y >> layer, layer, (1f - upper) * part);
        if (upper > 0f)
        {
            Put(layers[layer + 1], x >> (layer + 1), y >> (layer + 1), layer + 1, upper * part);
        }
    }

    private static void Put(SoftGrid grid, int x, int y, int layer, float area)
    {
        // A texel of the full grid is a quarter of one of the next layer, and so on.
        grid.Values[(y * grid.Size) + x] += area / (1 << (2 * layer));
    }

    private static void AddEnlarged(SoftGrid coarse, SoftGrid fine)
    {
        for (int y = 0; y < fine.Size; y++)
        {
            for (int x = 0; x < fine.Size; x++)
            {
                fine.Values[(y * fine.Size) + x] += coarse.At((x + 0.5f) * 0.5f, (y + 0.5f) * 0.5f);
            }
        }
    }
}
