using System;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Sheets;

/// <summary>One picture of a <see cref="ContactSheet"/>.</summary>
/// <param name="Label">Line of text at its top left; empty for none. What does not fit is cut.</param>
/// <param name="Draw">Makes the picture in the given width and height, pixels. Called once, on any thread; must not depend on what other cells do.</param>
public sealed record SheetCell(string Label, Func<int, int, Picture> Draw);
