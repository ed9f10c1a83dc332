using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Modes;
using CreatureGen.Motion.Walking.Bodies;
using CreatureGen.Motion.Walking.Legs;

namespace CreatureGen.Motion.Walking.Footsteps;

/// <summary>When a standing foot gives up its place out of step with the gait: a turn, a push or a platform takes it out of reach. In steady gaits none does.</summary>
internal static class FootRelease
{
    /// <summary>Part of its reach at which a leg that is stretched farther and farther gives up its place: from there on it falls short of it.</summary>
    private const float MaxStretch = 0.99f;

    /// <summary>The same of legs out to the side, for which the body does not come down.</summary>
    private const float LateralStretch = 0.98f;

    /// <summary>How much more than at rest that has to be, parts of its reach: who stands stretched goes on standing so.</summary>
    private const float BeyondRest = 0.01f;

    /// <summary>How far the joints of a leg may keep its foot off its place when it is decided next, as it goes on, leg lengths.</summary>
    private const float MaxMiss = 0.006f;

    /// <summary>Square of how flat the chord of a leg under its hip is, level over upright, from which on that hip may come to its end.</summary>
    private const float Flat = 0.5f;

    /// <summary>How far it may ask the body to come down, and how far as it is stretched farther and farther, leg lengths.</summary>
    private const float MaxDrop = 0.16f;
    private const float MaxGrowingDrop = 0.10f;

    /// <summary>The same late in a stance, when the foot is about to leave the ground, and of a body that stands.</summary>
    private const float LateDrop = 0.24f;
    private const float LateStance = 0.8f;

    /// <summary>Seconds since its last pose from which on nobody knows how its trunk is turned.</summary>
    private const float Overdue = 1.5f * DecisionClock.Period;

    /// <summary>Seconds of a swing out of step: as long as those of the gait, within these.</summary>
    private const float ShortestFlight = 0.06f;
    private const float LongestFlight = 0.35f;

    /// <summary>Whether a foot has to leave the ground at once.</summary>
    /// <param name="foot">Stands; since its leg was posed the body may have moved on.</param>
    /// <param name="body">Whose foot it is.</param>
    /// <param name="leg">Its leg.</param>
    /// <param name="step">The moment.</param>
    /// <param name="onward">How the body goes on.</param>
    public static bool IsDue(ref Foot foot, LeggedBody body, LegRig leg, in StepContext step, in Onward onward)
    {
        Vector3 place = step.Frame.ToModel(foot.Plan.From.Position);
        Vector3 chord = foot.Leg.Chord + place - foot.Path.Base;
        var lowered = new Vector3(0f, foot.Leg.Lowered, 0f);
        float reached = Vec.Length(chord + lowered);
        bool late = foot.Stance > LateStance || !step.Moving;
        bool grows = reached > foot.Plan.Reached;
        bool torn = IsDragged(foot, leg);
        foot.Plan.Reached = reached;
        foot.Plan.Missed = foot.Leg.Residual;
        Vector3 change = Change(foot, step, onward, place);
        Vector3 then = chord + lowered + change;
        if (torn || WillMiss(foot, body, leg, step, then, change, late) > MaxMiss * leg.Length)
        {
            return true;
        }

        float drop = LegRoom.Asked(leg, chord, Vec.Length(chord)) / leg.Length;
        return drop > (late ? LateDrop : MaxDrop)
            || (grows && ((!late && drop > MaxGrowingDrop) || reached > Math.Max(leg.Lateral ? LateralStretch : MaxStretch, leg.RestStretch + BeyondRest) * leg.Reach));
    }

    /// <summary>Whether a foot is drawn farther and farther off its place, to where it will be too far from it when it is decided on again.</summary>
    public static bool IsDragged(in Foot foot, LegRig leg)
    {
        float slides = foot.Leg.Residual - foot.Plan.Missed;
        return slides > 0f && foot.Leg.Residual + slides > MaxMiss * leg.Length;
    }

    /// <summary>How far a foot will be off its place when it is decided on again, metres.</summary>
    private static float WillMiss(in Foot foot, LeggedBody body, LegRig leg, in StepContext step, Vector3 chord, Vector3 change, bool late)
    {
        if (HipMayEnd(leg, chord))
        {
            return Missing(foot, body, leg, step, chord);
        }

        bool leaves = late && step.Ground is not IPlaneGround;
        return leaves || Math.Abs(change.X) > MaxMiss * leg.Length ? Straying(foot, body, leg, step, chord) : 0f;
    }

    /// <summary>By how much the chord will change until the foot is decided on again, or leaves the ground by itself: as it did, or where that is not known, by how the body goes on.</summary>
    private static Vector3 Change(in Foot foot, in StepContext step, in Onward onward, Vector3 place)
    {
        if (step.Since > Overdue || !step.Moving)
        {
            return onward.Later(place) - place;
        }

        float left = (1f - foot.Stance) * step.Clock.Duty * step.Clock.Cycle;
        return foot.Leg.Drift * Math.Min(DecisionClock.Period, left);
    }

    /// <summary>Whether a hip may come to its end with a chord: any out to the side, one above its leg only where that lies flat.</summary>
    private static bool HipMayEnd(LegRig leg, Vector3 chord) => leg.Lateral || (chord.X * chord.X) + (chord.Z * chord.Z) > Flat * chord.Y * chord.Y;

    /// <summary>Whether a standing foot was taken from its place in a long update, since it was last decided what it does.</summary>
    /// <param name="foot">The foot, as it has been posed.</param>
    /// <param name="leg">Its leg.</param>
    /// <param name="seconds">Since the last pose.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static bool IsTorn(in Foot foot, LegRig leg, float seconds) =>
        seconds > 0f && foot.Phase == FootPhase.Stance && foot.Leg.Residual - foot.Plan.Missed > MaxMiss * leg.Length;

    /// <summary>How far a foot will be off its place with a chord, metres: a hip that comes to its end between two decisions would drag it along with the body.</summary>
    private static float Missing(in Foot foot, LeggedBody body, LegRig leg, in StepContext step, Vector3 chord)
    {
        Quaternion carrier = CarrierOf(foot, step);
        float then = HipRoom.Miss(body, leg, carrier, chord);
        return then == 0f ? 0f : foot.Leg.Residual + then - HipRoom.Miss(body, leg, carrier, foot.Leg.Chord + new Vector3(0f, foot.Leg.Lowered, 0f));
    }

    /// <summary>
    /// How far the hip alone will take a foot off its place, metres: of one that goes aside by more than it may miss, as its body turns about it, and on uneven ground of one that is about to leave it, which the trunk
    /// may turn away from before it does. The body comes down for one that is too far away.
    /// </summary>
    private static float Straying(in Foot foot, LeggedBody body, LegRig leg, in StepContext step, Vector3 chord)
    {
        Quaternion heading = foot.Path.Heading;
        float turn = step.RootVelocity.Turn * DecisionClock.Period;
        heading = turn == 0f ? heading : Rotation.Multiply(AxisRotation.Yaw(-turn), heading);
        return Vec.Distance(HipRoom.Nearest(body, leg, CarrierOf(foot, step), chord, heading), chord);
    }

    /// <summary>Turn of the trunk at the hip from rest: it is known for a moment only.</summary>
    private static Quaternion CarrierOf(in Foot foot, in StepContext step) => step.Since > Overdue ? Quaternion.Identity : foot.Leg.Carrier;

    /// <summary>Seconds that such a swing takes.</summary>
    /// <param name="swing">Those of the gait.</param>
    public static float Flight(float swing) => Scalar.Clamp(swing, ShortestFlight, LongestFlight);
}
