using System;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>A place on the ground, in a camera's axes.</summary>
/// <param name="Point">Metres.</param>
/// <param name="Stands">Whether the foot stands there, or swings above it.</param>
internal readonly record struct ContactMark(Vector3 Point, bool Stands)
{
    /// <summary>The marks of feet.</summary>
    /// <param name="feet">How they are.</param>
    /// <param name="joints">Where all joints are, world space.</param>
    /// <param name="below">The ground below a place; none where there is none.</param>
    /// <param name="camera">Where the camera is.</param>
    public static ContactMark[] Of(FootReport[] feet, Vector3[] joints, Func<Vector3, Vector3?> below, RootPlace camera) => Array.ConvertAll(feet, foot =>
    {
        bool stands = foot.Phase == FootPhase.Stance;
        return new ContactMark(camera.ToModel(stands ? foot.Place : below(joints[foot.Joint]) ?? joints[foot.Joint]), stands);
    });
}

/// <summary>Marks on the ground of a picture: filled where a foot stands, an empty ring below one that swings.</summary>
internal static class ContactMarks
{
    private const float Flatness = 0.42f;

    // Radius of a mark, part of the leg's length, and at least, pixels.
    private const float LegFraction = 0.1f;
    private const float MinRadius = 3f;

    private static readonly Pixel outline = new(20, 22, 26);

    /// <summary>Draws the marks of all feet.</summary>
    public static void Draw(Picture picture, LeggedBody? body, ReadOnlySpan<ContactMark> marks, Camera camera)
    {
        for (int foot = 0; foot < marks.Length && body != null; foot++)
        {
            Vector3 point = marks[foot].Point;
            Vector3 pixel = camera.Project(point, picture.Width, picture.Height);
            float radius = camera.Project(point + (camera.Right * (LegFraction * body.Legs[foot].Length)), picture.Width, picture.Height).X - pixel.X;
            Ellipse(picture, pixel.X, pixel.Y, Math.Clamp(radius, MinRadius, Math.Max(MinRadius, picture.Width / 28f)), FootName.Colour(body, foot), marks[foot].Stands ? 235 : 0);
        }
    }

    private static void Ellipse(Picture picture, float x, float y, float radius, Pixel colour, int fill)
    {
        int reach = (int)radius + 2;
        for (int row = -reach; row <= reach; row++)
        {
            for (int column = -reach; column <= reach; column++)
            {
                int px = (int)x + column;
                int py = (int)y + row;
                float dx = (px + 0.5f - x) / radius;
                float dy = (py + 0.5f - y) / (radius * Flatness);
                float distance = (float)Math.Sqrt((dx * dx) + (dy * dy));
                bool rim = distance is > 0.72f and <= 1.08f;
                if (rim)
                {
                    picture.Blend(px, py, fill > 0 ? outline : colour, fill > 0 ? 220 : 190);
                }
                else if (distance <= 0.72f)
                {
                    picture.Blend(px, py, colour, fill);
                }
            }
        }
    }
}
