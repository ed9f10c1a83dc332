using System;

namespace CreatureGen.Preview.Pictures;

/// <summary>A picture of 8-bit sRGB pixels that can be drawn on. Row 0 is the top row.</summary>
public sealed class Picture
{
    /// <summary>Largest width and height, pixels.</summary>
    public const int LargestSide = 32768;

    private readonly byte[] bytes;

    /// <summary>A picture of zeros: black, and transparent where there is opacity.</summary>
    /// <exception cref="ArgumentOutOfRangeException">A side is not 1..<see cref="LargestSide"/>, or the picture would pass 2³¹ bytes.</exception>
    public Picture(int width, int height, PixelLayout layout)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(width, LargestSide);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        ArgumentOutOfRangeException.ThrowIfGreaterThan(height, LargestSide);
        Width = width;
        Height = height;
        Layout = layout;
        BytesPerPixel = layout == PixelLayout.Rgb ? 3 : 4;
        long size = (long)width * height * BytesPerPixel;
        if (size > Array.MaxLength)
        {
            throw new ArgumentOutOfRangeException(nameof(height), FormattableString.Invariant($"a picture of {width} × {height} pixels takes {size} bytes; expected at most {Array.MaxLength}"));
        }

        bytes = new byte[size];
    }

    /// <summary>Pixels in a row.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>What the bytes of a pixel are.</summary>
    public PixelLayout Layout { get; }

    /// <summary>3 or 4.</summary>
    public int BytesPerPixel { get; }

    /// <summary>Bytes in a row.</summary>
    public int Stride => Width * BytesPerPixel;

    /// <summary>All bytes, row by row from the top, no padding.</summary>
    public ReadOnlySpan<byte> Bytes => bytes;

    /// <summary>The pixel in column <paramref name="x"/> of row <paramref name="y"/>.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such pixel.</exception>
    public Pixel this[int x, int y]
    {
        get
        {
            int at = Offset(x, y);
            return new Pixel(bytes[at], bytes[at + 1], bytes[at + 2], BytesPerPixel == 4 ? bytes[at + 3] : (byte)255);
        }

        set
        {
            int at = Offset(x, y);
            bytes[at] = value.R;
            bytes[at + 1] = value.G;
            bytes[at + 2] = value.B;
            if (BytesPerPixel == 4)
            {
                bytes[at + 3] = value.A;
            }
        }
    }

    /// <summary>The bytes of row <paramref name="y"/>, to be written.</summary>
    /// <exception cref="ArgumentOutOfRangeException">There is no such row.</exception>
    public Span<byte> Row(int y)
    {
        ArgumentOutOfRangeException.ThrowIfNegative(y);
        ArgumentOutOfRangeException.ThrowIfGreaterThanOrEqual(y, Height);
        return bytes.AsSpan(y * Stride, Stride);
    }

    /// <summary>Gives every pixel one colour.</summary>
    public void Fill(Pixel colour) => Fill(colour, 0, 0, Width, Height);

    /// <summary>Gives the pixels of a rectangle one colour; what lies outside the picture is left out.</summary>
    public void Fill(Pixel colour, int left, int top, int width, int height)
    {
        int right = (int)Math.Min(Width, (long)left + width);
        int bottom = (int)Math.Min(Height, (long)top + height);
        for (int y = Math.Max(0, top); y < bottom; y++)
        {
            for (int x = Math.Max(0, left); x < right; x++)
            {
                this[x, y] = colour;
            }
        }
    }

    /// <summary>Copies <paramref name="source"/> with its top left pixel at (<paramref name="left"/>, <paramref name="top"/>); what lies outside is left out.</summary>
    /// <remarks>Opacity is copied, or taken as opaque, or dropped, as the layouts need.</remarks>
    public void Blit(Picture source, int left, int top)
    {
        int firstX = Math.Max(0, -left);
        int lastX = Math.Min(source.Width, Width - left);
        int firstY = Math.Max(0, -top);
        int lastY = Math.Min(source.Height, Height - top);
        if (firstX >= lastX)
        {
            return;
        }

        for (int y = firstY; y < lastY; y++)
        {
            if (source.Layout == Layout)
            {
                source.bytes.AsSpan(source.Offset(firstX, y), (lastX - firstX) * BytesPerPixel).CopyTo(bytes.AsSpan(Offset(left + firstX, top + y)));
                continue;
            }

            for (int x = firstX; x < lastX; x++)
            {
                this[left + x, top + y] = source[x, y];
            }
        }
    }

    /// <summary>Draws <paramref name="source"/> over this picture by its opacity, its top left pixel at (<paramref name="left"/>, <paramref name="top"/>).</summary>
    public void Overlay(Picture source, int left, int top)
    {
        int lastX = Math.Min(source.Width, Width - left);
        int lastY = Math.Min(source.Height, Height - top);
        for (int y = Math.Max(0, -top); y < lastY; y++)
        {
            for (int x = Math.Max(0, -left); x < lastX; x++)
            {
                Pixel over = source[x, y];
                if (over.A != 0)
                {
                    this[left + x, top + y] = Over(over, this[left + x, top + y]);
                }
            }
        }
    }

    /// <summary>Draws <paramref name="colour"/> over one pixel; <paramref name="coverage"/> 0..255 scales its opacity. Pixels outside are left out.</summary>
    internal void Blend(int x, int y, Pixel colour, int coverage)
    {
        if ((uint)x < (uint)Width && (uint)y < (uint)Height)
        {
            int alpha = ((colour.A * coverage) + 127) / 255;
            this[x, y] = Over(colour with { A = (byte)alpha }, this[x, y]);
        }
    }

    private static Pixel Over(Pixel over, Pixel under)
    {
        int a = over.A * 255;
        int b = under.A * (255 - over.A);
        int sum = a + b;
        if (sum == 0)
        {
            return under;
        }

        int half = sum / 2;
        return new Pixel(
            (byte)(((over.R * a) + (under.R * b) + half) / sum),
            (byte)(((over.G * a) + (under.G * b) + half) / sum),
            (byte)(((over.B * a) + (under.B * b) + half) / sum),
            (byte)((sum + 127) / 255));
    }

    private int Offset(int x, int y)
    {
        if ((uint)x >= (uint)Width || (uint)y >= (uint)Height)
        {
            throw new ArgumentOutOfRangeException(nameof(x), FormattableString.Invariant($"pixel ({x}, {y}); expected x in 0..{Width - 1} and y in 0..{Height - 1}"));
        }

        return ((y * Width) + x) * BytesPerPixel;
    }
}
