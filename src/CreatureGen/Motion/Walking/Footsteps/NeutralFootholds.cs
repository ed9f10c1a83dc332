using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

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

    /// <summary>How far feet are set ahead of the hips on a way uphill, and back downhill: part of what the ground rises over the height of the hip. 1 is where a trunk that lies along the slope has them.</summary>
    private const float SlopeBias = 0.6f;

    /// <summary>The same of legs out to the side, which carry the body low.</summary>
    private const float LateralSlopeBias = 1f;

    /// <summary>Rise of the ground that counts at most.</summary>
    private const float MaxSlope = 0.5f;

    /// <summary>How far ahead of its place on the level a foot belongs on a slope, metres: so much for its hip, and nearer to the middle, as the trunk is seen from above; none on two legs, whose trunk stays upright.</summary>
    /// <param name="leg">Gives the hip.</param>
    /// <param name="rows">Number of pairs.</param>
    /// <param name="place">Ahead of the root, on the level, metres.</param>
    /// <param name="slope">Rise of the ground along the way.</param>
    public static float Ahead(LegRig leg, int rows, float place, float slope) =>
        rows == 1 ? 0f : ((leg.Lateral ? LateralSlopeBias : SlopeBias) * leg.HipRest.Y * slope) - (place * Shortening(slope));

    /// <summary>Where a foot belongs under the body: its rest place, drawn in towards the middle and shifted ahead or back with the gait, model space.</summary>
    /// <param name="body">Gives the legs.</param>
    /// <param name="leg">Which.</param>
    /// <param name="activity">0 stands, 1 walks.</param>
    /// <param name="clock">Gives the gait.</param>
    /// <param name="speed">Metres per second ahead.</param>
    /// <param name="slope">Rise of the ground along the way.</param>
    public static Vector3 Under(LeggedBody body, int leg, float activity, GaitClock clock, float speed, float slope)
    {
        LegRig shape = body.Legs[leg];
        Vector3 home = shape.Home + ((body.GoingHomes[leg] - shape.Home) * activity);
        float track = shape.Track(clock.Shape.Track, body.IsBiped ? clock.Shape.Lift : 0f);
        home.X *= 1f - ((1f - track) * activity);
        bool sprawls = shape.Traits.Archetype == LimbArchetype.Sprawl && body.Rows == 2;
        float bias = sprawls ? 0f : body.Rows == 2 ? (shape.Row == 0 ? clock.Shape.HindBias : clock.Shape.ForeBias) : body.IsBiped ? clock.Shape.HindBias : 0f;
        home.Z += bias * clock.Duty * speed / clock.Frequency * activity;
        home.Z += Ahead(shape, body.Rows, home.Z, Scalar.Clamp(slope, -MaxSlope, MaxSlope)) * activity;
        return home;
    }

    /// <summary>By what part a way along a slope is shorter, seen from above.</summary>
    public static float Shortening(float slope) => 1f - (1f / (float)Math.Sqrt(1f + (slope * slope)));

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
            if (leg.Traits.Archetype == LimbArchetype.Sprawl && rows == 2)
            {
                homes[i].Z += leg.HipRest.Z - leg.Home.Z + ((leg.Row == 0 ? SprawlHind : SprawlFore) * leg.Length);
            }
            else if (leg.Traits.Archetype is LimbArchetype.FrogHind)
            {
                homes[i].Z -= FrogShift * leg.Length;
            }
            else if (leg.Traits.Archetype is LimbArchetype.Insect or LimbArchetype.Sprawl && Beside(legs, leg, -1) is LegRig hind && Beside(legs, leg, 1) is LegRig fore)
            {
                float shift = (0.5f * (hind.Gathered.Z + fore.Gathered.Z)) - leg.Gathered.Z;
                homes[i].Z += Scalar.Clamp(shift, -MaxShift * leg.Length, MaxShift * leg.Length);
            }
        }

        return homes;
    }

    private static LegRig? Beside(LegRig[] legs, LegRig leg, int rows) => Array.Find(legs, other => other.Side == leg.Side && other.Row == leg.Row + rows);
}
