using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>Projects the triangles of a mesh into a picture: drops those not seen, cuts those that reach behind the camera or far out of the frame.</summary>
/// <remarks>
/// Depth and weights are linear over the picture when divided by depth; their planes are the rows of the inverse of the matrix of the projected
/// corners, which exists even when a corner is behind the camera (Olano and Greer 1997, "Triangle scan conversion using 2D homogeneous coordinates").
/// </remarks>
internal static class ScreenProjection
{
    public const int SubPixel = 256;

    // Pixels beyond the frame to which triangles may reach uncut; keeps edge functions exact in 64 bits.
    private const double Guard = 8192;

    /// <summary>The triangles that may be seen, in the order of the mesh.</summary>
    public static ScreenTriangle[] Project(RenderMesh mesh, Camera camera, int width, int height)
    {
        ReadOnlySpan<Vector3> positions = mesh.Positions;
        var corners = new Corner[positions.Length];
        double scale = camera.PixelsPerTangent(height);
        for (int i = 0; i < corners.Length; i++)
        {
            Vector3 q = positions[i] - camera.Eye;
            double z = Vec.Dot(q, camera.Forward);
            corners[i] = new Corner(
                (Vec.Dot(q, camera.Right) * scale) + (z * width * 0.5),
                (z * height * 0.5) - (Vec.Dot(q, camera.Up) * scale),
                z);
        }

        var result = new List<ScreenTriangle>(mesh.Triangles.Length / 5);
        Span<Corner> polygon = stackalloc Corner[16];
        Span<Corner> scratch = stackalloc Corner[16];
        Span<Corner> planes = stackalloc Corner[5];
        planes[0] = new Corner(0, 0, 1);
        planes[1] = new Corner(1, 0, Guard);
        planes[2] = new Corner(-1, 0, width + Guard);
        planes[3] = new Corner(0, 1, Guard);
        planes[4] = new Corner(0, -1, height + Guard);
        for (int part = 0; part < mesh.Parts.Count; part++)
        {
            RenderPart source = mesh.Parts[part];
            for (int i = source.FirstIndex; i < source.FirstIndex + source.IndexCount; i += 3)
            {
                polygon[0] = corners[mesh.Triangles[i]];
                polygon[1] = corners[mesh.Triangles[i + 1]];
                polygon[2] = corners[mesh.Triangles[i + 2]];
                var triangle = new ScreenTriangle { Source = i, Part = part };
                if (!Face(polygon, source.Material.Facing, ref triangle))
                {
                    continue;
                }

                Corner a = polygon[0];
                Corner b = polygon[1];
                Corner c = polygon[2];
                int count = 3;
                for (int plane = 0; plane < planes.Length && count > 0; plane++)
                {
                    double offset = plane == 0 ? camera.Near : 0;
                    if (NeedsCut(polygon[..count], planes[plane], offset))
                    {
                        count = Cut(polygon[..count], scratch, planes[plane], offset);
                        scratch[..count].CopyTo(polygon);
                    }
                }

                for (int k = 2; k < count; k++)
                {
                    if (Place(polygon[0], polygon[k - 1], polygon[k], width, height, ref triangle))
                    {
                        SetPlanes(a, b, c, camera.Near, ref triangle);
                        result.Add(triangle);
                    }
                }
            }
        }

        return [.. result];
    }

    // The determinant of the corners has the sign of the side that faces the eye, wherever the corners are.
    private static bool Face(ReadOnlySpan<Corner> p, Facing facing, ref ScreenTriangle triangle)
    {
        double determinant = Determinant(p[0], p[1], p[2]);
        triangle.Side = determinant < 0 ? 1f : -1f;
        return determinant != 0 && (determinant < 0 || facing == Facing.Both);
    }

    private static double Determinant(Corner a, Corner b, Corner c) =>
        (a.X * ((b.Y * c.Z) - (b.Z * c.Y))) + (a.Y * ((b.Z * c.X) - (b.X * c.Z))) + (a.Z * ((b.X * c.Y) - (b.Y * c.X)));

    private static bool NeedsCut(ReadOnlySpan<Corner> polygon, Corner plane, double offset)
    {
        foreach (Corner corner in polygon)
        {
            if (corner.Over(plane) < offset)
            {
                return true;
            }
        }

        return false;
    }

