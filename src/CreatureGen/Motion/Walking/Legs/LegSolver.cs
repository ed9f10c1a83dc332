using System.Numerics;
using System;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Ik;

namespace CreatureGen.Motion.Walking.Legs;

/// <summary>Turns of a leg's bones away from rest, in model space; those of knee and metatarsus relative to their parents are about the hinge alone.</summary>
internal struct LegRotations
{
    /// <summary>Turn of the thigh from rest.</summary>
    public Quaternion Thigh;

    /// <summary>Turn of the shank relative to the thigh.</summary>
    public Quaternion Knee;

    /// <summary>Turn of the shank from rest.</summary>
    public Quaternion Shank;

    /// <summary>Sine of half the angle of that turn.</summary>
    public float KneeHalfSine;

    /// <summary>Length needed as part of the reach; above 1 is out of reach.</summary>
    public float Stretch;

    /// <summary>By how much the leg fell short or was too long, metres.</summary>
    public float Residual;

    /// <summary>How far beyond its limits the knee would have to turn, about half the angle in radians.</summary>
    public float Strain;

    /// <summary>Bend of the knee about its hinge, radians: 0 is straight, negative for elbows.</summary>
    public float Bend;

    /// <summary>Turn of the shank relative to the thigh about the hinge, radians.</summary>
    public readonly float KneeTurn => 2f * FastTrigonometry.Of(KneeHalfSine, Knee.W);

    /// <summary>Goes part of the way to other turns of the same leg.</summary>
    /// <param name="other">The other turns.</param>
    /// <param name="fraction">How far, 0..1.</param>
    /// <param name="hinge">Axis of the knee.</param>
    public void Blend(in LegRotations other, float fraction, Vector3 hinge)
    {
        Thigh = UnitRotation.Nlerp(Thigh, other.Thigh, fraction);
        Knee = UnitRotation.Nlerp(Knee, other.Knee, fraction);
        KneeHalfSine = Vec.Dot(new Vector3(Knee.X, Knee.Y, Knee.Z), hinge);
        Shank = Rotation.Multiply(Thigh, Knee);
    }
}

/// <summary>
/// Reaches for a point with two parts joined by a hinge: thigh and shank, or, for legs of three bones whose thigh and metatarsus turn together, both of these as one part and the shank as the other.
/// Closed form; the end of the reach is eased, since a knee near straight snaps.
/// </summary>
internal static class LegSolver
{
    /// <summary>Share of the body's own axis in the plane of a leg out to the side.</summary>
    private const float BodyFraction = 0.3f;

    /// <summary>How much earlier in the middle of the swing.</summary>
    private const float SwingSlack = 0.07f;

    /// <summary>Distance of a target from the knee, in lengths of the shank, from which on a leg whose thigh is held turns its shank to it, and at which it does so all the way.</summary>
    private const float Near = 0.5f;
    private const float Far = 0.8f;

    /// <summary>Angle on either side of the lowest place of an end that is too low, radians, in which it goes through that to the other side: at once it was a flip of the knee.</summary>
    private const double Passing = 0.7;

    /// <summary>Parts of its reach below which such a leg is folded under the body, where it keeps its bend, and from which on it is not.</summary>
    private const float Folded = 0.55f;
    private const float Unfolded = 0.7f;

    /// <summary>How near to its hip a foot in the air comes that begins to go past it outside, as a factor on how near a folded leg brings it.</summary>
    private const float NearlyFolded = 1.1f;

    /// <summary>Squares of how upright a leg is, upright over all of its length, from which on one that is too short keeps its end over its place, and at which it does so wholly: one that lies flatter would be raised far for that.</summary>
    private const float Flat = 0.3f;
    private const float Upright = 0.5f;

