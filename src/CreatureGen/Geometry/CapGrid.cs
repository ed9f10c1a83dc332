using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Geometry;

/// <summary>
/// Closes a loop of 2 (rows + columns) vertices with a grid of quads instead of a pole.
/// </summary>
/// <remarks>
/// Loop order: from the middle of the first row towards larger columns, down the last column, back along the last row, up the first column.
/// Inner points are the Coons patch of the border (S. A. Coons 1967), pushed out as a flattened dome.
/// </remarks>
internal static class CapGrid
{
    /// <summary>Adds the inner vertices and returns all (rows + 1) × (columns + 1) of them, row by row.</summary>
    public static int[] Vertices(SurfaceBuilder surface, ReadOnlySpan<int> loop, int rows, int columns, Vector3 outward, float bulge, in VertexAddress address)
    {
        int count = loop.Length;
        if (count != 2 * (rows + columns) || columns % 2 != 0)
        {
            throw new ArgumentException(FormattableString.Invariant($"a loop of {count} vertices for {rows} × {columns} cells; expected 2 (rows + columns) and even columns"), nameof(loop));
        }

        int stride = columns + 1;
        int half = columns / 2;
        int[] grid = new int[(rows + 1) * stride];
        for (int c = 0; c <= columns; c++)
        {
            grid[c] = loop[((c - half) + count) % count];
            grid[(rows * stride) + c] = loop[(half + rows + (columns - c)) % count];
        }

        for (int r = 0; r <= rows; r++)
        {
            grid[(r * stride) + columns] = loop[half + r];
            grid[r * stride] = loop[(count - half - r) % count];
        }

        Vector3 P(int r, int c) => surface.Positions[grid[(r * stride) + c]];
        for (int r = 1; r < rows; r++)
        {
            for (int c = 1; c < columns; c++)
            {
                float u = (float)c / columns;
                float v = (float)r / rows;
                Vector3 p = (P(r, 0) * (1 - u)) + (P(r, columns) * u) + (P(0, c) * (1 - v)) + (P(rows, c) * v)
                    - ((P(0, 0) * ((1 - u) * (1 - v))) + (P(0, columns) * (u * (1 - v))) + (P(rows, 0) * ((1 - u) * v)) + (P(rows, columns) * (u * v)));
                float a = (2 * u) - 1;
                float b = (2 * v) - 1;
                p += outward * (bulge * (float)Math.Sqrt((1 - (a * a)) * (1 - (b * b))));
                grid[(r * stride) + c] = surface.Add(p, address);
            }
        }

        return grid;
    }

    /// <summary>Lays the inner vertices of a long narrow grid on straight lines across it: right for an end that is thin and wavy.</summary>
    public static void Rule(SurfaceBuilder surface, int[] grid, int rows, int columns)
    {
        int stride = columns + 1;
        for (int r = 1; r < rows; r++)
        {
            for (int c = 1; c < columns; c++)
            {
                Vector3 from = surface.Positions[rows < columns ? grid[c] : grid[r * stride]];
                Vector3 to = surface.Positions[rows < columns ? grid[(rows * stride) + c] : grid[(r * stride) + columns]];
                surface.Positions[grid[(r * stride) + c]] = Vec.Lerp(from, to, rows < columns ? (float)r / rows : (float)c / columns);
            }
        }
    }

    /// <summary>Adds the quads of a grid made by <see cref="Vertices"/>, with flat texture coordinates in the given chart.</summary>
    public static void Fill(SurfaceBuilder surface, int[] grid, int rows, int columns, int chart, Vector2 size)
    {
        int stride = columns + 1;
        for (int r = 0; r < rows; r++)
        {
            for (int c = 0; c < columns; c++)
            {
                int a = (r * stride) + c;
                surface.Quad(grid[a], grid[a + 1], grid[a + stride + 1], grid[a + stride], chart, CellTexcoords(r, c, rows, columns, size));
            }
        }
    }

    /// <summary>Texture coordinates of a cell of a flat grid of the given size, metres.</summary>
    public static FaceTexcoords CellTexcoords(int row, int column, int rows, int columns, Vector2 size)
    {
        float u0 = size.X * column / columns;
        float u1 = size.X * (column + 1) / columns;
        float v0 = size.Y * row / rows;
        float v1 = size.Y * (row + 1) / rows;
        return new FaceTexcoords(new Vector2(u0, v0), new Vector2(u1, v0), new Vector2(u1, v1), new Vector2(u0, v1));
    }
}
