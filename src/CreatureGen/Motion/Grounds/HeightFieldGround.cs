using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Grounds;

namespace CreatureGen.Motion;

/// <summary>Terrain as heights (along +Y) on a square grid, two triangles in each cell, solid below. There is no ground beyond its edges.</summary>
public sealed class HeightFieldGround : IGround, ITrustedGround
{
    private readonly float[] heights;
    private readonly int columns;
    private readonly int rows;
    private readonly float cell;
    private readonly Vector3 corner;
    private readonly int surface;
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
        highest = float.MinValue;
        foreach (float height in heights)
        {
            Finite.Require(height, nameof(heights));
            highest = Math.Max(highest, height);
        }
    }

    /// <inheritdoc/>
    /// <remarks>
    /// The ray is cut to the box of the field and goes from cell to cell; in each it meets the two triangles exactly. It takes time in proportion to the cells that it crosses, whatever its length.
    /// Based on: J. Amanatides and A. Woo, "A fast voxel traversal algorithm for ray tracing" (1987).
    /// </remarks>
    public bool Cast(Vector3 origin, Vector3 direction, float distance, out GroundHit hit)
    {
        hit = default;
        if (!(Finite.Is(origin) && Finite.Is(direction) && distance >= 0f))
        {
            return false;
        }

        return direction.X == 0f && direction.Z == 0f ? Drop(origin - corner, direction.Y, distance, out hit) : Walk(new GridRay(origin, direction, corner, cell), distance, out hit);
    }

    /// <summary>A vertical ray. One that begins in the ground is at once at its surface.</summary>
    private bool Drop(Vector3 from, float direction, float distance, out GroundHit hit)
    {
        hit = default;
        if (!Sample(from.X, from.Z, out float height, out Vector3 normal))
        {
            return false;
        }

        float above = from.Y - height;
        if (above > 0f && !(direction < 0f && above <= -direction * distance))
        {
            return false;
        }

        hit = new GroundHit(corner + new Vector3(from.X, height, from.Z), normal, surface);
        return true;
    }

    /// <summary>A slanting ray.</summary>
    private bool Walk(in GridRay ray, double distance, out GroundHit hit)
    {
        hit = default;
        double enter = 0;
        double leave = distance;
        if (!GridRay.Clip(ray.U, ray.AlongU, columns - 1, ref enter, ref leave) || !GridRay.Clip(ray.V, ray.AlongV, rows - 1, ref enter, ref leave))
        {
            return false;
        }

        // Above all heights there is nothing to meet.
        if (ray.Y + (ray.AlongY * enter) > highest)
        {
            double sinks = (highest - ray.Y) / ray.AlongY;
            if (!(ray.AlongY < 0 && sinks <= leave))
            {
                return false;
            }

            enter = Math.Max(enter, sinks);
        }

        int i = CellOf(ray.U + (ray.AlongU * enter), columns);
        int k = CellOf(ray.V + (ray.AlongV * enter), rows);
        double nextU = GridRay.Border(ray.U, ray.AlongU, i);
        double nextV = GridRay.Border(ray.V, ray.AlongV, k);
        for (double t = enter; ;)
        {
            double end = Math.Min(Math.Min(nextU, nextV), leave);
            double diagonal = (1 + i + k - ray.U - ray.V) / (ray.AlongU + ray.AlongV);
            bool crosses = diagonal > t && diagonal < end;
            if ((crosses && Meets(ray, i, k, t, diagonal, out hit)) || Meets(ray, i, k, crosses ? diagonal : t, end, out hit))
            {
                return true;
            }

            if (end >= leave || (ray.AlongY >= 0 && ray.Y + (ray.AlongY * end) > highest))
            {
                return false;
            }

            t = end;
            if (nextU <= nextV)
            {
                i += ray.AlongU > 0 ? 1 : -1;
                nextU = GridRay.Border(ray.U, ray.AlongU, i);
            }
            else
            {
                k += ray.AlongV > 0 ? 1 : -1;
                nextV = GridRay.Border(ray.V, ray.AlongV, k);
            }

            if ((uint)i > (uint)(columns - 2) || (uint)k > (uint)(rows - 2))
            {
                return false;
            }
        }
    }

    private static int CellOf(double coordinate, int count) => Math.Max(0, Math.Min((int)coordinate, count - 2));

    /// <summary>Whether a ray goes into the triangle that it is over between two of its points; into it at once if it is below there.</summary>
    private bool Meets(in GridRay ray, int i, int k, double from, double to, out GroundHit hit)
    {
        double middle = 0.5 * (from + to);
        bool near = ray.U + ray.V + ((ray.AlongU + ray.AlongV) * middle) <= 1 + i + k;
        double a = heights[(k * columns) + i];
        double b = heights[(k * columns) + i + 1];
        double c = heights[((k + 1) * columns) + i];
        double d = heights[((k + 1) * columns) + i + 1];
        double alongU = near ? b - a : d - c;
        double alongV = near ? c - a : d - b;
        double level = (near ? a : b + c - d) - (alongU * i) - (alongV * k);

        // How far the ray is above the plane: a straight line.
        double above = ray.Y - level - (alongU * ray.U) - (alongV * ray.V);
        double rate = ray.AlongY - (alongU * ray.AlongU) - (alongV * ray.AlongV);
        double first = above + (rate * from);
        double last = above + (rate * to);
        if (first > 0 && !(last <= 0))
        {
            hit = default;
            return false;
        }

        double t = first <= 0 ? from : from + ((to - from) * (first / (first - last)));
        double u = ray.U + (ray.AlongU * t);
        double v = ray.V + (ray.AlongV * t);
        var point = new Vector3((float)(u * cell), (float)(level + (alongU * u) + (alongV * v)), (float)(v * cell));
        hit = new GroundHit(corner + point, Vec.Normalize(new Vector3((float)-alongU, cell, (float)-alongV)), surface);
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
