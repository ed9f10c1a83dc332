using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Motion.Metrics.Courses;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>A piece of ground in checks that stay where they are in the world, so that a foot that slides is seen to.</summary>
internal sealed class CheckedFloor : IFloor
{
    // Part of a patch by which its corners are within it.
    private const float Inset = 1e-3f;

    // How dark the faces of steps are beside floors.
    private const float StepShade = 0.75f;

    private readonly CourseSurface surface;
    private readonly float check;
    private readonly float patch;
    private readonly float halfWidth;
    private readonly float rear;
    private readonly float front;

    /// <summary>A floor around a camera.</summary>
    /// <param name="surface">Its heights, in the frame in which it is whenever it is asked.</param>
    /// <param name="check">Side of a check, metres.</param>
    /// <param name="patches">Flat pieces along a side of a check.</param>
    /// <param name="halfWidth">To the left and right of the camera's way, metres.</param>
    /// <param name="rear">Its edge behind the camera, metres along +Z, negative.</param>
    /// <param name="front">Its edge ahead.</param>
    public CheckedFloor(CourseSurface surface, float check, int patches, float halfWidth, float rear, float front)
    {
        this.surface = surface;
        this.check = check;
        patch = check / patches;
        this.halfWidth = halfWidth;
        this.rear = rear;
        this.front = front;
    }

    /// <inheritdoc/>
    public RenderMesh At(in RootPlace camera, in RootPlace frame)
    {
        Vector3 middle = frame.ToModel(camera.Position);
        float[] xs = Edges(middle.X - halfWidth, middle.X + halfWidth);
        float[] zs = Edges(middle.Z + rear, middle.Z + front);
        var floor = new FloorMesh(camera, frame);
        var before = new Vector3?[]?[xs.Length];
        for (int k = 0; k + 1 < zs.Length; k++)
        {
            Vector3?[]? left = null;
            for (int i = 0; i + 1 < xs.Length; i++)
            {
                // Corners a hair within the patch, so that those beside a step are on their own side of it.
                float x = Inset * (xs[i + 1] - xs[i]);
                float z = Inset * (zs[k + 1] - zs[k]);
                Vector3?[] corners = [At(xs[i] + x, zs[k] + z), At(xs[i] + x, zs[k + 1] - z), At(xs[i + 1] - x, zs[k + 1] - z), At(xs[i + 1] - x, zs[k] + z)];
                double column = Math.Floor(0.5 * (xs[i] + xs[i + 1]) / check);
                double row = Math.Floor(0.5 * (zs[k] + zs[k + 1]) / check);
                Vector3 colour = FloorMesh.Check((long)column + (long)row);
                floor.Add(corners[0], corners[1], corners[2], corners[3], colour);
                if (before[i] is { } behind)
                {
                    floor.Add(behind[1], corners[0], corners[3], behind[2], colour * StepShade);
                }

                if (left != null)
                {
                    floor.Add(left[3], left[2], corners[1], corners[0], colour * StepShade);
                }

                before[i] = corners;
                left = corners;
            }
        }

        return floor.ToMesh();
    }

    /// <summary>The ground at a place of the frame in which it is at present; null where there is none.</summary>
    private Vector3? At(float x, float z)
    {
        RootPlace now = surface.Frame;
        return surface.Below(now.ToWorld(new Vector3(x, 0f, z))) is Vector3 place ? now.ToModel(place) : null;
    }

    /// <summary>Edges of patches from one end to the other, those of checks among them.</summary>
    private float[] Edges(float from, float to)
    {
        var edges = new List<float> { from };
        for (long i = (long)Math.Floor(from / patch) + 1; i * patch < to; i++)
        {
            float edge = i * patch;
            if (edge > edges[^1] + (1e-3f * patch) && edge < to - (1e-3f * patch))
            {
                edges.Add(edge);
            }
        }

        edges.Add(to);
        return [.. edges];
    }
}
