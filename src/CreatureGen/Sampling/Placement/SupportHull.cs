using System;
using System.Collections.Generic;

namespace CreatureGen.Sampling.Placement;

/// <summary>The convex hull of all soles of a standing creature, on the ground.</summary>
/// <remarks>Based on: A. M. Andrew, "Another efficient algorithm for convex hulls in two dimensions" (1979).</remarks>
internal sealed class SupportHull
{
    private readonly (double X, double Z)[] corners;

    /// <summary>Spans the hull over pairs of feet; each foot counts on both sides.</summary>
    /// <exception cref="ArgumentException">There is no foot.</exception>
    public SupportHull(IReadOnlyList<FootContact> feet)
    {
        if (feet.Count == 0)
        {
            throw new ArgumentException("there are no feet; expected at least one pair", nameof(feet));
        }

        var points = new List<(double X, double Z)>(8 * feet.Count);
        foreach (FootContact foot in feet)
        {
            for (int side = -1; side <= 1; side += 2)
            {
                double inner = side * (foot.X - foot.HalfWidth);
                double outer = side * (foot.X + foot.HalfWidth);
                points.Add((inner, foot.Z - foot.Heel));
                points.Add((outer, foot.Z - foot.Heel));
                points.Add((inner, foot.Z + foot.Toe));
                points.Add((outer, foot.Z + foot.Toe));
            }
        }

        points.Sort((a, b) => a.X != b.X ? a.X.CompareTo(b.X) : a.Z.CompareTo(b.Z));
        var hull = new List<(double X, double Z)>(points.Count);
        for (int pass = 0; pass < 2; pass++)
        {
            int floor = hull.Count + 1;
            for (int k = 0; k < points.Count; k++)
            {
                (double X, double Z) p = points[pass == 0 ? k : points.Count - 1 - k];
                while (hull.Count > floor && Turn(hull[hull.Count - 2], hull[hull.Count - 1], p) <= 0)
                {
                    hull.RemoveAt(hull.Count - 1);
                }

                hull.Add(p);
            }

            hull.RemoveAt(hull.Count - 1);
        }

        corners = hull.ToArray();
    }

    /// <summary>Corners in order; the inside is to the left of each edge in a plane with x to the right and z up.</summary>
    public IReadOnlyList<(double X, double Z)> Corners => corners;

    /// <summary>
    /// How far a point lies inside, as part of the hull's width: the smallest, over all edges, of the distance from the edge over the hull's extent across that edge.
    /// 0.5 at best, 0 on the border, negative outside.
    /// </summary>
    public double Margin(double x, double z)
    {
        double margin = double.MaxValue;
        for (int i = 0; i < corners.Length; i++)
        {
            HullEdge edge = Edge(i);
            margin = Math.Min(margin, edge.Distance(x, z) / edge.Extent);
        }

        return margin;
    }

    /// <summary>The shifts of the whole hull along z that give a point of the body's plane x = 0 at least the given margin.</summary>
    /// <remarks>
    /// The interval is never empty: the hull's centroid lies on that plane and at least a third inside across every direction (Minkowski), the margin asks for less.
    /// </remarks>
    /// <param name="z">The point.</param>
    /// <param name="margin">At most 1/3.</param>
    public (double Rearmost, double Foremost) Shifts(double z, double margin)
    {
        double low = -double.MaxValue;
        double high = double.MaxValue;
        for (int i = 0; i < corners.Length; i++)
        {
            // Moving the hull by s changes the distance from the edge by −s times the z of the edge's inward normal.
            HullEdge edge = Edge(i);
            double spare = edge.Distance(0, z) - (margin * edge.Extent);
            if (edge.NormalZ > 0)
            {
                high = Math.Min(high, spare / edge.NormalZ);
            }
            else if (edge.NormalZ < 0)
            {
                low = Math.Max(low, spare / edge.NormalZ);
            }
        }

        return (low, high);
    }

    private HullEdge Edge(int index)
    {
        (double X, double Z) a = corners[index];
        (double X, double Z) b = corners[(index + 1) % corners.Length];
        double dx = b.X - a.X;
        double dz = b.Z - a.Z;
        double length = Math.Sqrt((dx * dx) + (dz * dz));
        var edge = new HullEdge(a.X, a.Z, -dz / length, dx / length, 0);
        double extent = 0;
        foreach ((double X, double Z) corner in corners)
        {
            extent = Math.Max(extent, edge.Distance(corner.X, corner.Z));
        }

        return edge with { Extent = extent };
    }

    private static double Turn((double X, double Z) a, (double X, double Z) b, (double X, double Z) c) =>
        ((b.X - a.X) * (c.Z - a.Z)) - ((b.Z - a.Z) * (c.X - a.X));

    private readonly record struct HullEdge(double X, double Z, double NormalX, double NormalZ, double Extent)
    {
        public double Distance(double x, double z) => ((x - X) * NormalX) + ((z - Z) * NormalZ);
    }
}
