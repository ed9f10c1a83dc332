using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Creatures;

namespace CreatureGen.Inspection;

/// <summary>How far a creature's centre of mass is inside the hull of all its soles, across the edge that it is nearest to in the hull's own measure.</summary>
/// <param name="Fraction">As part of the hull's width across that edge; negative outside, and minus infinity where there is no hull.</param>
/// <param name="Metres">In metres, across the edge where that is least; negative outside.</param>
internal readonly record struct StandingBalance(double Fraction, double Metres)
{
    /// <summary>Part of the standing height. Skin this low carries weight: soles give.</summary>
    private const float SoleHeight = 4e-3f;

    /// <summary>Of a creature in rest pose.</summary>
    public static StandingBalance Of(Creature creature) => Of(creature, new WeldedSkin(creature.Mesh));

    /// <summary>The same of a skin that is at hand.</summary>
    public static StandingBalance Of(Creature creature, WeldedSkin skin)
    {
        var soles = new List<(double X, double Z)>();
        float height = SoleHeight * creature.StandingHeight;
        foreach (int v in skin.BodyTriangles)
        {
            Vector3 p = skin.Positions[v];
            if (p.Y <= height)
            {
                soles.Add((p.X, p.Z));
            }
        }

        List<(double X, double Z)> hull = ConvexHull(soles);
        if (hull.Count < 3)
        {
            return new StandingBalance(double.NegativeInfinity, double.NegativeInfinity);
        }

        double fraction = double.PositiveInfinity;
        double metres = double.PositiveInfinity;
        for (int i = 0; i < hull.Count; i++)
        {
            (double X, double Z) a = hull[i], b = hull[(i + 1) % hull.Count];
            double length = Math.Sqrt(((b.X - a.X) * (b.X - a.X)) + ((b.Z - a.Z) * (b.Z - a.Z)));
            double width = 0;
            foreach ((double X, double Z) p in hull)
            {
                width = Math.Max(width, Turn(a, b, p) / length);
            }

            double inside = Turn(a, b, (creature.Mass.Centre.X, creature.Mass.Centre.Z)) / length;
            fraction = Math.Min(fraction, inside / width);
            metres = Math.Min(metres, inside);
        }

        return new StandingBalance(fraction, metres);
    }

    /// <summary>Corners in counter-clockwise order of x and z. Based on: A. M. Andrew 1979, "Another efficient algorithm for convex hulls in two dimensions".</summary>
    private static List<(double X, double Z)> ConvexHull(List<(double X, double Z)> points)
    {
        points.Sort();
        var hull = new List<(double X, double Z)>();
        for (int pass = 0; pass < 2 && points.Count > 0; pass++)
        {
            int floor = hull.Count + 2;
            foreach ((double X, double Z) p in points)
            {
                while (hull.Count >= floor && Turn(hull[hull.Count - 2], hull[hull.Count - 1], p) <= 0)
                {
                    hull.RemoveAt(hull.Count - 1);
                }

                hull.Add(p);
            }

            hull.RemoveAt(hull.Count - 1);
            points.Reverse();
        }

        return hull;
    }

    private static double Turn((double X, double Z) a, (double X, double Z) b, (double X, double Z) c) =>
        ((b.X - a.X) * (c.Z - a.Z)) - ((b.Z - a.Z) * (c.X - a.X));
}
