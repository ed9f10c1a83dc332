using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Locomotion;

/// <summary>Where feet belong under a body that goes: those of sprawlers about below the hip, and insects' feet between the outer pairs spread evenly, so that neighbours have the same room.</summary>
internal static class FootHomes
{
    /// <summary>How far ahead of the hip the hind feet of sprawlers belong, leg lengths.</summary>
    private const float SprawlHind = 0.10f;

    /// <summary>The same of fore feet.</summary>
    private const float SprawlFore = 0.02f;

    /// <summary>How far back the hind feet of frogs are moved, whose knees point ahead to the elbows, leg lengths.</summary>
    private const float FrogShift = 0.1f;

    /// <summary>How far a foot is moved for its neighbours' sake at most, leg lengths.</summary>
    private const float MostShift = 0.12f;

    /// <summary>How far feet are set ahead of the hips on a way uphill, and back downhill, as a trunk that lies along the slope has them: part of what the ground rises over the height of the hip.</summary>
    private const float SlopeBias = 0.6f;

    /// <summary>How far ahead a foot belongs for each metre that the ground rises in one metre; none where the trunk does not lie along the slope, or its legs are out to the side.</summary>
    public static float Ahead(LegShape leg, int rows) => leg.Lateral || rows == 1 ? 0f : SlopeBias * leg.HipRest.Y;

    /// <summary>Homes of all feet, model space.</summary>
    /// <param name="legs">Of a body.</param>
    /// <param name="rows">Number of its pairs.</param>
    public static Vector3[] Of(LegShape[] legs, int rows)
    {
        var homes = new Vector3[legs.Length];
        for (int i = 0; i < legs.Length; i++)
        {
            LegShape leg = legs[i];
            homes[i] = leg.Gathered;
            if (leg.Traits.Archetype == LimbArchetype.Sprawl && rows == 2)
            {
                homes[i].Z += leg.HipRest.Z - leg.Home.Z + ((leg.Row == 0 ? SprawlHind : SprawlFore) * leg.Length);
            }
            else if (leg.Traits.Archetype is LimbArchetype.FrogHind)
            {
                homes[i].Z -= FrogShift * leg.Length;
            }
            else if (leg.Traits.Archetype is LimbArchetype.Insect or LimbArchetype.Sprawl && Beside(legs, leg, -1) is LegShape hind && Beside(legs, leg, 1) is LegShape fore)
            {
                float shift = (0.5f * (hind.Gathered.Z + fore.Gathered.Z)) - leg.Gathered.Z;
                homes[i].Z += Scalar.Clamp(shift, -MostShift * leg.Length, MostShift * leg.Length);
            }
        }

        return homes;
    }

    private static LegShape? Beside(LegShape[] legs, LegShape leg, int rows) => System.Array.Find(legs, other => other.Side == leg.Side && other.Row == leg.Row + rows);
}
