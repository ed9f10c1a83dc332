using System.IO;
using System.Linq;
using OxyPlot;
using OxyPlot.Axes;
using OxyPlot.Legends;
using OxyPlot.Series;

namespace CreatureGen.Benchmarks.Growth;

/// <summary>Draws a plot.</summary>
internal static class PlotFile
{
    private const double Width = 620;
    private const double Height = 330;

    /// <summary>Above the title, whose font may be taller than it was measured.</summary>
    private const double TopRoom = 14;

    /// <summary>Room above the greatest cost, as a part of it.</summary>
    private const double Headroom = 0.15;

    /// <summary>Writes a plot as SVG.</summary>
    public static void Save(Plot plot, string path)
    {
        var model = new PlotModel { Title = plot.Title, TitleFontSize = 15, Background = OxyColors.White, Padding = new OxyThickness(8, TopRoom, 8, 8), Culture = System.Globalization.CultureInfo.InvariantCulture };
        if (plot.Series.Count > 1)
        {
            model.Legends.Add(new Legend { LegendPosition = LegendPosition.RightTop, LegendPlacement = LegendPlacement.Outside, LegendFontSize = 11 });
        }

        model.Axes.Add(plot.Scale == PlotScale.Logarithmic ? new LogarithmicAxis { Position = AxisPosition.Bottom, Title = plot.Across } : new LinearAxis { Position = AxisPosition.Bottom, Title = plot.Across });
        double greatest = plot.Series.SelectMany(series => series.Points).Max(point => point.Cost);
        model.Axes.Add(new LinearAxis { Position = AxisPosition.Left, Title = plot.Up, Minimum = 0, Maximum = greatest * (1 + Headroom), MajorGridlineStyle = LineStyle.Solid, MajorGridlineColor = OxyColors.LightGray });
        foreach (PlotSeries series in plot.Series)
        {
            model.Series.Add(plot.Scale == PlotScale.Scatter ? Points(series) : Line(series));
        }

        using FileStream file = File.Create(path);
        new SvgExporter { Width = Width, Height = Height }.Export(model, file);
    }

    private static ScatterSeries Points(PlotSeries series)
    {
        var drawn = new ScatterSeries { Title = series.Name, MarkerType = MarkerType.Circle, MarkerSize = 3 };
        drawn.Points.AddRange(series.Points.Select(point => new ScatterPoint(point.Of, point.Cost)));
        return drawn;
    }

    private static LineSeries Line(PlotSeries series)
    {
        var drawn = new LineSeries { Title = series.Name, MarkerType = MarkerType.Circle, MarkerSize = 3 };
        drawn.Points.AddRange(series.Points.Select(point => new DataPoint(point.Of, point.Cost)));
        return drawn;
    }
}
