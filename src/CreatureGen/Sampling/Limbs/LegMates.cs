using System;
using System.Collections.Generic;
using CreatureGen.Anatomy.Legs;
using CreatureGen.Bodies;
using CreatureGen.Maths;
using CreatureGen.Sampling.Placement;

namespace CreatureGen.Sampling.Limbs;

/// <summary>How pairs of legs under one body become alike: each is as thick as the trunk where it grows, and below a deep chest and narrow hips they were those of two creatures.</summary>
internal static class LegMates
{
    // Share, as a power, of what a pair is thicker than all pairs are in the mean that its shank and its feet give up.
    private const double Shank = 0.35;
    private const double Foot = 0.5;

    /// <summary>Most that a pair counts as thicker or thinner than the mean.</summary>
    private const double Furthest = 1.6;

    /// <summary>Factors on the slimness and on the feet of a pair.</summary>
    /// <param name="builder">The creature.</param>
    /// <param name="leg">The pair.</param>
    /// <param name="pairs">All pairs that it stands on.</param>
    public static (double Slimness, double Foot) Evened(CreatureBuilder builder, LegPlacement leg, IReadOnlyList<LegPlacement> pairs)
    {
        if (!IsUnderBody(leg))
        {
            return (1, 1);
        }

        double mean = 1;
        int count = 0;
        foreach (LegPlacement mate in pairs)
        {
            if (IsUnderBody(mate))
            {
                mean *= Thickness(mate, builder.Shape);
                count++;
            }
        }

        double ratio = Scalar.Clamp(PortableMath.Pow(mean, 1.0 / count) / Thickness(leg, builder.Shape), 1 / Furthest, Furthest);
        return (PortableMath.Pow(ratio, Shank * builder.Fitting), PortableMath.Pow(ratio, Foot * builder.Fitting));
    }

    private static bool IsUnderBody(LegPlacement leg) => LegKinds.Of(leg.Site.Archetype) is { Build.Posture: LimbPosture.Under, Outline: { MinThickness: > 0, Jointed: false } };

    /// <summary>How thick a leg is grown from its socket, metres.</summary>
    private static double Thickness(LegPlacement leg, BodyShape shape)
    {
        int first = leg.Socket.Ring;
        int last = first + leg.Socket.Rows;
        double dy = shape.Y[last] - shape.Y[first];
        double dz = shape.Z[last] - shape.Z[first];
        return LegKinds.Of(leg.Site.Archetype).Outline.Thickness((float)leg.RootRadius, (float)(Math.Sqrt((dy * dy) + (dz * dz)) / 2), (float)leg.RootHeight);
    }
}