    /// <summary>Solves a leg.</summary>
    /// <param name="leg">At rest.</param>
    /// <param name="parts">Its parts at rest, or with the metatarsus folded.</param>
    /// <param name="target">Where the end has to be, from the hip.</param>
    /// <param name="side">Where the hinge has to point.</param>
    /// <param name="slack">0..1: how early the reach is eased.</param>
    /// <param name="tolerance">How far the knee may stay beyond its limits, about half the angle in radians.</param>
    /// <param name="over">Direction away from the ground, as long as an end that the leg does not reach down to stays over its place, 0..1, instead of being drawn towards the hip: a foot that stands would be dragged.</param>
    /// <param name="turns">The turns.</param>
    public static void Solve(LegRig leg, in LegSegments parts, Vector3 target, Vector3 side, float slack, float tolerance, Vector3 over, out LegRotations turns)
    {
        Vector3 n = leg.Hinge;
        double max = parts.Max;
        double min = parts.Min;
        double asked = Math.Sqrt(Math.Max(Vec.LengthSquared(target) - parts.OffsetSquared, 1e-12));
        double from = ((float)BendRange.EaseFrom - (SwingSlack * slack)) * max;
        double taken = asked;
        if (asked > from)
        {
            double width = max - from;
            taken = from + (width * (1 - PortableMath.Exp(-(asked - from) / width)));
        }
        else if (asked < min)
        {
            taken = min;
        }

        turns.Stretch = (float)(asked / max);
        turns.Residual = (float)Math.Abs(asked - taken);
        double cosNow = parts.Cosine;
        double sinNow = parts.Sine;
        double cosThen = Scalar.Clamp(((taken * taken) - parts.Squares) / parts.Product, -1, 1);
        double sinThen = leg.BendSign * Math.Sqrt((1 - cosThen) * (1 + cosThen));
        double cosKnee = (cosThen * cosNow) + (sinThen * sinNow);
        double sinKnee = (sinThen * cosNow) - (cosThen * sinNow);
        turns.Strain = 0.5f * leg.Limits.Knee.Clamp(ref cosKnee, ref sinKnee, 2f * tolerance);

        HalfAngle.Of(cosKnee, sinKnee, out double halfCosine, out double halfSine);
        turns.Bend = (float)cosThen;
        turns.KneeHalfSine = (float)halfSine;
        turns.Knee = new Quaternion(n * (float)halfSine, (float)halfCosine);

        Vector3 chord = parts.Upper + Rotation.Rotate(turns.Knee, leg.Shank);
        Vector3 aim = target;
        if (leg.Lateral && turns.Strain > tolerance)
        {
            aim = Around(target, Vec.LengthSquared(chord));
        }
        else if (asked > from && over != Vector3.Zero)
        {
            aim = Over(target, Vec.LengthSquared(chord), over);
        }

        turns.Thigh = UnitRotation.Frame(Vec.Normalize(chord, -Vector3.UnitY), n, Vec.Normalize(aim, -Vector3.UnitY), side);
        turns.Shank = Rotation.Multiply(turns.Thigh, turns.Knee);
    }

    /// <summary>Bends the knee of a leg whose thigh is held where it is, so that its end comes as near to its target as it can.</summary>
    /// <param name="leg">At rest.</param>
    /// <param name="parts">Its parts.</param>
    /// <param name="target">Where the end should be, from the hip.</param>
    /// <param name="tolerance">How far the knee may stay beyond its limits, about half the angle in radians.</param>
    /// <param name="turns">The turns; those of knee and shank are made anew.</param>
    public static void Bend(LegRig leg, in LegSegments parts, Vector3 target, float tolerance, ref LegRotations turns)
    {
        Vector3 n = leg.Hinge;
        Vector3 aim = Rotation.Rotate(Rotation.Inverse(turns.Thigh), target) - parts.Upper;

        // The shank points to the target: in the plane across the hinge, from its direction at rest.
        double cos = Vec.Dot(aim, leg.Shank) - (Vec.Dot(aim, n) * Vec.Dot(leg.Shank, n));
        double sin = Vec.Dot(aim, Vec.Cross(n, leg.Shank));
        double distance = Math.Sqrt((cos * cos) + (sin * sin));
        double fraction = Scalar.Smooth((float)((distance / Vec.LengthSquared(leg.Shank)) - Near) / (Far - Near)) * Scalar.Smooth((turns.Stretch - Folded) / (Unfolded - Folded));
        if (fraction > 0)
        {
            // Nearer to the knee than that it would turn about it for the least of ways.
            double before = (turns.Knee.W * turns.Knee.W) - (turns.KneeHalfSine * turns.KneeHalfSine);
            cos = Scalar.Lerp(before, cos / distance, fraction);
            sin = Scalar.Lerp(2d * turns.Knee.W * turns.KneeHalfSine, sin / distance, fraction);
            double scale = 1d / Math.Sqrt(Math.Max((cos * cos) + (sin * sin), 1e-12));
            SetKnee(leg, cos * scale, sin * scale, tolerance, ref turns);
        }
    }

