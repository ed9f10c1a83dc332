using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Placement;

/// <summary>Whether a creature would fall over, and the least that keeps it standing.</summary>
internal static class Balance
{
    /// <summary>The centre of mass must lie inside the feet's hull by this part of the hull's width.</summary>
    public const double MinMargin = 0.05;

    /// <summary>How much further inside than it must be a correction aims.</summary>
    public const double Reserve = 0.01;

    private const int GrowthSteps = 12;

    /// <summary>
    /// Signed distance of the centre of mass inside the convex hull of all soles, seen from above, as part of the hull's width across the nearest edge:
    /// 0.5 at best, 0 on the border, negative outside.
    /// </summary>
    /// <param name="feet">One entry for each pair; one pair is enough, because soles have length.</param>
    /// <param name="centreOfMass">On the body's plane.</param>
    public static double Margin(IReadOnlyList<FootContact> feet, SagittalPoint centreOfMass) => new SupportHull(feet).Margin(0, centreOfMass.Z);

    /// <summary>
    /// The least change that gives the margin: the smallest shift of all feet; if that is not enough, the full shift and the smallest pitch of the torso; then larger feet;
    /// else the answer is that a pair of legs or a tail is missing.
    /// </summary>
    public static BalanceCorrection Correct(IReadOnlyList<FootContact> feet, SagittalPoint centreOfMass, BalanceLimits limits)
    {
        var hull = new SupportHull(feet);
        double margin = hull.Margin(0, centreOfMass.Z);
        if (margin >= limits.MinMargin)
        {
            return new BalanceCorrection(BalanceRemedy.None, Shift: 0, Pitch: 0, FootGrowth: 1, Margin: margin, Overhang: 0);
        }

        Standing standing = Stand(hull, centreOfMass, limits);
        if (standing.Missing == 0)
        {
            BalanceRemedy remedy = standing.Pitch == 0 ? BalanceRemedy.ShiftFeet : BalanceRemedy.PitchTorso;
            return new BalanceCorrection(remedy, standing.Shift, standing.Pitch, 1, standing.Margin, 0);
        }

        Standing plain = standing;
        for (int step = 1; step <= GrowthSteps && limits.MaximumFootGrowth > 1; step++)
        {
            double growth = 1 + ((limits.MaximumFootGrowth - 1) * step / GrowthSteps);
            standing = Stand(new SupportHull(Grown(feet, growth)), centreOfMass, limits);
            if (standing.Missing == 0)
            {
                return new BalanceCorrection(BalanceRemedy.GrowFeet, standing.Shift, standing.Pitch, growth, standing.Margin, 0);
            }
        }

        return new BalanceCorrection(BalanceRemedy.AddPairOrTail, plain.Shift, plain.Pitch, 1, plain.Margin, plain.Missing);
    }

    private static Standing Stand(SupportHull hull, SagittalPoint centreOfMass, BalanceLimits limits)
    {
        (double rearmost, double foremost) = hull.Shifts(centreOfMass.Z, limits.MinMargin + Reserve);
        double shift = Scalar.Clamp(0, rearmost, foremost);
        double allowed = Scalar.Clamp(shift, limits.RearmostShift, limits.ForemostShift);
        if (allowed == shift)
        {
            return new Standing(shift, 0, hull.Margin(0, centreOfMass.Z - shift), 0);
        }

        double margin = hull.Margin(0, centreOfMass.Z - allowed);
        if (margin >= limits.MinMargin)
        {
            return new Standing(allowed, 0, margin, 0);
        }

        // A centre of mass that lies further back by d needs feet that lie further back by d.
        double missing = shift - allowed;
        double pitch = PitchFor(centreOfMass, limits.Pivot, -missing);
        if (!double.IsNaN(pitch) && Math.Abs(pitch) <= limits.MaximumPitch)
        {
            return new Standing(allowed, pitch, hull.Margin(0, centreOfMass.Z - missing - allowed), 0);
        }

        double bound = missing > 0 ? limits.MaximumPitch : -limits.MaximumPitch;
        double moved = Pitched(centreOfMass, limits.Pivot, bound).Z - centreOfMass.Z;
        if (missing * moved >= 0)
        {
            return new Standing(allowed, 0, margin, missing);
        }

        margin = hull.Margin(0, centreOfMass.Z + moved - allowed);
        return new Standing(allowed, bound, margin, margin >= limits.MinMargin ? 0 : missing + moved);
    }

    /// <summary>A point of the torso after it is pitched up about a pivot.</summary>
    public static SagittalPoint Pitched(SagittalPoint point, SagittalPoint pivot, double pitch)
    {
        double cos = PortableMath.Cos(pitch);
        double sin = PortableMath.Sin(pitch);
        double ahead = point.Z - pivot.Z;
        double above = point.Y - pivot.Y;
        return new SagittalPoint(pivot.Y + (above * cos) + (ahead * sin), pivot.Z + (ahead * cos) - (above * sin));
    }

    /// <summary>The smaller of the pitches that move a point by <paramref name="forward"/> along z; not a number when none does.</summary>
    private static double PitchFor(SagittalPoint point, SagittalPoint pivot, double forward)
    {
        double ahead = point.Z - pivot.Z;
        double above = point.Y - pivot.Y;
        double radius = Math.Sqrt((ahead * ahead) + (above * above));
        double cosine = (ahead + forward) / radius;
        if (!(Math.Abs(cosine) <= 1))
        {
            return double.NaN;
        }

        // ahead·cos p − above·sin p = radius·cos(p + now), so p + now = ±acos(cosine).
        double now = PortableMath.Atan2(above, ahead);
        double turn = PortableMath.Acos(cosine);
        double up = Wrapped(turn - now);
        double down = Wrapped(-turn - now);
        return Math.Abs(up) <= Math.Abs(down) ? up : down;
    }

    private static double Wrapped(double angle) =>
        angle > PortableMath.Pi ? angle - PortableMath.Tau : angle < -PortableMath.Pi ? angle + PortableMath.Tau : angle;

    private static FootContact[] Grown(IReadOnlyList<FootContact> feet, double factor)
    {
        var grown = new FootContact[feet.Count];
        for (int i = 0; i < grown.Length; i++)
        {
            grown[i] = feet[i].Grown(factor);
        }

        return grown;
    }

    private readonly record struct Standing(double Shift, double Pitch, double Margin, double Missing);
}
