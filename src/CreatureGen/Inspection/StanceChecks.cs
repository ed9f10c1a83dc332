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
    private const double MinMargin = 0.05;

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

        double margin = StandingBalance.Of(creature, skin).Fraction;
        if (!(margin >= MinMargin))
        {
            found.Add(CreatureInspection.Balanced, $"the centre of mass is inside the support polygon by {margin} of its width; expected at least {MinMargin}");
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
}
