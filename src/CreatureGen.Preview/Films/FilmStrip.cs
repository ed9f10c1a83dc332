using System;
using System.Numerics;
using System.Threading;
using CreatureGen.Maths;
using CreatureGen.Motion;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>Lays out a film strip: a title, a row from the side, a row from the front, and the diagram of the cycle below.</summary>
internal static class FilmStrip
{
    private const int CellWidth = 236;
    private const int Margin = 60;
    private const int TitleHeight = 30;
    private const int Gap = 6;
    private const int MinHeight = 110;
    private const int MaxHeight = 300;

    // Room in a cell around what is seen.
    private const float Room = 1.3f;

    private static readonly Pixel paper = new(236, 237, 240);
    private static readonly Pixel ink = new(24, 27, 32);

    public static Picture Draw(Film film, CancellationToken cancellation)
    {
        Vector3 size = film.RoomSize;
        int side = CellHeight(size.Y / size.Z);
        int front = CellHeight(size.Y / size.X);
        int width = Margin + (Take.StripFrames * CellWidth) + Gap;
        var strip = new Picture(width, TitleHeight + side + Gap + front + Gap + CycleDiagram.Height(film) + Gap, PixelLayout.Rgb);
        strip.Fill(paper);
        Label.Draw(strip, Label.Fit(Title(film), LabelSize.Medium, width - (2 * Gap)), Gap, Gap, LabelSize.Medium, ink);
        DrawRow(strip, film, View.Side, TitleHeight, side, cancellation);
        DrawRow(strip, film, View.Front, TitleHeight + side + Gap, front, cancellation);
        CycleDiagram.Draw(strip, film, Margin, TitleHeight + side + Gap + front + Gap, Take.StripFrames * CellWidth);
        return strip;
    }

    private static int CellHeight(float heightByWidth) => (int)Scalar.Clamp(CellWidth * heightByWidth * Room, MinHeight, MaxHeight);

    private static string Title(Film film)
    {
        string ground = !film.Take.OnGround ? "" : film.Options.Ground == GroundRelief.Rough ? ", rough ground" : ", flat ground";
        return FormattableString.Invariant($"{film.Profile.Subject.Seed} {film.Movement.GaitName}  {film.Speed:0.00} m/s  cycle {film.CycleSeconds:0.00} s{ground}");
    }

    private static void DrawRow(Picture strip, Film film, View view, int top, int height, CancellationToken cancellation)
    {
        Camera camera = film.CameraFor(view, CellWidth - Gap, height);
        Label.Draw(strip, Views.Word(view), Gap, top + Gap, LabelSize.Small, ink);
        // Cells do not overlap, so that each may be put onto the strip by whoever drew it.
        Work.Share(Take.StripFrames, film.Options.Threads, i =>
        {
            cancellation.ThrowIfCancellationRequested();
            int moment = i * film.Take.StrokeMoments / Take.StripFrames;
            Picture cell = film.Draw(moment, camera, CellWidth - Gap, height);
            ContactMarks.Draw(cell, film.Profile.Legs, film.Take.MarksAt(moment), camera);
            Label.Draw(cell, FormattableString.Invariant($"{i + 1}"), Gap, Gap, LabelSize.Small, ink);
            strip.Blit(cell, Margin + (i * CellWidth) + (Gap / 2), top);
        });
    }
}
