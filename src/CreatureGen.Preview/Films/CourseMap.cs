using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Preview.Pictures;

namespace CreatureGen.Preview.Films;

/// <summary>A course from above, ahead at the start upwards: the way of the root, a number where each command was given, and a dot wherever a foot came down.</summary>
internal static class CourseMap
{
    private const int Border = 18;

    private static readonly Pixel ink = new(24, 27, 32);
    private static readonly Pixel ground = new(248, 248, 249);
    private static readonly Pixel way = new(38, 112, 201);
    private static readonly Pixel mark = new(190, 40, 30);

    /// <summary>Draws it.</summary>
    public static void Draw(Picture picture, CourseFilm film, int left, int top, int width, int height)
    {
        CourseTake take = film.Take;
        picture.Fill(ground, left, top, width, height);
        Vector3 min = take.PlaceAt(0).Position;
        Vector3 max = min;
        for (int moment = 0; moment < take.Moments; moment++)
        {
            min = Vector3.Min(min, take.PlaceAt(moment).Position);
            max = Vector3.Max(max, take.PlaceAt(moment).Position);
        }

        float room = Math.Max(film.Profile.LegLength, 0.2f);
        Vector3 middle = (min + max) / 2f;
        float scale = Math.Min((width - (2 * Border)) / (max.X - min.X + (2f * room)), (height - (2 * Border)) / (max.Z - min.Z + (2f * room)));

        // The creature's left, +X, is on the left.
        (int X, int Y) Pixel(Vector3 point) => (left + (width / 2) - (int)((point.X - middle.X) * scale), top + (height / 2) - (int)((point.Z - middle.Z) * scale));

        DrawFeet(picture, film, Pixel, left, top, width, height);
        for (int moment = 1; moment < take.Moments; moment++)
        {
            (int x, int y) = Pixel(take.PlaceAt(moment - 1).Position);
            (int nextX, int nextY) = Pixel(take.PlaceAt(moment).Position);
            Strokes.Line(picture, x, y, nextX, nextY, way);
            if (moment == 1 || take.CommandAt(moment) != take.CommandAt(moment - 1))
            {
                picture.Fill(mark, x - 2, y - 2, 5, 5);
                Label.Draw(picture, FormattableString.Invariant($"{take.CommandAt(moment) + 1}"), x + 5, y - 3, LabelSize.Small, mark);
            }
        }

        DrawScale(picture, left + 8, top + height - 10, width, scale);
    }

    private static void DrawFeet(Picture picture, CourseFilm film, Func<Vector3, (int X, int Y)> pixel, int left, int top, int width, int height)
    {
        if (film.Profile.Legs is not LeggedBody body)
        {
            return;
        }

        CourseTake take = film.Take;
        for (int moment = 1; moment < take.Moments; moment++)
        {
            for (int foot = 0; foot < take.Feet; foot++)
            {
                FootReport now = take.FootAt(moment, foot);
                if (now.Phase == FootPhase.Stance && (moment == 1 || take.FootAt(moment - 1, foot).Phase != FootPhase.Stance))
                {
                    // Feet reach beyond the way of the root, but not beyond the map.
                    (int x, int y) = pixel(now.Place);
                    x = Math.Clamp(x, left + 2, left + width - 3);
                    y = Math.Clamp(y, top + 2, top + height - 3);
                    picture.Fill(FootName.Colour(body, foot), x - 1, y - 1, 3, 3);
                }
            }
        }
    }

    /// <summary>A bar of a round length.</summary>
    private static void DrawScale(Picture picture, int left, int bottom, int width, float scale)
    {
        float metres = 0.01f;
        foreach (float next in new[] { 0.02f, 0.05f, 0.1f, 0.2f, 0.5f, 1f, 2f, 5f, 10f, 20f, 50f, 100f, 200f, 500f })
        {
            metres = next * scale < width / 3f ? next : metres;
        }

        picture.Fill(ink, left, bottom, (int)(metres * scale), 2);
        Label.Draw(picture, FormattableString.Invariant($"{metres} m"), left, bottom - 11, LabelSize.Small, ink);
    }
}