    /// <summary>Bends the knee of a leg whose thigh is held where it is, until its end is as high as asked, or as high as it comes; one that is high enough stays as it is.</summary>
    /// <param name="leg">At rest.</param>
    /// <param name="parts">Its parts.</param>
    /// <param name="away">Direction away from the ground.</param>
    /// <param name="height">How far along it the end has to be, from the hip.</param>
    /// <param name="tolerance">How far the knee may stay beyond its limits, about half the angle in radians.</param>
    /// <param name="turns">The turns; those of knee and shank are made anew.</param>
    public static void Raise(LegRig leg, in LegSegments parts, Vector3 away, float height, float tolerance, ref LegRotations turns)
    {
        Vector3 n = leg.Hinge;
        Vector3 up = Rotation.Rotate(Rotation.Inverse(turns.Thigh), away);

        // The end is as high as: still + a cos θ + b sin θ, θ the turn of the knee.
        double still = Vec.Dot(up, parts.Upper) + (Vec.Dot(up, n) * Vec.Dot(leg.Shank, n));
        double a = Vec.Dot(up, leg.Shank) - (Vec.Dot(up, n) * Vec.Dot(leg.Shank, n));
        double b = Vec.Dot(up, Vec.Cross(n, leg.Shank));
        double cos = (turns.Knee.W * turns.Knee.W) - (turns.KneeHalfSine * turns.KneeHalfSine);
        double sin = 2d * turns.Knee.W * turns.KneeHalfSine;
        double squared = (a * a) + (b * b);
        if (still + (a * cos) + (b * sin) < height && squared > 0)
        {
            double scale = 1d / Math.Sqrt(squared);
            double asked = Math.Min((height - still) * scale, 1d);
            double side = ((sin * a) - (cos * b) < 0 ? -1d : 1d);

            // From the highest place on: where it is, and where it is high enough. Down to the lowest lies as much again on the other side.
            double before = PortableMath.Atan2(Math.Abs((sin * a) - (cos * b)), (cos * a) + (sin * b));
            double high = PortableMath.Atan2(Math.Sqrt((1d - asked) * (1d + asked)), asked);
            double room = PortableMath.Pi - high;
            double angle = high + (room * (1d - Math.Min((PortableMath.Pi - before) / Math.Min(room, Passing), 1d)));
            PortableMath.SinCos(angle, out double sine, out double cosine);
            cos = ((a * cosine) - (b * side * sine)) * scale;
            sin = ((b * cosine) + (a * side * sine)) * scale;
            SetKnee(leg, cos, sin, tolerance, ref turns);
        }
    }

    /// <summary>Turns the knee by the shorter way, within its limits, and the shank with it: by the longer one a knee that is folded as far as it goes would fly open.</summary>
    private static void SetKnee(LegRig leg, double cos, double sin, float tolerance, ref LegRotations turns)
    {
        double before = (turns.Knee.W * turns.Knee.W) - (turns.KneeHalfSine * turns.KneeHalfSine);
        double beforeSine = 2d * turns.Knee.W * turns.KneeHalfSine;
        leg.Limits.Knee.Stop(before, beforeSine, ref cos, ref sin, 2f * tolerance);
        HalfAngle.Of(cos, sin, out double halfCosine, out double halfSine);
        turns.KneeHalfSine = (float)halfSine;
        turns.Knee = new Quaternion(leg.Hinge * (float)halfSine, (float)halfCosine);
        turns.Shank = Rotation.Multiply(turns.Thigh, turns.Knee);
    }

    /// <summary>Where a foot goes that is nearer to its hip than the leg folds: round it outside at the same height, and not down into the ground.</summary>
    private static Vector3 Around(Vector3 target, float lengthSquared)
    {
        float level = (target.X * target.X) + (target.Z * target.Z);
        float wanted = lengthSquared - (target.Y * target.Y);
        if (wanted <= level || level < 1e-4f * lengthSquared)
        {
            return target;
        }

        float fraction = (float)Math.Sqrt(wanted / level);
        return new Vector3(target.X * fraction, target.Y, target.Z * fraction);
    }

    /// <summary>Where a foot goes that is farther from its hip than the leg reaches: over its place as far as the leg stands upright, towards the hip for the rest.</summary>
    private static Vector3 Over(Vector3 target, float lengthSquared, Vector3 over)
    {
        float whole = Vec.Length(over);
        Vector3 away = over / whole;
        float below = -Vec.Dot(target, away);
        float squared = Vec.LengthSquared(target);
        float upright = lengthSquared - squared + (below * below);
        float fraction = below > 0f ? whole * Scalar.Smooth(((upright / lengthSquared) - Flat) / (Upright - Flat)) : 0f;
        Vector3 nearer = target * (float)Math.Sqrt(lengthSquared / squared);
        return fraction > 0f ? Vec.Lerp(nearer, target + (away * (below - (float)Math.Sqrt(upright))), fraction) : nearer;
    }

