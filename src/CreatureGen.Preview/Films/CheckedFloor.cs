using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Motion;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Films;

/// <summary>A piece of ground in checks that stay where they are in the world, so that a foot that slides is seen to.</summary>
internal sealed class CheckedFloor
{
    private static readonly Vector3 light = new(0.60f, 0.58f, 0.54f);
    private static readonly Vector3 dark = new(0.30f, 0.30f, 0.31f);

    private readonly IGround ground;
    private readonly float check;
    private readonly float patch;
    private readonly float halfWidth;
    private readonly float rear;
    private readonly float front;

    /// <summary>A floor around a camera.</summary>
    /// <param name="ground">Its heights.</param>
    /// <param name="check">Side of a check, metres.</param>
    /// <param name="patches">Flat pieces along a side of a check.</param>
    /// <param name="halfWidth">To the left and right of the camera's way, metres.</param>
    /// <param name="rear">Its edge behind the camera, metres along +Z, negative.</param>
    /// <param name="front">Its edge ahead.</param>
    public CheckedFloor(IGround ground, float check, int patches, float halfWidth, float rear, float front)
    {
        this.ground = ground;
        this.check = check;
        patch = check / patches;
        this.halfWidth = halfWidth;
        this.rear = rear;
        this.front = front;
    }

    /// <summary>The floor as a camera sees it.</summary>
    /// <param name="camera">Where that is, world space.</param>
    public RenderMesh At(Vector3 camera)
    {
        float[] xs = Edges(camera.X - halfWidth, camera.X + halfWidth);
        float[] zs = Edges(camera.Z + rear, camera.Z + front);
        var positions = new List<Vector3>();
        var normals = new List<Vector3>();
        var colours = new List<Vector3>();
        var triangles = new List<int>();
        for (int k = 0; k + 1 < zs.Length; k++)
        {
            for (int i = 0; i + 1 < xs.Length; i++)
            {
                double column = Math.Floor(0.5 * (xs[i] + xs[i + 1]) / check);
                double row = Math.Floor(0.5 * (zs[k] + zs[k + 1]) / check);
                Vector3 colour = (((long)column + (long)row) & 1) == 0 ? light : dark;
                int first = positions.Count;
                foreach ((float x, float z) in new[] { (xs[i], zs[k]), (xs[i], zs[k + 1]), (xs[i + 1], zs[k + 1]), (xs[i + 1], zs[k]) })
                {
                    // From above the highest hill.
                    Vector3 from = new(x, 1e3f, z);
                    bool found = ground.Cast(from, -Vector3.UnitY, 2e3f, out GroundHit hit);
                    positions.Add((found ? hit.Point : new Vector3(x, 0f, z)) - camera);
                    normals.Add(found ? hit.Normal : Vector3.UnitY);
                    colours.Add(colour);
                }

                triangles.AddRange([first, first + 1, first + 2, first, first + 2, first + 3]);
            }
        }

        return new RenderMesh([.. positions], [.. normals], [.. colours], [.. triangles], [new RenderPart(new SurfaceMaterial(Facing.Front, 0f, 0f), 0, triangles.Count)]);
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
