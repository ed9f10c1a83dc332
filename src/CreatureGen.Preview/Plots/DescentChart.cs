using System;
using System.Collections.Generic;
using System.Threading;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Sheets;

namespace CreatureGen.Preview.Plots;

/// <summary>That somebody descends from somebody in the row above.</summary>
/// <param name="Ancestor">Place in the row above.</param>
/// <param name="Descendant">Place in the row below.</param>
/// <param name="Fraction">How much of the descendant is of the ancestor, 0..1: how thick the line is.</param>
public sealed record Descent(int Ancestor, int Descendant, double Fraction);

/// <summary>A generation of a <see cref="DescentChart"/>.</summary>
/// <param name="Name">Above its left end; printable ASCII.</param>
/// <param name="Cells">Its creatures, at least one.</param>
/// <param name="Descents">From whom of the row above they come; of the first row nobody does.</param>
public sealed record DescentRow(string Name, IReadOnlyList<SheetCell> Cells, IReadOnlyList<Descent> Descents);

/// <summary>Draws a family tree: generations from the top, and lines from ancestors to descendants.</summary>
public static class DescentChart
{
    private const int Gap = 14;
    private const int LineRoom = 74;
    private const int Name = 18;
    private const int Thickest = 9;

    private static readonly Pixel paper = new(186, 189, 194);
    private static readonly Pixel ink = new(24, 27, 32);
    private static readonly Pixel line = new(120, 84, 60);

    /// <summary>Draws the rows.</summary>
    /// <param name="rows">From the oldest, at least one.</param>
    /// <param name="cellWidth">Pixels of a creature.</param>
    /// <param name="cellHeight">Pixels of a creature.</param>
    /// <param name="threads">Threads that draw, at least 1.</param>
    /// <param name="cancellation">Stops between creatures.</param>
    /// <exception cref="ArgumentException">There is no row, or a row is empty.</exception>
    public static Picture Draw(IReadOnlyList<DescentRow> rows, int cellWidth, int cellHeight, int threads, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(rows);
        int columns = 0;
        foreach (DescentRow row in rows)
        {
            columns = row.Cells.Count > 0 ? Math.Max(columns, row.Cells.Count) : throw new ArgumentException($"the row {row.Name} is empty; expected a creature", nameof(rows));
        }

        if (columns == 0)
        {
            throw new ArgumentException("there is no row; expected at least one", nameof(rows));
        }

        int width = Gap + (columns * (cellWidth + Gap));
        int pitch = Name + cellHeight + LineRoom;
        var picture = new Picture(width, (rows.Count * pitch) - LineRoom + Gap, PixelLayout.Rgb);
        picture.Fill(paper);
        for (int number = 0; number < rows.Count; number++)
        {
            DescentRow row = rows[number];
            int top = (number * pitch) + Name;
            foreach (Descent descent in row.Descents)
            {
                Curve(picture, Middle(rows[number - 1], descent.Ancestor, width, cellWidth), top - LineRoom - Name, Middle(row, descent.Descendant, width, cellWidth), top, descent.Fraction);
            }

            Label.Draw(picture, row.Name, Gap, top - Name + 6, LabelSize.Small, ink);
            Picture cells = ContactSheet.Render(row.Cells, new ContactSheetOptions { Columns = row.Cells.Count, CellWidth = cellWidth, CellHeight = cellHeight, Gap = Gap, Threads = threads, Paper = paper, Ink = ink }, cancellation);
            for (int i = 0; i < row.Cells.Count; i++)
            {
                Copy(cells, Gap + (i * (cellWidth + Gap)), Gap, picture, Middle(row, i, width, cellWidth) - (cellWidth / 2), top, cellWidth, cellHeight);
            }
        }

        return picture;
    }

    private static int Middle(DescentRow row, int place, int width, int cellWidth) =>
        ((width - (row.Cells.Count * (cellWidth + Gap)) + Gap) / 2) + (place * (cellWidth + Gap)) + (cellWidth / 2);

    private static void Copy(Picture from, int fromLeft, int fromTop, Picture to, int left, int top, int width, int height)
    {
        for (int y = 0; y < height; y++)
        {
            for (int x = 0; x < width; x++)
            {
                to[left + x, top + y] = from[fromLeft + x, fromTop + y];
            }
        }
    }

    /// <summary>A line that leaves and arrives upright.</summary>
    private static void Curve(Picture picture, int fromX, int fromY, int toX, int toY, double fraction)
    {
        int thickness = 1 + (int)Math.Round(fraction * (Thickest - 1));
        int steps = 4 * (Math.Abs(toX - fromX) + (toY - fromY));
        for (int i = 0; i <= steps; i++)
        {
            double t = (double)i / steps;
            double eased = t * t * (3 - (2 * t));
            picture.Fill(line, (int)(fromX + ((toX - fromX) * eased)) - (thickness / 2), (int)(fromY + ((toY - fromY) * t)), thickness, 2);
        }
    }
}
