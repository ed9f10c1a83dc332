using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Creatures;
using CreatureGen.Maths;
using CreatureGen.Rigging;

namespace CreatureGen.Inspection;

/// <summary>Whether the feet of a creature that stands are on the ground and its centre of mass is above them.</summary>
internal static class StanceChecks
{
    /// <summary>Part of the support polygon's width by which the centre of mass must be inside.</summary>
    private const double LeastMargin = 0.05;

    /// <summary>Part of the standing height. Skin this low carries weight: soles give.</summary>
    private const float SoleHeight = 4e-3f;

    public static void Check(Creature creature, WeldedSkin skin, ViolationList found)
    {
        if (creature.Blueprint.Kind != LocomotionKind.Walking && !Stands(creature))
        {
            return;
        }

        float tolerance = Tolerance.GroundMetres * Math.Max(1f, (float)creature.Blueprint.Scale);
        CheckLowest(creature.Mesh.Positions, tolerance, found);
        foreach (LimbChain limb in creature.Limbs)
        {
            if (limb.Stands)
            {
                CheckFoot(creature, limb, tolerance, found);
            }
        }

        double margin = Margin(creature, skin);
        if (!(margin >= LeastMargin))
        {
            found.Add(CreatureInspection.Balanced, $"the centre of mass is inside the support polygon by {margin} of its width; expected at least {LeastMargin}");
        }
    }

    private static bool Stands(Creature creature)
    {
        foreach (LimbChain limb in creature.Limbs)
        {
            if (limb.Stands)
            {
                return true;
            }
        }

        return false;
    }

    private static void CheckLowest(ReadOnlySpan<Vector3> positions, float tolerance, ViolationList found)
    {
        float lowest = float.PositiveInfinity;
        foreach (Vector3 p in positions)
        {
            lowest = Math.Min(lowest, p.Y);
        }

        if (!(Math.Abs(lowest) <= tolerance))
        {
            found.Add(CreatureInspection.Grounded, $"the lowest vertex is {lowest} m above the ground; expected 0 within {tolerance} m");
        }
    }

    private static void CheckFoot(Creature creature, LimbChain limb, float tolerance, ViolationList found)
    {
        Span<bool> own = stackalloc bool[256];
        foreach (int joint in limb.Joints)
        {
            own[Math.Min(joint, own.Length - 1)] = true;
        }

        float lowest = float.PositiveInfinity;
        for (int v = 0; v < creature.Mesh.Positions.Length; v++)
        {
            int joint = creature.Mesh.Weights[v].Joint0;
            if (joint < own.Length && own[joint])
            {
                lowest = Math.Min(lowest, creature.Mesh.Positions[v].Y);
            }
        }

        if (!(Math.Abs(lowest) <= tolerance) || !(Math.Abs(limb.Contact.Y) <= tolerance))
        {
            string name = creature.Skeleton.Joints[limb.Joints[0]].Name;
            found.Add(CreatureInspection.Grounded, $"the limb of {name} ends {lowest} m above the ground and its contact is at {limb.Contact.Y} m; expected 0 within {tolerance} m");
        }
    }

    /// <summary>Distance of the centre of mass inside the hull of all soles, as part of the hull's width across the nearest edge; negative outside.</summary>
    private static double Margin(Creature creature, WeldedSkin skin)
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
        double worst = hull.Count < 3 ? double.NegativeInfinity : double.PositiveInfinity;
        for (int i = 0; i < hull.Count && hull.Count >= 3; i++)
        {
            (double X, double Z) a = hull[i], b = hull[(i + 1) % hull.Count];
            double length = Math.Sqrt(((b.X - a.X) * (b.X - a.X)) + ((b.Z - a.Z) * (b.Z - a.Z)));
            double width = 0;
            foreach ((double X, double Z) p in hull)
            {
                width = Math.Max(width, Turn(a, b, p) / length);
            }

            worst = Math.Min(worst, Turn(a, b, (creature.Mass.Centre.X, creature.Mass.Centre.Z)) / length / width);
        }

        return worst;
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
