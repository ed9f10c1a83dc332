using System;
using System.Linq;
using System.Threading;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Preview.Sheets;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class ContactSheetTests
{
    private static readonly Pixel ink = new(255, 255, 255);
    private static readonly Pixel paper = new(9, 9, 9);
    private static readonly ContactSheetOptions small = new() { Columns = 3, CellWidth = 20, CellHeight = 16, Gap = 2, Ink = ink, Paper = paper, Threads = 1 };

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(3)]
    [InlineData(4)]
    [InlineData(7)]
    public void Cells_are_in_their_places_row_by_row_with_paper_around_them(int count)
    {
        Picture sheet = ContactSheet.Render(Enumerable.Range(0, count).Select(i => Coloured(i, "")).ToArray(), small, TestContext.Current.CancellationToken);
        int columns = Math.Min(3, count);
        int rows = (count + 2) / 3;
        Assert.Equal((2 + (22 * columns), 2 + (18 * rows)), (sheet.Width, sheet.Height));
        for (int y = 0; y < sheet.Height; y++)
        {
            for (int x = 0; x < sheet.Width; x++)
            {
                int column = (x - 2) / 22;
                int row = (y - 2) / 18;
                bool inside = x >= 2 && y >= 2 && (x - 2) % 22 < 20 && (y - 2) % 18 < 16 && (row * 3) + column < count;
                Assert.Equal(inside ? Colour((row * 3) + column) : paper, sheet[x, y]);
            }
        }
    }

    [Fact]
    public void A_label_is_cut_so_that_it_stays_in_its_cell()
    {
        Picture sheet = ContactSheet.Render([Coloured(0, "a label much wider than its cell"), Coloured(1, "")], small with { CellWidth = 60 }, TestContext.Current.CancellationToken);
        int[] columns = Enumerable.Range(0, sheet.Width).Where(x => Enumerable.Range(0, sheet.Height).Any(y => sheet[x, y] == ink)).ToArray();
        Assert.NotEmpty(columns);
        Assert.True(columns[0] >= 2 + 5 && columns[^1] < 2 + 60 - 5, $"ink from {columns[0]} to {columns[^1]}");
    }

    [Fact]
    public void A_title_stands_above_the_cells_and_moves_them_down()
    {
        Picture plain = ContactSheet.Render([Coloured(0, "")], small with { CellWidth = 100 }, TestContext.Current.CancellationToken);
        Picture titled = ContactSheet.Render([Coloured(0, "")], small with { CellWidth = 100, Title = "swimmers from 1 to 24" }, TestContext.Current.CancellationToken);
        int down = titled.Height - plain.Height;
        Assert.True(down > 0);
        Assert.Contains(ink, Enumerable.Range(0, titled.Width * down).Select(i => titled[i % titled.Width, i / titled.Width]));
        for (int i = 0; i < plain.Width * plain.Height; i++)
        {
            Assert.Equal(plain[i % plain.Width, i / plain.Width], titled[i % plain.Width, (i / plain.Width) + down]);
        }
    }

    [Fact]
    public void A_transparent_cell_lies_on_the_paper()
    {
        var clear = new SheetCell("", (width, height) => new Picture(width, height, PixelLayout.Rgba) { [3, 4] = new Pixel(1, 2, 3) });
        Picture sheet = ContactSheet.Render([clear], small, TestContext.Current.CancellationToken);
        Assert.Equal(new Pixel(1, 2, 3), sheet[2 + 3, 2 + 4]);
        Assert.Equal(paper, sheet[2 + 4, 2 + 4]);
    }

    [Fact]
    public void A_sheet_of_creatures_is_the_same_for_any_number_of_threads()
    {
        SheetCell[] cells = Enumerable.Range(1, 5).Select(i => new SheetCell(
            $"seed {i}",
            (width, height) => Portrait.Take(PreviewSubjects.Of((ulong)i), View.ThreeQuarter, new RenderOptions { Width = width, Height = height }))).ToArray();
        ContactSheetOptions options = small with { CellWidth = 90, CellHeight = 70 };
        byte[] one = ContactSheet.Render(cells, options, TestContext.Current.CancellationToken).Bytes.ToArray();
        foreach (int threads in new[] { 2, 5, 16 })
        {
            Assert.Equal(one, ContactSheet.Render(cells, options with { Threads = threads }, TestContext.Current.CancellationToken).Bytes.ToArray());
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    public void A_cell_of_another_size_is_refused_by_name(int threads)
    {
        var wrong = new SheetCell("the odd one", (width, height) => new Picture(width, height + 1, PixelLayout.Rgb));
        var error = Assert.Throws<ArgumentException>(() => ContactSheet.Render([Coloured(0, ""), wrong], small with { Threads = threads }, TestContext.Current.CancellationToken));
        Assert.Contains("cell 1", error.Message, StringComparison.Ordinal);
        Assert.Contains("the odd one", error.Message, StringComparison.Ordinal);
        Assert.Contains("20 × 16", error.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Bad_options_are_refused()
    {
        SheetCell[] cells = [Coloured(0, "")];
        Assert.Throws<ArgumentException>(() => ContactSheet.Render([], small, TestContext.Current.CancellationToken));
        foreach (ContactSheetOptions bad in new[] { small with { Columns = 0 }, small with { CellWidth = 0 }, small with { CellHeight = 0 }, small with { Gap = -1 }, small with { Threads = 0 } })
        {
            Assert.Throws<ArgumentOutOfRangeException>(() => ContactSheet.Render(cells, bad, TestContext.Current.CancellationToken));
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(4)]
    public void It_stops_when_told_to(int threads)
    {
        using var stop = new CancellationTokenSource();
        SheetCell[] cells = Enumerable.Range(0, 40).Select(i => new SheetCell("", (width, height) =>
        {
            stop.Cancel();
            return new Picture(width, height, PixelLayout.Rgb);
        })).ToArray();
        Assert.ThrowsAny<OperationCanceledException>(() => ContactSheet.Render(cells, small with { Threads = threads }, stop.Token));
    }

    private static Pixel Colour(int index) => new((byte)(50 + (index * 20)), (byte)index, 7);

    private static SheetCell Coloured(int index, string label) => new(label, (width, height) =>
    {
        var picture = new Picture(width, height, PixelLayout.Rgb);
        picture.Fill(Colour(index));
        return picture;
    });
}
