using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Plots;
using CreatureGen.Preview.Sheets;
using Xunit;

namespace CreatureGen.Tests.Preview;

public sealed class PlotTests
{
    private static readonly Pixel Red = new(200, 0, 0);
    private static readonly Pixel Blue = new(0, 0, 200);

    [Fact]
    public void A_curve_that_rises_evenly_is_a_straight_line_from_its_first_to_its_last_value()
    {
        Picture plot = CurvePlot.Draw("title", "step", [new Curve("up", [0, 1, 2, 3, 4], Red), new Curve("flat", [2, 2, 2, 2, 2], Blue)], 400, 300);
        (int X, int Y)[] red = Where(plot, Red).Where(at => at.X < 400 - 100).ToArray();
        int left = red.Min(at => at.X), right = red.Max(at => at.X), bottom = red.Max(at => at.Y), top = red.Min(at => at.Y);
        foreach ((int x, int y) in red)
        {
            Assert.InRange(y - (bottom - ((bottom - top) * (double)(x - left) / (right - left))), -7, 7);
        }

        int[] rows = Where(plot, Blue).Where(at => at.X > left && at.X < right - 8).Select(at => at.Y).Distinct().ToArray();
        Assert.InRange(rows.Length, 1, 3);
        Assert.InRange(rows[0], ((top + bottom) / 2) - 6, ((top + bottom) / 2) + 6);
    }

    [Fact]
    public void Values_that_are_none_and_plots_of_nothing_are_refused()
    {
        Assert.Throws<ArgumentException>(() => CurvePlot.Draw("t", "s", [], 400, 300));
        Assert.Throws<ArgumentException>(() => CurvePlot.Draw("t", "s", [new Curve("a", [], Red)], 400, 300));
        Assert.Contains("a has the value NaN", Assert.Throws<ArgumentException>(() => CurvePlot.Draw("t", "s", [new Curve("a", [double.NaN], Red)], 400, 300)).Message, StringComparison.Ordinal);
        Assert.NotNull(CurvePlot.Draw("t", "s", [new Curve("a", [0], Red)], 400, 300));
        Assert.Throws<ArgumentException>(() => DescentChart.Draw([], 60, 40, 1, TestContext.Current.CancellationToken));
        Assert.Throws<ArgumentException>(() => DescentChart.Draw([new DescentRow("r", [], [])], 60, 40, 1, TestContext.Current.CancellationToken));
    }

    [Fact]
    public void A_family_tree_joins_the_middles_of_ancestors_and_descendants()
    {
        SheetCell Plain(Pixel colour) => new("", (width, height) =>
        {
            var picture = new Picture(width, height, PixelLayout.Rgb);
            picture.Fill(colour);
            return picture;
        });
        DescentRow[] rows = [new("old", [Plain(Red), Plain(Blue)], []), new("new", [Plain(Red)], [new Descent(1, 0, 1)])];
        Picture tree = DescentChart.Draw(rows, 60, 40, 1, TestContext.Current.CancellationToken);
        Assert.Equal(2 * 60 * 40, Where(tree, Red).Count);
        Assert.Equal(60 * 40, Where(tree, Blue).Count);

        // From below the second of the upper row to above the middle of the lower one.
        List<(int X, int Y)> line = Where(tree, new Pixel(120, 84, 60));
        int upper = line.Min(at => at.Y), lower = line.Max(at => at.Y);
        Assert.InRange(line.Where(at => at.Y == upper).Average(at => at.X), Where(tree, Blue).Average(at => at.X) - 3, Where(tree, Blue).Average(at => at.X) + 3);
        Assert.InRange(line.Where(at => at.Y == lower).Average(at => at.X), (tree.Width / 2) - 3, (tree.Width / 2) + 3);
        Assert.Equal(DescentChart.Draw(rows, 60, 40, 3, TestContext.Current.CancellationToken).Bytes.ToArray(), tree.Bytes.ToArray());
    }

    private static List<(int X, int Y)> Where(Picture picture, Pixel colour) =>
        (from y in Enumerable.Range(0, picture.Height) from x in Enumerable.Range(0, picture.Width) where picture[x, y] == colour select (x, y)).ToList();
}
