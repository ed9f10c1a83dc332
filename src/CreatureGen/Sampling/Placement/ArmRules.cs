using System;
using System.Collections.Generic;
using CreatureGen.Blueprints;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Placement;

/// <summary>Whether a walker has arms, and where.</summary>
/// <remarks>Based on: A. Christo, "Procedural Creature Generation and Animation for Games" (MSc thesis, Bournemouth University, 2022), section 4.2.3.</remarks>
internal static class ArmRules
{
    /// <summary>Arms may reach down to this part of the height of their shoulders and no further.</summary>
    private const double GreatestDrop = 0.85;

    /// <summary>Index of the foremost bone that the first legs make unavailable, their root's radius counted.</summary>
    public static int FirstUsedBone(SpineMeasure measure, IReadOnlyList<LegPlacement> legs)
    {
        double front = double.MaxValue;
        foreach (LegPlacement leg in legs)
        {
            front = Math.Min(front, leg.Along - leg.RootRadius);
        }

        for (int i = 0; i < measure.Bones.Count; i++)
        {
            if (measure.Along(i) + (0.5 * measure.Bones[i].Length) > front)
            {
                return i;
            }
        }

        return measure.Bones.Count - 1;
    }

    /// <summary>Probability of arms: it rises from the anatomy's odds for legs at the head to those for legs at the body's rear end with the distance between head and legs.</summary>
    public static double Odds(SpineMeasure measure, ArmAnatomy anatomy, IReadOnlyList<LegPlacement> legs)
    {
        int used = FirstUsedBone(measure, legs);
        double room = (measure.Along(used) - (0.5 * measure.Bones[used].Length)) / measure.SpineLength;
        return Scalar.Lerp(anatomy.OddsNear, anatomy.OddsFar, Scalar.Smooth(room));
    }

    /// <summary>A pair of arms midway between the head and the first used bone, at the nearest anatomical place; null when it would cross the first legs there.</summary>
    public static ArmPlacement? Place(SpineMeasure measure, ArmAnatomy anatomy, LegSize size, IReadOnlyList<LegPlacement> legs)
    {
        double midway = 0.5 * (measure.Bones[0].Ring + measure.Bones[FirstUsedBone(measure, legs)].Ring);
        int best = 0;
        for (int i = 1; i < anatomy.Sockets.Count; i++)
        {
            if (Math.Abs(anatomy.Sockets[i].Ring - midway) < Math.Abs(anatomy.Sockets[best].Ring - midway))
            {
                best = i;
            }
        }

        LimbSocket site = anatomy.Sockets[best];
        SpineSection section = measure.At(site.Ring);
        double length = Math.Min(anatomy.Length * measure.BodyLength, GreatestDrop * LegFitting.AttachmentHeight(section, site.Segment));
        if (!(length > 0))
        {
            return null;
        }

        LegPlacement arm = LegFitting.Hang(measure, site, size, length, 1);
        foreach (LegPlacement leg in legs)
        {
            if (LegSweep.SocketsTouch(arm, leg) || arm.RootRadius + leg.RootRadius > Math.Abs(leg.Along - arm.Along))
            {
                return null;
            }
        }

        return new ArmPlacement(arm.Bone, site, arm.Socket, length, arm.RootRadius);
    }
}
