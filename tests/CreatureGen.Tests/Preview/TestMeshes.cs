using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Tests.Preview;

/// <summary>Hand-made surfaces, and pictures of nothing but them.</summary>
internal static class TestMeshes
{
    /// <summary>One sample per pixel, colours as they are, no backdrop, no floor.</summary>
    public static RenderOptions Plain { get; } = new()
    {
        Width = 64,
        Height = 64,
        Samples = SampleCount.One,
        Shading = ShadingMode.Unlit,
        Backdrop = BackdropKind.Transparent,
        Ground = GroundKind.None,
    };

    /// <summary>A square across the z axis with given half sides, facing +Z.</summary>
    public static RenderMesh Square(float half, float z, Vector3 colour, Facing facing = Facing.Front) =>
        Soup([new(-half, -half, z), new(half, -half, z), new(half, half, z), new(-half, -half, z), new(half, half, z), new(-half, half, z)], _ => colour, facing);

    /// <summary>Triangles that share no corner, each with its flat normal.</summary>
    public static RenderMesh Soup(Vector3[] corners, Func<int, Vector3> colourOfCorner, Facing facing = Facing.Front)
    {
        var normals = new Vector3[corners.Length];
        for (int i = 0; i < corners.Length; i++)
        {
            int first = i / 3 * 3;
            normals[i] = Vec.Normalize(Vec.Cross(corners[first + 1] - corners[first], corners[first + 2] - corners[first]), Vector3.UnitY);
        }

        return new RenderMesh(
            corners,
            normals,
            Enumerable.Range(0, corners.Length).Select(colourOfCorner).ToArray(),
            Enumerable.Range(0, corners.Length).ToArray(),
            [new RenderPart(new SurfaceMaterial(facing, 0.2f, 0f), 0, corners.Length)]);
    }

    /// <summary>Several surfaces as one, in their order.</summary>
    public static RenderMesh Together(params RenderMesh[] meshes)
    {
        var positions = new List<Vector3>();
        var normals = new List<Vector3>();
        var colours = new List<Vector3>();
        var triangles = new List<int>();
        var parts = new List<RenderPart>();
        foreach (RenderMesh mesh in meshes)
        {
            int first = positions.Count;
            foreach (RenderPart part in mesh.Parts)
            {
                parts.Add(part with { FirstIndex = triangles.Count + part.FirstIndex });
            }

            positions.AddRange(mesh.Positions.ToArray());
            normals.AddRange(mesh.Normals.ToArray());
            colours.AddRange(mesh.Colours.ToArray());
            triangles.AddRange(mesh.Triangles.ToArray().Select(i => i + first));
        }

        return new RenderMesh([.. positions], [.. normals], [.. colours], [.. triangles], parts);
    }

    /// <summary>The surface on the other side of the plane x = 0.</summary>
    public static RenderMesh Mirrored(RenderMesh mesh)
    {
        int[] triangles = mesh.Triangles.ToArray();
        for (int i = 0; i < triangles.Length; i += 3)
        {
            (triangles[i + 1], triangles[i + 2]) = (triangles[i + 2], triangles[i + 1]);
        }

        return new RenderMesh(
            mesh.Positions.ToArray().Select(Vec.Mirror).ToArray(),
            mesh.Normals.ToArray().Select(Vec.Mirror).ToArray(),
            mesh.Colours.ToArray(),
            triangles,
            mesh.Parts,
            mesh.Gloss.Length == 0 ? null : mesh.Gloss.ToArray());
    }

    /// <summary>The surface, larger or smaller about the origin.</summary>
    public static RenderMesh Scaled(RenderMesh mesh, float scale) => new(
        mesh.Positions.ToArray().Select(p => p * scale).ToArray(),
        mesh.Normals.ToArray(),
        mesh.Colours.ToArray(),
        mesh.Triangles.ToArray(),
        mesh.Parts,
        mesh.Gloss.Length == 0 ? null : mesh.Gloss.ToArray());

    /// <summary>The byte of linear light by the definition of sRGB (IEC 61966-2-1).</summary>
    public static byte Srgb(double linear)
    {
        double x = Math.Clamp(linear, 0, 1);
        return (byte)Math.Round(255 * (x <= 0.0031308 ? 12.92 * x : (1.055 * Math.Pow(x, 1 / 2.4)) - 0.055));
    }

    /// <summary>The pixel of linear light.</summary>
    public static Pixel Srgb(Vector3 linear) => new(Srgb(linear.X), Srgb(linear.Y), Srgb(linear.Z));

    /// <summary>The largest difference of any channel of two pictures.</summary>
    public static int LargestDifference(Picture a, Picture b)
    {
        int largest = 0;
        for (int i = 0; i < a.Bytes.Length; i++)
        {
            largest = Math.Max(largest, Math.Abs(a.Bytes[i] - b.Bytes[i]));
        }

        return largest;
    }
}
