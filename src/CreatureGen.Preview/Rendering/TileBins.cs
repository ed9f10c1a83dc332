using System;

namespace CreatureGen.Preview.Rendering;

/// <summary>Which triangles may touch which tile of the picture, in their order.</summary>
internal sealed class TileBins
{
    private readonly int[] starts;
    private readonly int[] members;

    public TileBins(ReadOnlySpan<ScreenTriangle> triangles, int width, int height)
    {
        Width = width;
        Height = height;
        Columns = (width + Rasteriser.TileSize - 1) / Rasteriser.TileSize;
        int rows = (height + Rasteriser.TileSize - 1) / Rasteriser.TileSize;
        Count = Columns * rows;
        starts = new int[Count + 1];
        foreach (ref readonly ScreenTriangle t in triangles)
        {
            for (int row = t.MinY / Rasteriser.TileSize; row <= t.MaxY / Rasteriser.TileSize; row++)
            {
                for (int column = t.MinX / Rasteriser.TileSize; column <= t.MaxX / Rasteriser.TileSize; column++)
                {
                    starts[(row * Columns) + column + 1]++;
                }
            }
        }

        for (int i = 0; i < Count; i++)
        {
            starts[i + 1] += starts[i];
        }

        members = new int[starts[Count]];
        int[] next = starts.AsSpan(0, Count).ToArray();
        for (int i = 0; i < triangles.Length; i++)
        {
            ref readonly ScreenTriangle t = ref triangles[i];
            for (int row = t.MinY / Rasteriser.TileSize; row <= t.MaxY / Rasteriser.TileSize; row++)
            {
                for (int column = t.MinX / Rasteriser.TileSize; column <= t.MaxX / Rasteriser.TileSize; column++)
                {
                    members[next[(row * Columns) + column]++] = i;
                }
            }
        }
    }

    /// <summary>Pixels in a row of the picture.</summary>
    public int Width { get; }

    /// <summary>Rows of the picture.</summary>
    public int Height { get; }

    /// <summary>Tiles in a row.</summary>
    public int Columns { get; }

    /// <summary>Tiles of the picture.</summary>
    public int Count { get; }

    /// <summary>The triangles that may touch a tile.</summary>
    public ReadOnlySpan<int> this[int tile] => members.AsSpan(starts[tile], starts[tile + 1] - starts[tile]);

    /// <summary>The pixels of a tile; right and bottom are excluded.</summary>
    public void Pixels(int tile, out int left, out int top, out int right, out int bottom)
    {
        left = (tile % Columns) * Rasteriser.TileSize;
        top = (tile / Columns) * Rasteriser.TileSize;
        right = Math.Min(left + Rasteriser.TileSize, Width);
        bottom = Math.Min(top + Rasteriser.TileSize, Height);
    }
}
