using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion;

/// <summary>Terrain as heights (along +Y) on a square grid, two triangles in each cell, solid below. There is no ground beyond its edges.</summary>
public sealed class HeightFieldGround : IGround
{
    private readonly float[] heights;
    private readonly int columns;
    private readonly int rows;
    private readonly float cell;
    private readonly Vector3 corner;
    private readonly int surface;
    private readonly float lowest;
    private readonly float highest;

    /// <summary>Takes heights.</summary>
    /// <param name="heights">Metres above the corner, row by row along +Z, each row along +X; copied.</param>
    /// <param name="columns">Number of heights in a row, at least 2.</param>
    /// <param name="cell">Distance between neighbours, metres.</param>
    /// <param name="corner">Where the first height stands, world space.</param>
    /// <param name="surface">What it is made of.</param>
    /// <exception cref="ArgumentException">The heights do not make whole rows, there are fewer than two rows, or a number is not finite.</exception>
    public HeightFieldGround(ReadOnlySpan<float> heights, int columns, float cell, Vector3 corner, int surface = 0)
    {
        if (columns < 2 || heights.Length % columns != 0 || heights.Length / columns < 2)
        {
            throw new ArgumentException(FormattableString.Invariant($"{heights.Length} heights in rows of {columns}; expected at least two whole rows of at least two"), nameof(heights));
        }

        Finite.RequireWithin(cell, 1e-6f, 1e6f, nameof(cell));
        Finite.Require(corner, nameof(corner));
        this.heights = heights.ToArray();
        this.columns = columns;
        this.cell = cell;
        this.corner = corner;
        this.surface = surface;
        rows = heights.Length / columns;
        lowest = float.MaxValue;
        highest = float.MinValue;
        foreach (float height in heights)
        {
            Finite.Require(height, nameof(heights));
            lowest = Math.Min(lowest, height);
            highest = Math.Max(highest, height);
        }
    }

    /// <inheritdoc/>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        Vector3 from = origin - corner;
        float level = (float)Math.Sqrt((direction.X * direction.X) + (direction.Z * direction.Z));
        if (level < 1e-4f)
        {
            if (!Sample(from.X, from.Z, out float height, out Vector3 normal))
            {
                return false;
            }

            // A ray that begins in the ground is at once at its surface.
            float fall = from.Y - height;
            if (fall > 0f && (direction.Y > 0f || fall > distance))
            {
                return false;
            }

            hit = new GroundHit(corner + new Vector3(from.X, height, from.Z), normal, surface);
            return true;
        }

        // From edge to edge of the triangles: between two of them the terrain below the ray is straight, so nothing is missed.
        float before = 0f;
        for (float t = 0f; ; t = Math.Min(t + ToNextEdge(from + (direction * t), direction), distance))
        {
            Vector3 p = from + (direction * t);
            if (Sample(p.X, p.Z, out float height, out _) && p.Y <= height)
            {
                return Refine(from, direction, before, t, out hit);
            }

            bool away = (p.Y > highest && direction.Y >= 0f) || (p.Y < lowest && direction.Y <= 0f);
            if (t >= distance || away)
            {
                return false;
            }

            before = t;
        }
    }

    /// <summary>How far along a ray the next edge of a triangle is crossed: lines of whole x, of whole z, and of whole x + z, in cells.</summary>
    private float ToNextEdge(Vector3 point, Vector3 direction)
    {
        float u = point.X / cell;
        float v = point.Z / cell;
        float du = direction.X / cell;
        float dv = direction.Z / cell;
        float next = Math.Min(Math.Min(ToWhole(u, du), ToWhole(v, dv)), ToWhole(u + v, du + dv));
        return Math.Max(next, 1e-4f * cell);
    }

    private static float ToWhole(float value, float rate)
    {
        if (Math.Abs(rate) < 1e-9f)
        {
            return float.MaxValue;
        }

        float goal = rate > 0f ? (float)Math.Floor(value + 1e-4f) + 1f : (float)Math.Ceiling(value - 1e-4f) - 1f;
        return (goal - value) / rate;
    }

    private bool Refine(Vector3 from, Vector3 direction, float above, float below, out GroundHit hit)
    {
        for (int i = 0; i < 20; i++)
        {
            float middle = 0.5f * (above + below);
            Vector3 p = from + (direction * middle);
            if (Sample(p.X, p.Z, out float height, out _) && p.Y <= height)
            {
                below = middle;
            }
            else
            {
                above = middle;
            }
        }

        Vector3 at = from + (direction * below);
        Sample(at.X, at.Z, out float y, out Vector3 normal);
        hit = new GroundHit(corner + new Vector3(at.X, y, at.Z), normal, surface);
        return true;
    }

    private bool Sample(float x, float z, out float height, out Vector3 normal)
    {
        float u = x / cell;
        float v = z / cell;
        if (!(u >= 0f && v >= 0f && u <= columns - 1 && v <= rows - 1))
        {
            height = 0f;
            normal = Vector3.UnitY;
            return false;
        }

        int i = Math.Min((int)u, columns - 2);
        int k = Math.Min((int)v, rows - 2);
        float a = heights[(k * columns) + i];
        float b = heights[(k * columns) + i + 1];
        float c = heights[((k + 1) * columns) + i];
        float d = heights[((k + 1) * columns) + i + 1];
        float s = u - i;
        float t = v - k;
        float alongX;
        float alongZ;
        if (s + t <= 1f)
        {
            alongX = b - a;
            alongZ = c - a;
            height = a + (alongX * s) + (alongZ * t);
        }
        else
        {
            alongX = d - c;
            alongZ = d - b;
            height = d - (alongX * (1f - s)) - (alongZ * (1f - t));
        }

        normal = Vec.Normalize(new Vector3(-alongX, cell, -alongZ));
        return true;
    }
}