    /// <summary>Where a leg out to the side reaches for whose foot in the air comes nearer to its hip than it folds: past the hip on its outer side at the same height. Straight away from the hip, as one that stands, it would be kept in the ground by its limits.</summary>
    /// <param name="leg">At rest.</param>
    /// <param name="carrier">Turn of the trunk at its hip from rest.</param>
    /// <param name="chord">From the hip to the foot.</param>
    /// <param name="ground">Height of its way on the ground.</param>
    /// <param name="fraction">How far it comes out, 0..1.</param>
    public static Vector3 Outside(LegRig leg, Quaternion carrier, Vector3 chord, float ground, float fraction)
    {
        // As far as where it is lifted most, all the time: at the height at which it just begins to be folded it would come out at once.
        float high = Math.Max(ground + (leg.Traits.Lift * leg.Length), chord.Y);
        float near = NearlyFolded * leg.FoldedReach;
        float squared = (near * near) - (high * high);
        if (squared <= 0f)
        {
            return chord;
        }

        Vector3 side = Rotation.Rotate(carrier, leg.Side == Anatomy.Side.Left ? Vector3.UnitX : -Vector3.UnitX);
        Vector3 outward = Vec.Normalize(new Vector3(side.X, 0f, side.Z), Vector3.UnitX);
        float along = (chord.Z * outward.X) - (chord.X * outward.Z);
        float outside = Vec.Dot(chord, outward);
        float past = PastHip.Out(outside, along, (float)Math.Sqrt(squared));
        if (past == outside)
        {
            return chord;
        }

        // It turns about the hip to there: straight from within it would whirl past it.
        fraction *= Scalar.Smooth((near + high) / (near - leg.FoldedReach));
        float turn = fraction * FastTrigonometry.Of((outside - past) * along, (outside * past) + (along * along));
        FastTrigonometry.SinCos(turn, out float sine, out float cosine);
        float scale = Scalar.Lerp(1f, (float)Math.Sqrt(((past * past) + (along * along)) / Math.Max((outside * outside) + (along * along), 1e-12f)), fraction);
        float to = scale * ((outside * cosine) - (along * sine));
        float ahead = scale * ((along * cosine) + (outside * sine));
        return (outward * to) + new Vector3(-outward.Z * ahead, chord.Y, outward.X * ahead);
    }

    /// <summary>Where the solved parts end, from the hip.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 EndOf(LegRig leg, in LegSegments parts, in LegRotations solved) => Rotation.Rotate(solved.Thigh, parts.Upper) + Rotation.Rotate(solved.Shank, leg.Shank);

    /// <summary>Where the hinge of the knee has to point, for a place from the hip.</summary>
    /// <param name="leg">At rest.</param>
    /// <param name="carrier">Turn of the trunk at its hip from rest.</param>
    /// <param name="chord">From the hip to the foot.</param>
    /// <param name="heading">Of the foot.</param>
    /// <param name="lean">How far the plane of a leg out to the side lies over about the chord, radians, the knee ahead.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector3 Side(LegRig leg, Quaternion carrier, Vector3 chord, Quaternion heading, float lean)
    {
        Vector3 carried = Rotation.Rotate(carrier, leg.Hinge);
        if (!leg.Lateral)
        {
            // With the foot as far as its ankle asks, with the pelvis and the way of the body for the rest.
            float share = leg.Limits.FootShare;
            float rest = (1f - share) / (1f - LegLimits.LeastFootShare);
            return Vec.Scale(carried, rest) + Vec.Scale(Rotation.Rotate(heading, leg.Hinge), 2f * share) + Vec.Scale(leg.Hinge, 0.5f * rest);
        }

        // The leg's plane stands upright through hip and ankle; the share of the body's own axis keeps it when the foot is nearly below the hip.
        Vector3 across = Vec.Scale(Vec.Cross(chord, Rotation.Rotate(carrier, Vector3.UnitY)), leg.AcrossSign / Math.Max(Vec.Length(chord), 1e-6f));
        Vector3 upright = across + Rotation.Rotate(carrier, Vec.Scale(leg.Skew, Vec.Length(across))) + Vec.Scale(carried, BodyFraction);
        return lean == 0f ? upright : Rotation.Rotate(AxisRotation.About(Vec.Normalize(chord, Vector3.UnitX), leg.Side == Anatomy.Side.Left ? lean : -lean), upright);
    }
}
