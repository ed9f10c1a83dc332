using System;

namespace CreatureGen.Genetics.Criteria;

/// <summary>The outline of something from the side, as a picture of inside and outside.</summary>
public sealed class OutlineMask
{
    private readonly bool[] inside;

    /// <summary>Copies a picture.</summary>
    /// <param name="inside">Rows from the top, without gaps: whether each pixel is of the thing.</param>
    /// <param name="width">Columns, at least 1.</param>
    /// <param name="height">Rows, at least 1.</param>
    /// <exception cref="ArgumentException">The pixels are not as many as the size asks for, or none is inside.</exception>
    public OutlineMask(ReadOnlySpan<bool> inside, int width, int height)
    {
        if (width < 1 || height < 1 || inside.Length != (long)width * height)
        {
            throw new ArgumentException(FormattableString.Invariant($"{inside.Length} pixels for an outline of {width} × {height}; expected one for each place"), nameof(inside));
        }

        this.inside = inside.ToArray();
        if (Array.IndexOf(this.inside, true) < 0)
        {
            throw new ArgumentException("the picture is empty; expected an outline on a plain background", nameof(inside));
        }

        Width = width;
        Height = height;
    }

    /// <summary>Columns.</summary>
    public int Width { get; }

    /// <summary>Rows.</summary>
    public int Height { get; }

    /// <summary>Whether the pixel in a column and a row, from the top left, is of the thing.</summary>
    public bool this[int x, int y] => inside[(y * Width) + x];
}
