using System;
using System.Collections.Generic;
using System.Globalization;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Plots;

/// <summary>A line of a <see cref="CurvePlot"/>.</summary>
/// <param name="Name">What stands beside its end; printable ASCII.</param>
/// <param name="Values">A value for each step from 0.</param>
/// <param name="Colour">Its colour.</param>
public sealed record Curve(string Name, IReadOnlyList<double> Values, Pixel Colour);

/// <summary>Draws numbers that change step by step as lines, from 0 at the bottom.</summary>
public static class CurvePlot
{
    private const int Left = 62;
    private const int Right = 96;
    private const int Top = 40;
    private const int Bottom = 34;
    private const int Lines = 5;

    private static readonly Pixel paper = new(250, 249, 245);
    private static readonly Pixel ink = new(60, 66, 80);
    private static readonly Pixel grid = new(226, 226, 222);

    /// <summary>Draws curves.</summary>
    /// <param name="title">Above them.</param>
    /// <param name="steps">What the steps are called.</param>
    /// <param name="curves">At least one, each with at least one value, 0 or more and finite.</param>
    /// <param name="width">Pixels, at least 300.</param>
    /// <param name="height">Pixels, at least 150.</param>
    /// <exception cref="ArgumentException">There is no curve or no value, or a value is none.</exception>
    public static Picture Draw(string title, string steps, IReadOnlyList<Curve> curves, int width, int height)
    {
        ArgumentNullException.ThrowIfNull(curves);
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 300);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 150);
        (int last, double greatest) = Extent(curves);
        double unit = UnitFor(greatest);
        double top = unit * Math.Max(1, Math.Ceiling(greatest / unit));
        var picture = new Picture(width, height, PixelLayout.Rgb);
        picture.Fill(paper);
        Label.Draw(picture, Label.Fit(title, LabelSize.Medium, width - 20), 10, 10, LabelSize.Medium, ink);
        int across = width - Left - Right, down = height - Top - Bottom;
        int Column(int step) => Left + (int)((long)step * across / Math.Max(1, last));
        int Row(double value) => Top + (int)Math.Round((top - value) / top * down);
        for (int i = 0; i * unit <= top * 1.0001; i++)
        {
            string text = (i * unit).ToString("0.####", CultureInfo.InvariantCulture);
            picture.Fill(grid, Left, Row(i * unit), across, 1);
            Label.Draw(picture, text, Left - 8 - Label.Width(text, LabelSize.Small), Row(i * unit) - 3, LabelSize.Small, ink);
        }

        int stride = Math.Max(1, (int)UnitFor(last));
        for (int step = 0; step <= last; step += stride)
        {
            picture.Fill(ink, Column(step), Top + down, 1, 5);
            Label.Draw(picture, step.ToString(CultureInfo.InvariantCulture), Column(step) - 4, Top + down + 9, LabelSize.Small, ink);
        }

        picture.Fill(ink, Left, Top + down, across, 1);
        Label.Draw(picture, steps, Left + across + 10, Top + down + 9, LabelSize.Small, ink);
        int free = int.MinValue;
        foreach (Curve curve in curves)
        {
            for (int step = 1; step < curve.Values.Count; step++)
            {
                Strokes.Line(picture, Column(step - 1), Row(curve.Values[step - 1]), Column(step), Row(curve.Values[step]), curve.Colour);
            }

            int end = curve.Values.Count - 1;
            picture.Fill(curve.Colour, Column(end) - 2, Row(curve.Values[end]) - 2, 6, 6);
            int beside = Math.Max(Row(curve.Values[end]) - 3, free);
            Label.Draw(picture, curve.Name, Column(end) + 8, beside, LabelSize.Small, curve.Colour);
            free = beside + Label.LineHeight(LabelSize.Small);
        }

        return picture;
    }

    private static (int Last, double Greatest) Extent(IReadOnlyList<Curve> curves)
    {
        int last = -1;
        double greatest = 0;
        foreach (Curve curve in curves)
        {
            last = Math.Max(last, curve.Values.Count - 1);
            foreach (double value in curve.Values)
            {
                greatest = value >= 0 && double.IsFinite(value) ? Math.Max(greatest, value) : throw new ArgumentException(FormattableString.Invariant($"{curve.Name} has the value {value}; expected 0 or more, finite"), nameof(curves));
            }
        }

        return last >= 0 ? (last, greatest) : throw new ArgumentException("there is no value; expected at least one", nameof(curves));
    }

    /// <summary>A round number of which about five make up a length.</summary>
    private static double UnitFor(double length)
    {
        if (!(length > 0))
        {
            return 1;
        }

        double rough = length / Lines;
        double ten = Math.Pow(10, Math.Floor(Math.Log10(rough)));
        return ten * ((rough / ten) switch
        {
            <= 1 => 1,
            <= 2 => 2,
            <= 5 => 5,
            _ => 10,
        });
    }
}
