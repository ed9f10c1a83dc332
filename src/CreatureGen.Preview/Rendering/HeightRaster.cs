using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Preview.Rendering;

/// <summary>A square grid of texels laid across a direction, with the lowest and highest point of a mesh along that direction at each.</summary>
internal sealed class HeightRaster
{
    private readonly Vector3 originOnGrid;

    /// <summary>Draws all triangles of a mesh, both sides.</summary>
    /// <param name="mesh">What to draw.</param>
    /// <param name="direction">Unit direction along which heights are measured.</param>
    /// <param name="size">Texels in a row and rows.</param>
    /// <param name="border">Part of the grid left free at each edge.</param>
    public HeightRaster(RenderMesh mesh, Vector3 direction, int size, float border)
    {
        Size = size;
        Direction = direction;
        AxisU = Vec.Normalize(Vec.Cross(Math.Abs(direction.Y) > 0.9f ? Vector3.UnitZ : Vector3.UnitY, direction));
        AxisV = Vec.Cross(direction, AxisU);
        Lowest = new float[size * size];
        Highest = new float[size * size];
        Array.Fill(Lowest, float.PositiveInfinity);
        Array.Fill(Highest, float.NegativeInfinity);

        var projected = new Vector3[mesh.Positions.Length];
        for (int i = 0; i < projected.Length; i++)
        {
            Vector3 p = mesh.Positions[i];
            projected[i] = new Vector3(Vec.Dot(p, AxisU), Vec.Dot(p, AxisV), Vec.Dot(p, direction));
        }

        BoundingBox bounds = projected.Length == 0 ? default : BoundingBox.Of(projected);
        float side = Math.Max(bounds.Size.X, bounds.Size.Y) / (1f - (2f * border));
        TexelSize = side > 0f ? side / size : 1f;
        originOnGrid = bounds.Centre - (new Vector3(0.5f, 0.5f, 0f) * (TexelSize * size));
        float scale = 1f / TexelSize;
        for (int i = 0; i < projected.Length; i++)
        {
            projected[i] = new Vector3((projected[i].X - originOnGrid.X) * scale, (projected[i].Y - originOnGrid.Y) * scale, projected[i].Z);
        }

        for (int i = 0; i < mesh.Triangles.Length; i += 3)
        {
            Draw(projected[mesh.Triangles[i]], projected[mesh.Triangles[i + 1]], projected[mesh.Triangles[i + 2]]);
        }
    }

    public int Size { get; }

    /// <summary>Side of a texel, metres.</summary>
    public float TexelSize { get; }

    public Vector3 Direction { get; }

    public Vector3 AxisU { get; }

    public Vector3 AxisV { get; }

    /// <summary>Lowest height at each texel, metres; +∞ where there is nothing.</summary>
    public float[] Lowest { get; }

    /// <summary>Highest height at each texel, metres; −∞ where there is nothing.</summary>
    public float[] Highest { get; }

    /// <summary>Where a point is on the grid, in texels; the middle of texel (0, 0) is at (0.5, 0.5).</summary>
    public void Locate(Vector3 point, out float u, out float v)
    {
        float scale = 1f / TexelSize;
        u = (Vec.Dot(point, AxisU) - originOnGrid.X) * scale;
        v = (Vec.Dot(point, AxisV) - originOnGrid.Y) * scale;
    }

    /// <summary>The point of zero height at a place on the grid.</summary>
    public Vector3 PointAt(float u, float v) => (AxisU * (originOnGrid.X + (u * TexelSize))) + (AxisV * (originOnGrid.Y + (v * TexelSize)));

    // Walks the rows; thin parts must not fall between the middles of texels, so that each row takes at least the texel it passes through.
    private void Draw(Vector3 a, Vector3 b, Vector3 c)
    {
        if (b.Y < a.Y)
        {
            (a, b) = (b, a);
        }

        if (c.Y < a.Y)
        {
            (a, c) = (c, a);
        }

        if (c.Y < b.Y)
        {
            (b, c) = (c, b);
        }

        int first = Math.Max(0, (int)MathF.Ceiling(a.Y - 0.5f));
        int last = Math.Min(Size - 1, (int)MathF.Floor(c.Y - 0.5f));
        float area = ((b.X - a.X) * (c.Y - a.Y)) - ((c.X - a.X) * (b.Y - a.Y));
        if (area == 0f || first > last)
        {
            return;
        }

        float slopeX = (((b.Z - a.Z) * (c.Y - a.Y)) - ((c.Z - a.Z) * (b.Y - a.Y))) / area;
        float min = Math.Min(a.Z, Math.Min(b.Z, c.Z));
        float max = Math.Max(a.Z, Math.Max(b.Z, c.Z));
        for (int y = first; y <= last; y++)
        {
            float at = y + 0.5f;
            float longT = (at - a.Y) / (c.Y - a.Y);
            float longX = a.X + ((c.X - a.X) * longT);
            float longZ = a.Z + ((c.Z - a.Z) * longT);
            float shortX = at < b.Y || b.Y == c.Y
                ? a.X + ((b.X - a.X) * ((at - a.Y) / (b.Y - a.Y)))
                : b.X + ((c.X - b.X) * ((at - b.Y) / (c.Y - b.Y)));
            float from = Math.Min(longX, shortX);
            float to = Math.Max(longX, shortX);
            int x0 = (int)MathF.Floor(from);
            int x1 = Math.Max(x0, (int)MathF.Floor(to - 0.5f));
            x0 = Math.Max(0, x0 + (x1 > x0 && from - x0 > 0.5f ? 1 : 0));
            x1 = Math.Min(Size - 1, x1);
            int row = y * Size;
            for (int x = x0; x <= x1; x++)
            {
                float z = Math.Clamp(longZ + (slopeX * (x + 0.5f - longX)), min, max);
                ref float lowest = ref Lowest[row + x];
                if (z < lowest)
                {
                    lowest = z;
                }

                ref float highest = ref Highest[row + x];
                if (z > highest)
                {
                    highest = z;
                }
            }
        }
    }
}
