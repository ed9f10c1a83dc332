using System;
using System.Collections.Generic;
using CreatureGen.Events;
using CreatureGen.Motion.Toolkit;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Console.Working;

/// <summary>Draws how joints turn over a clip, with the moments that a rule found: a row for each joint, its angular acceleration, or the speed of its sweep, as columns, moments as red lines.</summary>
internal static class EventPlot
{
    private const int Width = 900;
    private const int RowHeight = 90;
    private const int Left = 170;
    private const int Top = 24;

    private static readonly Pixel paper = new(250, 249, 245, 255);
    private static readonly Pixel ink = new(60, 66, 80, 255);
    private static readonly Pixel column = new(120, 150, 190, 255);
    private static readonly Pixel other = new(222, 226, 232, 255);
    private static readonly Pixel mark = new(214, 60, 50, 255);

    /// <summary>Draws some clips, one under the other.</summary>
    public static Picture Draw(IReadOnlyList<(IClip Clip, AngularFinding Finding)> clips)
    {
        int rows = 0;
        foreach ((IClip _, AngularFinding finding) in clips)
        {
            rows += finding.Curves.Count;
        }

        var picture = new Picture(Width, Math.Min(Math.Max(1, (rows * RowHeight) + (clips.Count * Top)), Picture.LargestSide), PixelLayout.Rgb);
        picture.Fill(paper);
        int y = 0;
        foreach ((IClip clip, AngularFinding finding) in clips)
        {
            if (y + Top > picture.Height)
            {
                break;
            }

            Label.Draw(picture, FormattableString.Invariant($"{clip.Name}: {clip.Duration:0.00} s, {finding.Events.Count} events"), 8, y + 6, LabelSize.Small, ink);
            y += Top;
            foreach (AngularCurve curve in finding.Curves)
            {
                if (y + RowHeight <= picture.Height)
                {
                    Row(picture, clip, curve, finding.Events, y);
                }

                y += RowHeight;
            }
        }

        return picture;
    }

    private static void Row(Picture picture, IClip clip, AngularCurve curve, IReadOnlyList<ClipEvent> events, int y)
    {
        Label.Draw(picture, Label.Fit(curve.Joint, LabelSize.Small, Left - 16), 8, y + (RowHeight / 2), LabelSize.Small, ink);
        float greatest = 1e-6f;
        foreach (float a in curve.Signal)
        {
            greatest = Math.Max(greatest, Math.Abs(a));
        }

        int across = Width - Left - 8;
        int count = curve.Signal.Length;
        for (int i = 0; i < count; i++)
        {
            float a = curve.Signal[i];
            int height = Math.Max(1, (int)(Math.Abs(a) / greatest * (RowHeight - 10)));
            int from = Left + (i * across / count);
            picture.Fill(a > 0f ? column : other, from, y + RowHeight - height, Math.Max(1, (Left + ((i + 1) * across / count)) - from - 1), height);
        }

        foreach (ClipEvent one in events)
        {
            if (one.Joint == curve.Joint)
            {
                picture.Fill(mark, Left + Math.Min(across - 1, (int)(one.Time / clip.Duration * across)), y + 4, 2, RowHeight - 4);
            }
        }

        picture.Fill(ink, Left, y + RowHeight - 1, across, 1);
    }
}
