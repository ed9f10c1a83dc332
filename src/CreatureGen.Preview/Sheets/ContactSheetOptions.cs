using System;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Sheets;

/// <summary>How a <see cref="ContactSheet"/> is laid out.</summary>
public sealed record ContactSheetOptions
{
    /// <summary>Cells in a row, at least 1.</summary>
    public int Columns { get; init; } = 6;

    /// <summary>Width of a cell, pixels.</summary>
    public int CellWidth { get; init; } = 340;

    /// <summary>Height of a cell, pixels.</summary>
    public int CellHeight { get; init; } = 280;

    /// <summary>Pixels between cells, and around them.</summary>
    public int Gap { get; init; }

    /// <summary>Line of text above all cells; empty for none.</summary>
    public string Title { get; init; } = "";

    /// <summary>Size of the labels' letters.</summary>
    public LabelSize LabelSize { get; init; } = LabelSize.Small;

    /// <summary>Colour of labels and title.</summary>
    public Pixel Ink { get; init; } = new(24, 27, 32);

    /// <summary>Colour between and beyond the cells.</summary>
    public Pixel Paper { get; init; } = new(186, 189, 194);

    /// <summary>Threads that draw cells, at least 1. The sheet is the same for any number.</summary>
    public int Threads { get; init; } = Environment.ProcessorCount;
}
