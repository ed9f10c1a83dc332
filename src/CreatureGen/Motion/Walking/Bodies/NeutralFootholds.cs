using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>Where feet belong under a body that goes: those of sprawlers about below the hip, and insects' feet between the outer pairs spread evenly, so that neighbours have the same room.</summary>
internal static class NeutralFootholds
{
    /// <summary>How far ahead of the hip the hind feet of sprawlers belong, leg lengths.</summary>
    private const float SprawlHind = 0.10f;

    /// <summary>The same of fore feet.</summary>
    private const float SprawlFore = 0.02f;

    /// <summary>How far back the hind feet of frogs are moved, whose knees point ahead to the elbows, leg lengths.</summary>
    private const float FrogShift = 0.1f;

    /// <summary>How far a foot is moved for its neighbours' sake at most, leg lengths.</summary>
    private const float MaxShift = 0.12f;

    /// <summary>Homes of all feet, model space.</summary>
    /// <param name="legs">Of a body.</param>
    /// <param name="rows">Number of its pairs.</param>
    public static Vector3[] Of(LegRig[] legs, int rows)
    {
        var homes = new Vector3[legs.Length];
        for (int i = 0; i < legs.Length; i++)
        {
            LegRig leg = legs[i];
            homes[i] = leg.Gathered;
            if (leg.Traits.Kind.Outline.Sprawling && rows == 2)
            {
                homes[i].Z += leg.HipRest.Z - leg.Home.Z + ((leg.Row == 0 ? SprawlHind : SprawlFore) * leg.Length);
            }
            else if (leg.Traits.Kind.Step.KneesAhead)
            {
                homes[i].Z -= FrogShift * leg.Length;
            }
            else if (leg.Traits.Kind.Outline.Lateral && Beside(legs, leg, -1) is LegRig hind && Beside(legs, leg, 1) is LegRig fore)
            {
                float shift = (0.5f * (hind.Gathered.Z + fore.Gathered.Z)) - leg.Gathered.Z;
                homes[i].Z += Scalar.Clamp(shift, -MaxShift * leg.Length, MaxShift * leg.Length);
            }
        }

        return homes;
    }

    private static LegRig? Beside(LegRig[] legs, LegRig leg, int rows) => Array.Find(legs, other => other.Side == leg.Side && other.Row == leg.Row + rows);
}
