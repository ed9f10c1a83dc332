using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Preview.Films;

/// <summary>One cycle from left to right: a bar for each foot, filled while it stands; for what does not go on feet, the way of the tip of a wing or of the tail. A tick for each picture of the strip.</summary>
internal static class CycleDiagram
{
    private const int BarHeight = 13;
    private const int BarGap = 4;
    private const int CurveHeight = 90;
    private const int TickHeight = 8;
    private const int LabelLeft = 6;

    private static readonly Pixel ink = new(24, 27, 32);
    private static readonly Pixel empty = new(214, 216, 220);
    private static readonly Pixel tick = new(120, 124, 132);

    /// <summary>Pixels that it takes.</summary>
    public static int Height(Film film) => (2 * TickHeight) + (film.Take.Feet > 0 ? film.Take.Feet * (BarHeight + BarGap) : CurveHeight);

    /// <summary>Draws it.</summary>
    /// <param name="picture">The strip.</param>
    /// <param name="film">What of.</param>
    /// <param name="left">Where the cycle begins: half a picture before the first.</param>
    /// <param name="top">Where it begins.</param>
    /// <param name="width">Of the cycle.</param>
    public static void Draw(Picture picture, Film film, int left, int top, int width)
    {
        int bottom = top + Height(film);
        for (int i = 0; i < Take.StripFrames; i++)
        {
            int x = left + (((2 * i) + 1) * width / (2 * Take.StripFrames));
            picture.Fill(tick, x, top, 1, bottom - top);
        }

        if (film.Take.Feet > 0 && film.Profile.Legs is LeggedBody body)
        {
            DrawBars(picture, film, body, left, top + TickHeight, width);
        }
        else
        {
            DrawCurve(picture, film, left, top + TickHeight, width);
        }
    }

    /// <summary>The moment at a column: the pictures are in the middle of their eighths. What happens once is before its first picture as it is there.</summary>
    private static int MomentAt(Film film, int column, int width)
    {
        int moments = film.Take.StrokeMoments;
        double moment = ((column + 0.5) / width * moments) - (moments / (2.0 * Take.StripFrames));
        return film.Movement.IsCyclic ? (int)Math.Floor(moment + moments) % moments : Math.Max(0, (int)Math.Floor(moment));
    }

    private static void DrawBars(Picture picture, Film film, LeggedBody body, int left, int top, int width)
    {
        int[] feet = Enumerable.Range(0, film.Take.Feet).OrderByDescending(foot => body.Legs[foot].Row).ThenBy(foot => body.Legs[foot].Side == Side.Right).ToArray();
        for (int row = 0; row < feet.Length; row++)
        {
            int y = top + (row * (BarHeight + BarGap));
            Pixel colour = FootName.Colour(body, feet[row]);
            Label.Draw(picture, FootName.Of(body, feet[row]), LabelLeft, y + 3, LabelSize.Small, ink);
            for (int x = 0; x < width; x++)
            {
                bool stands = film.Take.FootAt(MomentAt(film, x, width), feet[row]).Phase == FootPhase.Stance;
                picture.Fill(stands ? colour : empty, left + x, y, 1, BarHeight);
            }

            for (int i = 0; i < Take.StripFrames; i++)
            {
                picture.Fill(ink, left + (((2 * i) + 1) * width / (2 * Take.StripFrames)), y, 1, BarHeight);
            }
        }
    }

    private static void DrawCurve(Picture picture, Film film, int left, int top, int width)
    {
        (string name, float[] values, bool up) = Stroke(film);
        float min = values.Min();
        float range = Math.Max(values.Max() - min, 1e-6f);
        Label.Draw(picture, name, LabelLeft, top, LabelSize.Small, ink);
        Label.Draw(picture, up ? "up" : "left", LabelLeft, top + Label.LineHeight(LabelSize.Small), LabelSize.Small, ink);
        Label.Draw(picture, FormattableString.Invariant($"{range:0.00} m"), LabelLeft, top + (2 * Label.LineHeight(LabelSize.Small)), LabelSize.Small, ink);
        int before = -1;
        for (int x = 0; x < width; x++)
        {
            int y = top + (int)((1f - ((values[MomentAt(film, x, width)] - min) / range)) * (CurveHeight - (2 * TickHeight)));
            int from = before < 0 ? y : Math.Min(y, before);
            int to = before < 0 ? y : Math.Max(y, before);
            picture.Fill(new Pixel(38, 112, 201), left + x, from, 1, to - from + 2);
            before = y;
        }
    }

    /// <summary>The way, up or to the left, of what moves most: the end of a left wing in the air, of the tail or of a left fin else.</summary>
    private static (string Name, float[] Values, bool Up) Stroke(Film film)
    {
        Vector3[][] moments = Enumerable.Range(0, film.Take.StrokeMoments).Select(film.Take.JointsAt).ToArray();
        (string Name, float[] Values, bool Up) max = ("", new float[moments.Length], true);
        foreach ((string name, int tip) in Tips(film))
        {
            foreach (bool up in new[] { true, false })
            {
                float[] values = Array.ConvertAll(moments, joints => up ? joints[tip].Y : joints[tip].X);
                if (values.Max() - values.Min() > max.Values.Max() - max.Values.Min())
                {
                    max = (name, values, up);
                }
            }
        }

        return max;
    }

    private static IEnumerable<(string Name, int Joint)> Tips(Film film)
    {
        bool flies = film.Movement.Input.Medium == MotionMedium.Air;
        foreach (LimbChain limb in film.Profile.Subject.Limbs.Where(limb => limb.Side == Side.Left))
        {
            if (flies && limb.Kind is LimbKind.Wing or LimbKind.InsectWing)
            {
                yield return ("wing tip", limb.Joints[^1]);
            }
            else if (!flies && limb.Kind == LimbKind.Pectoral)
            {
                yield return ("fin tip", limb.Joints[^1]);
            }
        }

        if (!flies)
        {
            Skeleton skeleton = film.Profile.Subject.Skeleton;
            yield return ("tail tip", Enumerable.Range(0, skeleton.Count).Where(joint => skeleton.Joints[joint].Side == Side.Median).MinBy(joint => skeleton.ModelPositions[joint].Z));
        }
    }
}
