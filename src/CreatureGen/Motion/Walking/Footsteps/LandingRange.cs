using System;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;
using CreatureGen.Motion.Walking.Pace;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>Where a foot can come down so that its leg takes it: in a turn, or beside a platform that moves, the middle of the stance to come may be within its range and the landing not.</summary>
internal static class LandingRange
{
    /// <summary>Part of its reach that a leg out to the side takes up at most as its foot comes down.</summary>
    private const float LateralStretch = 0.95f;

    /// <summary>How far a body comes down at most for a leg below it that is about to stand, leg lengths.</summary>
    private const float Drop = 0.12f;

    /// <summary>Part of its level distance from the hip to which a place is drawn in at most.</summary>
    private const float NearestFraction = 0.5f;

    /// <summary>The place that a foot goes to, no farther away than its leg takes it as it comes down.</summary>
    /// <param name="body">Whose foot it is.</param>
    /// <param name="leg">Its leg.</param>
    /// <param name="posed">The leg as it was last posed.</param>
    /// <param name="velocity">How the body goes.</param>
    /// <param name="flight">Seconds until the foot comes down.</param>
    /// <param name="wanted">Where it belongs, model space at present.</param>
    public static Vector3 Within(LeggedBody body, LegRig leg, in LegOutcome posed, in RootVelocity velocity, float flight, Vector3 wanted)
    {
        Vector3 way = velocity.Predict(flight, out float yaw);
        Vector3 place = Rotation.Rotate(AxisRotation.Yaw(-yaw), wanted - way);
        Vector3 rest = leg.Parts.Upper + leg.Shank;
        Vector3 chord = rest + (place - leg.Home);
        Vector3 slid = posed.Hip - leg.HipRest;
        float below = -rest.Y - place.Y;
        Vector3 bounded = leg.Lateral
            ? Reached(leg, chord - slid, Math.Max(LateralStretch, leg.RestStretch) * leg.Reach, below - leg.Stoop, place)
            : Reached(leg, chord, Math.Max(1f, leg.RestStretch) * leg.Reach, below - (Drop * leg.Length), Beside(leg, place));
        bounded = leg.Lateral ? Turned(body, leg, posed.Carrier, bounded, rest - leg.Home - slid) : bounded;
        return bounded == place ? wanted : way + Rotation.Rotate(AxisRotation.Yaw(yaw), bounded);
    }

    /// <summary>How far from a place on the ground a leg below its body would end whose hip does not turn as far as that asks, or that does not fold so far, metres: up steps a thigh comes to its end.</summary>
    /// <param name="body">Whose foot it is.</param>
    /// <param name="leg">Its leg.</param>
    /// <param name="posed">The leg as it was last posed.</param>
    /// <param name="velocity">How the body goes.</param>
    /// <param name="seconds">Until the foot is there.</param>
    /// <param name="place">The place, model space at present.</param>
    public static float Kept(LeggedBody body, LegRig leg, in LegOutcome posed, in RootVelocity velocity, float seconds, Vector3 place)
    {
        Vector3 way = velocity.Predict(seconds, out float yaw);
        Vector3 chord = leg.Parts.Upper + leg.Shank - leg.Home - (posed.Hip - leg.HipRest) + Rotation.Rotate(AxisRotation.Yaw(-yaw), place - way);
        return Vec.Distance(HipRoom.Nearest(body, leg, posed.Carrier, chord, Quaternion.Identity), chord) + Math.Max(leg.FoldedReach - Vec.Length(chord), 0f);
    }

    /// <summary>Draws a place in that is too far from the hip.</summary>
    private static Vector3 Reached(LegRig leg, Vector3 chord, float max, float height, Vector3 place)
    {
        float maxLevel = Math.Max((max * max) - (height * height), 0f);
        float level = (chord.X * chord.X) + (chord.Z * chord.Z);
        if (level <= maxLevel)
        {
            return place;
        }

        float fraction = 1f - Math.Max((float)Math.Sqrt(maxLevel / level), NearestFraction);
        return place - (new Vector3(chord.X, 0f, chord.Z) * fraction);
    }

    /// <summary>Draws a place back that lies farther ahead or behind than the hip turns: the foot would be dragged from there to where its leg brings it.</summary>
    /// <param name="body">Whose leg it is.</param>
    /// <param name="leg">The leg.</param>
    /// <param name="carrier">Turn of the trunk at its hip.</param>
    /// <param name="place">The place.</param>
    /// <param name="chord">What has to be added to a place for the chord of the leg from its hip, metres.</param>
    private static Vector3 Turned(LeggedBody body, LegRig leg, Quaternion carrier, Vector3 place, Vector3 chord)
    {
        Vector3 asked = place + chord;
        Vector3 away = HipRoom.Nearest(body, leg, carrier, asked, Quaternion.Identity) - asked;
        return place + new Vector3(away.X, 0f, away.Z);
    }

    private static Vector3 Beside(LegRig leg, Vector3 place)
    {
        float inward = leg.Side == Side.Left ? -1f : 1f;
        float home = inward * (leg.Home.X - leg.HipRest.X);
        float aside = inward * (place.X - leg.HipRest.X);
        float outer = Math.Min(home, -leg.LandsOut);
        float bounded = Scalar.Clamp(aside, outer, Math.Max(home, leg.LandsIn));
        return bounded == aside ? place : new Vector3(leg.HipRest.X + (inward * bounded), place.Y, place.Z);
    }
}
