using System;
using CreatureGen.Maths;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Scenes;

/// <summary>A picture laid over a surface, with its smaller copies. Coordinates beyond 0..1 take the colour of the nearest edge.</summary>
public sealed class Texture
{
    private readonly List<Level> levels = [];

    /// <summary>Takes the colours of a picture; its opacity does not count.</summary>
    public Texture(Picture picture)
    {
        ArgumentNullException.ThrowIfNull(picture);
        Width = picture.Width;
        Height = picture.Height;
        var texels = new Vector3[picture.Width * picture.Height];
        for (int i = 0; i < texels.Length; i++)
        {
            int at = i * picture.BytesPerPixel;
            texels[i] = new Vector3(SrgbCurve.Decode(picture.Bytes[at]), SrgbCurve.Decode(picture.Bytes[at + 1]), SrgbCurve.Decode(picture.Bytes[at + 2]));
        }

        var level = new Level(picture.Width, picture.Height, texels);
        levels.Add(level);
        while (level.Width > 1 || level.Height > 1)
        {
            level = Halve(level);
            levels.Add(level);
        }
    }

    /// <summary>Columns of the picture.</summary>
    public int Width { get; }

    /// <summary>Rows of the picture.</summary>
    public int Height { get; }

    /// <summary>Linear RGB at a place, between the four nearest texels of a level.</summary>
    /// <param name="u">0 is the left edge, 1 the right one.</param>
    /// <param name="v">0 is the upper edge, 1 the lower one.</param>
    /// <param name="level">0 is the whole picture; each level has half the rows and columns of the one before.</param>
    internal Vector3 Sample(float u, float v, int level)
    {
        Level source = levels[Math.Clamp(level, 0, levels.Count - 1)];
        float x = (Math.Clamp(u, 0f, 1f) * source.Width) - 0.5f;
        float y = (Math.Clamp(v, 0f, 1f) * source.Height) - 0.5f;
        int x0 = (int)MathF.Floor(x);
        int y0 = (int)MathF.Floor(y);
        float fx = x - x0;
        float fy = y - y0;
        int x1 = Math.Min(x0 + 1, source.Width - 1);
        int y1 = Math.Min(y0 + 1, source.Height - 1);
        x0 = Math.Max(0, x0);
        y0 = Math.Max(0, y0);
        Vector3[] texels = source.Texels;
        Vector3 upper = (texels[(y0 * source.Width) + x0] * (1f - fx)) + (texels[(y0 * source.Width) + x1] * fx);
        Vector3 lower = (texels[(y1 * source.Width) + x0] * (1f - fx)) + (texels[(y1 * source.Width) + x1] * fx);
        return (upper * (1f - fy)) + (lower * fy);
    }

    /// <summary>The level of which a texel covers about as much as a pixel, for texels per pixel given as an area.</summary>
    internal static int LevelFor(float texelsPerPixel)
    {
        // Each level has a quarter of the texels; the step is where half a level away is nearer the next.
        int level = 0;
        while (texelsPerPixel > 2f && level < 16)
        {
            texelsPerPixel *= 0.25f;
            level++;
        }

        return level;
    }

    private static Level Halve(Level source)
    {
        int width = Math.Max(1, source.Width / 2);
        int height = Math.Max(1, source.Height / 2);
        var texels = new Vector3[width * height];
        for (int y = 0; y < height; y++)
        {
            int y0 = Math.Min(2 * y, source.Height - 1) * source.Width;
            int y1 = Math.Min((2 * y) + 1, source.Height - 1) * source.Width;
            for (int x = 0; x < width; x++)
            {
                int x0 = Math.Min(2 * x, source.Width - 1);
                int x1 = Math.Min((2 * x) + 1, source.Width - 1);
                texels[(y * width) + x] = (source.Texels[y0 + x0] + source.Texels[y0 + x1] + source.Texels[y1 + x0] + source.Texels[y1 + x1]) * 0.25f;
            }
        }

        return new Level(width, height, texels);
    }

    private sealed record Level(int Width, int Height, Vector3[] Texels);
}
