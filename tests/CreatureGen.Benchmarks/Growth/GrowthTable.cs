using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Benchmarks.Beside;

namespace CreatureGen.Benchmarks.Growth;

/// <summary>How costs grow, as plots and as numbers.</summary>
internal static class GrowthTable
{
    /// <summary>Measures, draws, prints and puts it into the document.</summary>
    public static void Make(TextWriter output)
    {
        var lines = new List<string>();
        Directory.CreateDirectory(Path.Combine(ProbeBuild.Root, SpeedDocument.Plots));
        foreach (Plot plot in FrameGrowth.Plots().Concat(MakingGrowth.Plots()))
        {
            string file = plot.Title.ToLowerInvariant().Replace(",", "", StringComparison.Ordinal).Replace(' ', '-') + ".svg";
            PlotFile.Save(plot, Path.Combine(ProbeBuild.Root, SpeedDocument.Plots, file));
            lines.Add($"![{plot.Title}]({Path.GetFileName(SpeedDocument.Plots)}/{file})");
            lines.Add("");
            if (plot.Scale != PlotScale.Scatter)
            {
                lines.AddRange(plot.Series.Select(series => $"- {series.Name}, {plot.Up}: {string.Join(", ", series.Points.Select(Text))}"));
                lines.Add("");
            }
        }

        SpeedDocument.Put("plots", lines, output);
    }

    private static string Text((double Of, double Cost) point) =>
        string.Create(CultureInfo.InvariantCulture, $"{(point.Cost >= 100 ? point.Cost.ToString("#,0", CultureInfo.InvariantCulture) : point.Cost.ToString("G3", CultureInfo.InvariantCulture))} at {point.Of:#,0}");
}