    // Sutherland and Hodgman (1974).
    private static int Cut(ReadOnlySpan<Corner> polygon, Span<Corner> result, Corner plane, double offset)
    {
        int count = 0;
        for (int i = 0; i < polygon.Length; i++)
        {
            Corner a = polygon[i];
            Corner b = polygon[(i + 1) % polygon.Length];
            double over = a.Over(plane) - offset;
            double overNext = b.Over(plane) - offset;
            if (over >= 0)
            {
                result[count++] = a;
            }

            if ((over >= 0) != (overNext >= 0))
            {
                double t = over / (over - overNext);
                result[count++] = new Corner(a.X + ((b.X - a.X) * t), a.Y + ((b.Y - a.Y) * t), a.Z + ((b.Z - a.Z) * t));
            }
        }

        return count;
    }

    // Snaps the corners to the sub-pixel grid, winds them the same way and finds the pixels they may cover.
    private static bool Place(Corner a, Corner b, Corner c, int width, int height, ref ScreenTriangle t)
    {
        t.X0 = Snap(a.X / a.Z);
        t.Y0 = Snap(a.Y / a.Z);
        t.X1 = Snap(b.X / b.Z);
        t.Y1 = Snap(b.Y / b.Z);
        t.X2 = Snap(c.X / c.Z);
        t.Y2 = Snap(c.Y / c.Z);
        long area = ((long)(t.X1 - t.X0) * (t.Y2 - t.Y0)) - ((long)(t.X2 - t.X0) * (t.Y1 - t.Y0));
        if (area == 0)
        {
            return false;
        }

        if (area < 0)
        {
            (t.X1, t.X2) = (t.X2, t.X1);
            (t.Y1, t.Y2) = (t.Y2, t.Y1);
        }

        t.MinX = Math.Max(0, Math.Min(t.X0, Math.Min(t.X1, t.X2)) >> 8);
        t.MinY = Math.Max(0, Math.Min(t.Y0, Math.Min(t.Y1, t.Y2)) >> 8);
        t.MaxX = Math.Min(width - 1, Math.Max(t.X0, Math.Max(t.X1, t.X2)) >> 8);
        t.MaxY = Math.Min(height - 1, Math.Max(t.Y0, Math.Max(t.Y1, t.Y2)) >> 8);
        return t.MinX <= t.MaxX && t.MinY <= t.MaxY;
    }

    private static int Snap(double pixels) => (int)Math.Floor((pixels * SubPixel) + 0.5);

    private static void SetPlanes(Corner a, Corner b, Corner c, double near, ref ScreenTriangle t)
    {
        // Relative to the first pixel, so that nothing is lost where coordinates are large.
        double anchorX = t.MinX + 0.5;
        double anchorY = t.MinY + 0.5;
        a = a.RelativeTo(anchorX, anchorY);
        b = b.RelativeTo(anchorX, anchorY);
        c = c.RelativeTo(anchorX, anchorY);
        double inverse = 1 / Determinant(a, b, c);
        Corner planeA = Corner.Cross(b, c, inverse);
        Corner planeB = Corner.Cross(c, a, inverse);
        Corner planeC = Corner.Cross(a, b, inverse);
        t.Depth = (float)(planeA.Z + planeB.Z + planeC.Z);
        t.DepthX = (float)(planeA.X + planeB.X + planeC.X);
        t.DepthY = (float)(planeA.Y + planeB.Y + planeC.Y);
        t.B = (float)planeB.Z;
        t.BX = (float)planeB.X;
        t.BY = (float)planeB.Y;
        t.C = (float)planeC.Z;
        t.CX = (float)planeC.X;
        t.CY = (float)planeC.Y;
        double nearest = Math.Max(near, Math.Min(a.Z, Math.Min(b.Z, c.Z)));
        double farthest = Math.Max(near, Math.Max(a.Z, Math.Max(b.Z, c.Z)));
        t.DepthMax = (float)(1 / nearest);
        t.DepthMin = (float)(1 / farthest);
    }

    /// <summary>A corner in homogeneous pixels: (x·depth, y·depth, depth).</summary>
    private readonly struct Corner(double x, double y, double z)
    {
        public readonly double X = x;
        public readonly double Y = y;
        public readonly double Z = z;

        public static Corner Cross(Corner a, Corner b, double scale) => new(
            ((a.Y * b.Z) - (a.Z * b.Y)) * scale,
            ((a.Z * b.X) - (a.X * b.Z)) * scale,
            ((a.X * b.Y) - (a.Y * b.X)) * scale);

        public double Over(Corner plane) => (X * plane.X) + (Y * plane.Y) + (Z * plane.Z);

        public Corner RelativeTo(double x, double y) => new(X - (x * Z), Y - (y * Z), Z);
    }
}
