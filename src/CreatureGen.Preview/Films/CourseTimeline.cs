using System;
using System.Collections.Generic;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Films;

/// <summary>A course from left to right: its commands, the speed asked (grey) and gone (blue), gaits, and a bar for each foot, filled while it stands. A tick for each picture of the strip.</summary>
internal static class CourseTimeline
{
    private const int CommandHeight = 30;
    private const int CurveHeight = 84;
    private const int GaitHeight = 16;
    private const int BarHeight = 9;
    private const int ManyBarHeight = 4;
    private const int BarGap = 3;
    private const int MinHeight = 260;
    private const int Margin = 54;

    private static readonly Pixel ink = new(24, 27, 32);
    private static readonly Pixel empty = new(214, 216, 220);
    private static readonly Pixel asked = new(150, 154, 162);
    private static readonly Pixel gone = new(38, 112, 201);
    private static readonly Pixel mark = new(190, 40, 30);

    /// <summary>Pixels that it takes.</summary>
    public static int Height(CourseTake take) => Math.Max(MinHeight, CommandHeight + CurveHeight + GaitHeight + (take.Feet * (Bar(take) + BarGap)) + 20);

    /// <summary>Draws it.</summary>
    public static void Draw(Picture picture, CourseFilm film, IReadOnlyList<int> moments, int left, int top, int width)
    {
        CourseTake take = film.Take;
        int from = left + Margin;
        int span = width - Margin;
        int Column(int moment) => from + (int)((long)moment * (span - 1) / Math.Max(take.Moments - 1, 1));

        int bottom = top + Height(take) - 14;
        foreach (int moment in moments)
        {
            picture.Fill(empty, Column(moment), top + CommandHeight, 1, bottom - top - CommandHeight);
        }

        DrawCommands(picture, take, Column, top, bottom);
        DrawSpeed(picture, take, Column, left, top + CommandHeight);
        DrawGaits(picture, take, Column, left, top + CommandHeight + CurveHeight);
        if (film.Profile.Legs is LeggedBody body && take.Feet > 0)
        {
            DrawFeet(picture, take, body, Column, left, top + CommandHeight + CurveHeight + GaitHeight);
        }

        for (int second = 0; second * CourseTake.Rate < take.Moments; second += take.Moments > 20 * CourseTake.Rate ? 5 : 1)
        {
            Label.Draw(picture, FormattableString.Invariant($"{second} s"), Column(second * CourseTake.Rate), bottom + 3, LabelSize.Small, ink);
        }
    }

    private static int Bar(CourseTake take) => take.Feet > 8 ? ManyBarHeight : BarHeight;

    private static void DrawCommands(Picture picture, CourseTake take, Func<int, int> column, int top, int bottom)
    {
        for (int moment = 1; moment < take.Moments; moment++)
        {
            int command = take.CommandAt(moment);
            if (moment > 1 && command == take.CommandAt(moment - 1))
            {
                continue;
            }

            // Two lines, so that short commands do not hide each other's names.
            picture.Fill(mark, column(moment), top + 2, 1, bottom - top - 2);
            Label.Draw(picture, FormattableString.Invariant($"{command + 1} {take.Script.Commands[command]}"), column(moment) + 3, top + 2 + (command % 2 * 13), LabelSize.Small, mark);
        }
    }

    private static void DrawSpeed(Picture picture, CourseTake take, Func<int, int> column, int left, int top)
    {
        float[] wanted = Enumerable.Range(0, take.Moments).Select(moment => take.Script.Commands[take.CommandAt(moment)].Input.Speed).ToArray();
        float[] had = Enumerable.Range(0, take.Moments).Select(take.SpeedAt).ToArray();
        float max = Math.Max(Math.Max(wanted.Max(), had.Max()), 0.01f);
        float min = Math.Min(Math.Min(wanted.Min(), had.Min()), 0f);
        int Row(float speed) => top + 4 + (int)((max - speed) / (max - min) * (CurveHeight - 10));
        Label.Draw(picture, "m/s", left, top + 4, LabelSize.Small, ink);
        Label.Draw(picture, FormattableString.Invariant($"{max:0.0}"), left + 24, top + 4, LabelSize.Small, ink);
        picture.Fill(empty, column(0), Row(0f), column(take.Moments - 1) - column(0), 1);
        for (int moment = 1; moment < take.Moments; moment++)
        {
            Strokes.Line(picture, column(moment - 1), Row(wanted[moment - 1]), column(moment), Row(wanted[moment]), asked);
            Strokes.Line(picture, column(moment - 1), Row(had[moment - 1]), column(moment), Row(had[moment]), gone);
        }
    }

    private static void DrawGaits(Picture picture, CourseTake take, Func<int, int> column, int left, int top)
    {
        Label.Draw(picture, "gait", left, top + 3, LabelSize.Small, ink);
        int free = 0;
        for (int moment = 0; moment < take.Moments; moment++)
        {
            if (moment > 0 && take.GaitAt(moment) == take.GaitAt(moment - 1))
            {
                continue;
            }

            picture.Fill(ink, column(moment), top, 1, GaitHeight - 3);
            string name = take.GaitAt(moment) ?? "none";
            if (column(moment) >= free)
            {
                Label.Draw(picture, name, column(moment) + 3, top + 3, LabelSize.Small, ink);
                free = column(moment) + 6 + Label.Width(name, LabelSize.Small);
            }
        }
    }

    private static void DrawFeet(Picture picture, CourseTake take, LeggedBody body, Func<int, int> column, int left, int top)
    {
        int[] feet = Enumerable.Range(0, take.Feet).OrderByDescending(foot => body.Legs[foot].Row).ThenBy(foot => body.Legs[foot].Side == Side.Right).ToArray();
        for (int row = 0; row < feet.Length; row++)
        {
            int y = top + (row * (Bar(take) + BarGap));
            if (Bar(take) == BarHeight)
            {
                Label.Draw(picture, FootName.Of(body, feet[row]), left, y + 1, LabelSize.Small, ink);
            }

            for (int moment = 1; moment < take.Moments; moment++)
            {
                bool stands = take.FootAt(moment, feet[row]).Phase == FootPhase.Stance;
                picture.Fill(stands ? FootName.Colour(body, feet[row]) : empty, column(moment - 1), y, column(moment) - column(moment - 1), Bar(take));
            }
        }
    }
}
