using System;
using System.Collections.Generic;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;

namespace CreatureGen.Sampling.Limbs;

/// <summary>Turns arched legs that reach ahead so far back that their shanks do not stand before the face.</summary>
internal static class ClearOfFace
{
    /// <summary>How far out a shank is at the height of its root, and how much further for each height of the root below it, in reaches.</summary>
    private const double ShankAtRoot = 1.4;
    private const double ShankSlope = 0.45;

    /// <summary>Radius of a shank, in reaches.</summary>
    private const double ShankRadius = 0.05;

    /// <summary>Least part of its turn that a leg keeps: it has to carry the head.</summary>
    private const double LeastTurn = 0.5;

    /// <summary>The same places, all legs that reach ahead turned back by one factor.</summary>
    /// <param name="set">The places.</param>
    /// <param name="shape">The body.</param>
    /// <param name="unit">Metres of a reach of 1.</param>
    public static SocketSet Turn(SocketSet set, BodyShape shape, double unit)
    {
        double factor = 1;
        foreach (LimbSocket site in set.Legs)
        {
            if (site.Azimuth > 0 && LegKinds.Of(site.Archetype).Outline.Arched)
            {
                factor = Math.Min(factor, FactorOf(site, shape, site.Reach * unit));
            }
        }

        if (factor == 1)
        {
            return set;
        }

        var turned = new List<LimbSocket>();
        foreach (LimbSocket site in set.Legs)
        {
            turned.Add(site.Azimuth > 0 ? site with { Azimuth = factor * site.Azimuth } : site);
        }

        return set with { Legs = turned };
    }

    private static double FactorOf(LimbSocket site, BodyShape shape, double reach)
    {
        double rear = shape.Z[StationRing.Stop];
        for (int ring = StationRing.Stop; ring <= StationRing.Cranium; ring++)
        {
            rear = Math.Min(rear, shape.Z[ring]);
        }

        double below = (shape.Y[site.Ring] - shape.Y[StationRing.Brow]) / shape.Y[site.Ring];
        double outward = reach * (ShankAtRoot + (ShankSlope * below));
        double shank = shape.Z[site.Ring] + (outward * PortableMath.Sin(site.Azimuth));
        double radius = ShankRadius * reach;
        if (shank - radius > shape.Z[StationRing.MuzzleMiddle] || shank + radius < rear)
        {
            return 1;
        }

        double sine = Scalar.Clamp((rear - radius - shape.Z[site.Ring]) / outward, -1, 1);
        return Math.Max(LeastTurn, PortableMath.Asin(sine) / site.Azimuth);
    }
}
