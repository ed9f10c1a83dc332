using System;
using System.Collections.Generic;
using System.Threading;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;

namespace CreatureGen.Preview.Sheets;

/// <summary>Many pictures in a grid, each with its label. Cells are drawn on several threads; the sheet is the same for any number of them.</summary>
public static class ContactSheet
{
    // From the corner of a cell to its label.
    private const int LabelInset = 5;
    private const int TitleInset = 8;
    private const LabelSize TitleSize = LabelSize.Medium;

    /// <summary>Draws all cells, row by row.</summary>
    /// <param name="cells">At least one.</param>
    /// <param name="options">The layout.</param>
    /// <param name="cancellation">Stops between cells.</param>
    /// <exception cref="ArgumentException">There is no cell, or a cell makes a picture of another size than asked for.</exception>
    /// <exception cref="ArgumentOutOfRangeException">An option is out of its range.</exception>
    /// <exception cref="OperationCanceledException">It was stopped.</exception>
    public static Picture Render(IReadOnlyList<SheetCell> cells, ContactSheetOptions options, CancellationToken cancellation = default)
    {
        ArgumentNullException.ThrowIfNull(cells);
        ArgumentNullException.ThrowIfNull(options);
        if (cells.Count == 0)
        {
            throw new ArgumentException("no cells; expected at least one", nameof(cells));
        }

        ArgumentOutOfRangeException.ThrowIfLessThan(options.Columns, 1, nameof(options.Columns));
        ArgumentOutOfRangeException.ThrowIfLessThan(options.CellWidth, 1, nameof(options.CellWidth));
        ArgumentOutOfRangeException.ThrowIfLessThan(options.CellHeight, 1, nameof(options.CellHeight));
        ArgumentOutOfRangeException.ThrowIfNegative(options.Gap, nameof(options.Gap));
        ArgumentOutOfRangeException.ThrowIfLessThan(options.Threads, 1, nameof(options.Threads));

        int columns = Math.Min(options.Columns, cells.Count);
        int rows = (cells.Count + columns - 1) / columns;
        int titleHeight = options.Title.Length > 0 ? (2 * TitleInset) + Label.LineHeight(TitleSize) : 0;
        var sheet = new Picture(
            checked(options.Gap + (columns * (options.CellWidth + options.Gap))),
            checked(titleHeight + options.Gap + (rows * (options.CellHeight + options.Gap))),
            PixelLayout.Rgb);
        sheet.Fill(options.Paper);
        if (titleHeight > 0)
        {
            string title = Label.Fit(options.Title, TitleSize, sheet.Width - (2 * TitleInset));
            Label.Draw(sheet, title, TitleInset, TitleInset, TitleSize, options.Ink);
        }

        // Cells do not overlap, so that each may be put onto the sheet by whoever drew it.
        Work.Share(cells.Count, options.Threads, i =>
        {
            cancellation.ThrowIfCancellationRequested();
            int left = options.Gap + ((i % columns) * (options.CellWidth + options.Gap));
            int top = titleHeight + options.Gap + ((i / columns) * (options.CellHeight + options.Gap));
            DrawCell(sheet, cells[i], i, left, top, options);
        });
        return sheet;
    }

    private static void DrawCell(Picture sheet, SheetCell cell, int index, int left, int top, ContactSheetOptions options)
    {
        Picture picture = cell.Draw(options.CellWidth, options.CellHeight);
        if (picture.Width != options.CellWidth || picture.Height != options.CellHeight)
        {
            throw new ArgumentException(FormattableString.Invariant(
                $"cell {index} (\"{cell.Label}\") made a picture of {picture.Width} × {picture.Height}; expected {options.CellWidth} × {options.CellHeight}"));
        }

        if (picture.Layout == PixelLayout.Rgb)
        {
            sheet.Blit(picture, left, top);
        }
        else
        {
            sheet.Overlay(picture, left, top);
        }

        string label = Label.Fit(cell.Label, options.LabelSize, options.CellWidth - (2 * LabelInset));
        Label.Draw(sheet, label, left + LabelInset, top + LabelInset, options.LabelSize, options.Ink);
    }
}
