using System;
using System.Collections.Generic;
using System.Threading;
using CreatureGen.Motion;
using CreatureGen.Maths;
using CreatureGen.Motion.Metrics;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>Lays out the strip of a course: a title, rows of pictures from the side and as the film is seen, and below them the course over time and from above.</summary>
internal static class CourseStrip
{
    private const int Columns = 8;
    private const int MaxCells = 40;
    private const int CellWidth = 236;
    private const int TitleHeight = 30;
    private const int Gap = 6;
    private const int MinHeight = 110;
    private const int MaxHeight = 260;

    // Room in a cell around what is seen.
    private const float Room = 1.25f;

    // Seconds after a command at which a picture is taken: close together where something changes.
    private static readonly double[] offsets = [0.1, 0.25, 0.45, 0.75, 1.2, 2, 3.5, 6, 10, 16];

    // Seconds of a phase of an act from which on its middle is shown too.
    private const double LongPhase = 0.5;

    private static readonly Pixel paper = new(236, 237, 240);
    private static readonly Pixel ink = new(24, 27, 32);
    private static readonly Pixel newCommand = new(190, 40, 30);

    public static Picture Draw(CourseFilm film, CancellationToken cancellation)
    {
        IReadOnlyList<int> moments = Moments(film.Take);
        int side = CellHeight(film, CameraTurn.Along);
        (View view, CameraTurn turning) = Second(film.Options);
        int other = CellHeight(film, turning);
        int rows = (moments.Count + Columns - 1) / Columns;
        int blockHeight = side + other + (2 * Gap);
        int width = (Columns * CellWidth) + (2 * Gap);
        int below = TitleHeight + (rows * blockHeight);
        int height = CourseTimeline.Height(film.Take);
        var strip = new Picture(width, below + height + Gap, PixelLayout.Rgb);
        strip.Fill(paper);
        Label.Draw(strip, Label.Fit(Title(film), LabelSize.Medium, width - (2 * Gap)), Gap, Gap, LabelSize.Medium, ink);

        // Cells do not overlap, so that each may be put onto the strip by whoever drew it.
        Work.Share(moments.Count, film.Options.Threads, i =>
        {
            cancellation.ThrowIfCancellationRequested();
            int left = Gap + (i % Columns * CellWidth);
            int top = TitleHeight + (i / Columns * blockHeight);
            strip.Blit(Cell(film, moments, i, View.Side, CameraTurn.Along, side), left, top);
            strip.Blit(Cell(film, moments, i, view, turning, other), left, top + side + Gap);
        });
        int map = Math.Min(width / 3, Math.Max(height, width / 4));
        CourseTimeline.Draw(strip, film, moments, Gap, below, width - map - (3 * Gap));
        CourseMap.Draw(strip, film, width - map - Gap, below, map, height - Gap);
        return strip;
    }

    /// <summary>How the second row is seen: as the film, or from the front left where that is as the first row.</summary>
    private static (View View, CameraTurn Turning) Second(FilmOptions options) =>
        options is { View: View.Side, Camera: CameraTurn.Along } ? (View.ThreeQuarter, CameraTurn.Still) : (options.View, options.Camera);

    private static string Title(CourseFilm film) =>
        FormattableString.Invariant($"{film.Profile.Subject.Seed} {film.Profile.Subject.Plan} {film.Take.Script.Name}, {film.Ground} ground, {film.Take.Script.Seconds:0.0} s").ToLowerInvariant();

    private static int CellHeight(CourseFilm film, CameraTurn turning)
    {
        System.Numerics.Vector3 size = film.RoomSize(turning);
        float across = turning == CameraTurn.Along ? size.Z : Math.Max(size.X, size.Z);
        return (int)Scalar.Clamp(CellWidth * size.Y / across * Room, MinHeight, MaxHeight);
    }

    private static Picture Cell(CourseFilm film, IReadOnlyList<int> moments, int index, View view, CameraTurn turning, int height)
    {
        int moment = moments[index];
        int command = film.Take.CommandAt(moment);
        Picture cell = film.Draw(moment, view, turning, CellWidth - Gap, height);
        bool first = index == 0 || film.Take.CommandAt(moments[index - 1]) != command;
        string text = FormattableString.Invariant($"{moment / (double)CourseTake.Rate:0.0} s{(first ? " " + (command + 1) + ": " + film.Take.Script.Commands[command] : "")}");
        Label.Draw(cell, Label.Fit(text, LabelSize.Small, CellWidth - (3 * Gap)), Gap, Gap, LabelSize.Small, first ? newCommand : ink);
        return cell;
    }

    /// <summary>The moments of the cells: as many of the first after each command as there is room for.</summary>
    private static List<int> Moments(CourseTake take)
    {
        for (int each = offsets.Length; each > 1; each--)
        {
            List<int> moments = Moments(take, each);
            if (moments.Count <= MaxCells)
            {
                return moments;
            }
        }

        List<int> firsts = Moments(take, 1);
        return firsts.Count <= MaxCells ? firsts : firsts.GetRange(0, MaxCells);
    }

    /// <summary>Of an act the ends of its phases, and the middles of long ones.</summary>
    private static void AddPhases(List<int> moments, CourseTake take, in CourseCommand command, double start)
    {
        double limit = command.Seconds;
        double before = 0;
        for (int phase = 0; phase < command.Act!.Act.Phases.Count; phase++)
        {
            double end = command.Act.SecondsTo(phase);
            if (end - before > LongPhase)
            {
                Add(0.5 * (before + end));
            }

            Add(end);
            before = end;
        }

        void Add(double at)
        {
            if (at <= limit)
            {
                moments.Add(Math.Min((int)Math.Round((start + at) * CourseTake.Rate), take.Moments - 1));
            }
        }
    }

    private static List<int> Moments(CourseTake take, int each)
    {
        var moments = new List<int>();
        double start = 0;
        foreach (CourseCommand command in take.Script.Commands)
        {
            if (command.Act != null)
            {
                AddPhases(moments, take, command, start);
            }

            for (int i = 0; command.Act == null && i < each && (i == 0 || offsets[i] <= command.Seconds); i++)
            {
                double at = start + Math.Min(offsets[i], command.Seconds);
                moments.Add(Math.Min((int)Math.Round(at * CourseTake.Rate), take.Moments - 1));
            }

            start += command.Seconds;
        }

        return moments;
    }
}
