using System;
using System.Collections.Generic;
using CreatureGen.Genetics.Criteria;

namespace CreatureGen.Preview.Pictures;

/// <summary>Takes the outline of what is in a picture.</summary>
public static class Cutout
{
    /// <summary>Greatest difference of a channel from the background that still is background.</summary>
    private const int Tolerance = 40;

    /// <summary>The outline of what stands out: what is opaque, or where nothing is clear, what differs from the colour that most of the picture's edge has.</summary>
    /// <exception cref="ArgumentException">Nothing stands out.</exception>
    public static OutlineMask Of(Picture picture)
    {
        ArgumentNullException.ThrowIfNull(picture);
        bool cut = HasClearPixels(picture);
        Pixel background = cut ? default : EdgeColour(picture);
        var inside = new bool[picture.Width * picture.Height];
        for (int y = 0; y < picture.Height; y++)
        {
            for (int x = 0; x < picture.Width; x++)
            {
                Pixel pixel = picture[x, y];
                inside[(y * picture.Width) + x] = cut ? pixel.A >= 128 : Difference(pixel, background) > Tolerance;
            }
        }

        return new OutlineMask(inside, picture.Width, picture.Height);
    }

    private static bool HasClearPixels(Picture picture)
    {
        for (int y = 0; y < picture.Height; y++)
        {
            for (int x = 0; x < picture.Width; x++)
            {
                if (picture[x, y].A < 128)
                {
                    return true;
                }
            }
        }

        return false;
    }

    private static Pixel EdgeColour(Picture picture)
    {
        var counts = new SortedDictionary<int, (int Count, Pixel Colour)>();
        for (int x = 0; x < picture.Width; x++)
        {
            Add(picture[x, 0]);
            Add(picture[x, picture.Height - 1]);
        }

        for (int y = 0; y < picture.Height; y++)
        {
            Add(picture[0, y]);
            Add(picture[picture.Width - 1, y]);
        }

        (int Count, Pixel Colour) max = default;
        foreach ((int Count, Pixel Colour) one in counts.Values)
        {
            max = one.Count > max.Count ? one : max;
        }

        return max.Colour;

        void Add(Pixel pixel)
        {
            int key = (pixel.R << 16) | (pixel.G << 8) | pixel.B;
            counts[key] = (counts.TryGetValue(key, out (int Count, Pixel Colour) known) ? known.Count + 1 : 1, pixel);
        }
    }

    private static int Difference(Pixel a, Pixel b) => Math.Max(Math.Abs(a.R - b.R), Math.Max(Math.Abs(a.G - b.G), Math.Abs(a.B - b.B)));
}
