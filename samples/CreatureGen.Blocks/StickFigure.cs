using System;
using System.Numerics;
using CreatureGen.Preview.Pictures;
using CreatureGen.Rigging;

namespace CreatureGen.Blocks;

/// <summary>Draws the bones of skeletons as lines, frame beside frame.</summary>
internal sealed class StickFigure(int frames, int side, Func<Vector3, Vector2> project)
{
    private static readonly Pixel bone = new(52, 62, 84);
    private static readonly Pixel joint = new(214, 92, 56);

    /// <summary>The picture so far.</summary>
    public Picture Picture { get; } = Paper(frames * side, side);

    /// <summary>Room for a pose of a skeleton.</summary>
    public static Pose Room(Skeleton skeleton) => new(new Quaternion[skeleton.Count], new Vector3[skeleton.Count]);

    /// <summary>Draws a pose into a frame.</summary>
    public void Draw(int frame, Skeleton skeleton, ReadOnlySpan<Vector3> modelPositions)
    {
        for (int i = 1; i < skeleton.Count; i++)
        {
            Line(frame, modelPositions[skeleton.Parents[i]], modelPositions[i], bone, 2);
            Dot(frame, modelPositions[i]);
        }
    }

    /// <summary>Draws the last pose of every so many into the next frame.</summary>
    public void DrawEvery(int updates, int update, Skeleton skeleton, ReadOnlySpan<Vector3> modelPositions)
    {
        if (update % updates == updates - 1)
        {
            Draw(update / updates, skeleton, modelPositions);
        }
    }

    /// <summary>Marks a point of a frame.</summary>
    public void Dot(int frame, Vector3 point) => Line(frame, point, point, joint, 5);

    private static Picture Paper(int width, int height)
    {
        var picture = new Picture(width, height, PixelLayout.Rgb);
        picture.Fill(new Pixel(250, 249, 245));
        return picture;
    }

    private void Line(int frame, Vector3 from, Vector3 to, Pixel colour, int thick)
    {
        Vector2 a = project(from);
        Vector2 b = project(to);
        int steps = 1 + (int)((Math.Abs(b.X - a.X) + Math.Abs(b.Y - a.Y)) * side);
        for (int s = 0; s <= steps; s++)
        {
            Vector2 p = a + ((b - a) * ((float)s / steps));
            int x = (frame * side) + (int)(p.X * side) - (thick / 2);
            int y = (int)((1f - p.Y) * side) - (thick / 2);
            if (x >= frame * side && y >= 0 && x + thick <= (frame + 1) * side && y + thick <= side)
            {
                Picture.Fill(colour, x, y, thick, thick);
            }
        }
    }
}
