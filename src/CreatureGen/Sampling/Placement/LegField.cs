using System;
using System.Collections.Generic;
using CreatureGen.Maths;

namespace CreatureGen.Sampling.Placement;

/// <summary>All places where a body of given height could carry legs, with the legs fitted to each: what the rules choose from.</summary>
internal sealed class LegField
{
    /// <summary>Metres. Lengths that were worked out in different order differ by less.</summary>
    public const double LengthTolerance = 1e-9;

    private readonly LegPlacement[] legs;
    private readonly bool[] usable;

    /// <summary>Fits legs to every socket.</summary>
    /// <param name="measure">The body, already raised.</param>
    /// <param name="set">The anatomy.</param>
    /// <param name="sockets">The sockets in use, front to rear.</param>
    /// <param name="size">Size of legs.</param>
    /// <param name="girth">Thickness of legs.</param>
    /// <param name="raised">How far the body has been raised, metres: places that would need more than the anatomy allows are not usable.</param>
    public LegField(SpineMeasure measure, SocketSet set, IReadOnlyList<LimbSocket> sockets, LegSize size, LegGirth girth, double raised)
    {
        Measure = measure;
        Set = set;
        legs = new LegPlacement[sockets.Count];
        usable = new bool[sockets.Count];
        for (int i = 0; i < legs.Length; i++)
        {
            legs[i] = LegFitting.Stand(measure, sockets[i], size, girth);
            usable[i] = raised + Shortage(i) <= (set.Stance.MaximumRaise * measure.BodyLength) + LengthTolerance;
        }
    }

    /// <summary>The body.</summary>
    public SpineMeasure Measure { get; }

    /// <summary>The anatomy.</summary>
    public SocketSet Set { get; }

    /// <summary>Number of sockets.</summary>
    public int Count => legs.Length;

    /// <summary>The legs at a socket.</summary>
    public LegPlacement this[int socket] => legs[socket];

    /// <summary>Whether the body could be raised enough for legs at a socket.</summary>
    public bool IsUsable(int socket) => usable[socket];

    /// <summary>How much longer the legs at a socket would have to be, metres; negative when they are long enough.</summary>
    public double Shortage(int socket)
    {
        LegPlacement leg = legs[socket];
        double height = LegFitting.AttachmentHeight(Measure.At(leg.Site.Ring), leg.Site.Segment);
        return (Set.Stance.MinimumLength * Measure.BodyLength) - height;
    }

    /// <summary>Whether the legs at a socket could join those already chosen.</summary>
    public bool IsFree(int socket, IReadOnlyList<int> chosen)
    {
        if (!usable[socket])
        {
            return false;
        }

        foreach (int other in chosen)
        {
            if (other == socket || LegSweep.Crosses(legs[socket], legs[other]))
            {
                return false;
            }
        }

        return true;
    }

    /// <summary>The usable socket nearest to a bone's middle ring; of two equally near, the one in front; −1 when there is none.</summary>
    public int SocketOf(int bone)
    {
        double ring = Measure.Bones[bone].Ring;
        int best = -1;
        for (int i = 0; i < legs.Length; i++)
        {
            if (usable[i] && (best < 0 || Math.Abs(legs[i].Site.Ring - ring) < Math.Abs(legs[best].Site.Ring - ring)))
            {
                best = i;
            }
        }

        return best;
    }

    /// <summary>Indices of the bones from the widest to the narrowest; of equally wide ones, those nearer the centre first, then those in front.</summary>
    public int[] BonesByWidth()
    {
        int[] order = new int[Measure.Bones.Count];
        for (int i = 0; i < order.Length; i++)
        {
            order[i] = i;
        }

        Array.Sort(order, (a, b) =>
        {
            int byWidth = Measure.Bones[b].HipWidth.CompareTo(Measure.Bones[a].HipWidth);
            int byCentre = Math.Abs(a - Measure.CentreBone).CompareTo(Math.Abs(b - Measure.CentreBone));
            return byWidth != 0 ? byWidth : byCentre != 0 ? byCentre : a.CompareTo(b);
        });
        return order;
    }

    /// <summary>Whether some place is lost because the body lies too low.</summary>
    public bool AnyTooLow()
    {
        foreach (bool possible in usable)
        {
            if (!possible)
            {
                return true;
            }
        }

        return false;
    }

    /// <summary>How chosen legs are brought into balance. Feet are not shifted where that would make legs cross.</summary>
    public BalanceCorrection Correct(IReadOnlyList<int> chosen)
    {
        BalanceCorrection correction = Correct(chosen, 1);
        return CrossesWhen(chosen, correction) ? Correct(chosen, 0) : correction;
    }

    /// <summary>The legs at chosen sockets, corrected.</summary>
    public List<LegPlacement> Corrected(IReadOnlyList<int> chosen, BalanceCorrection correction)
    {
        var corrected = new List<LegPlacement>(chosen.Count);
        foreach (int socket in chosen)
        {
            corrected.Add(legs[socket].Corrected(correction.Shift, correction.FootGrowth));
        }

        return corrected;
    }

    private bool CrossesWhen(IReadOnlyList<int> chosen, BalanceCorrection correction)
    {
        List<LegPlacement> corrected = Corrected(chosen, correction);
        for (int i = 0; i < corrected.Count; i++)
        {
            for (int j = 0; j < i; j++)
            {
                if (LegSweep.Crosses(corrected[i], corrected[j]))
                {
                    return true;
                }
            }
        }

        return false;
    }

    private BalanceCorrection Correct(IReadOnlyList<int> chosen, int shifts)
    {
        StanceLimits stance = Set.Stance;
        var feet = new FootContact[chosen.Count];
        double rear = -double.MaxValue;
        double front = double.MaxValue;
        double y = 0;
        double z = 0;
        for (int i = 0; i < feet.Length; i++)
        {
            LegPlacement leg = legs[chosen[i]];
            double span = Math.Max(leg.Length, leg.Reach);
            feet[i] = leg.Foot;
            rear = Math.Max(rear, stance.RearwardShear * span);
            front = Math.Min(front, stance.ForwardShear * span);
            y += leg.RootHeight / feet.Length;
            z += leg.RootZ / feet.Length;
        }

        // With two and more pairs the hull hangs on the distance of the feet, and larger soles would only cross.
        double growth = feet.Length == 1 ? stance.MaximumFootGrowth : 1;
        var limits = new BalanceLimits(shifts * rear, shifts * front, new SagittalPoint(y, z), Scalar.Radians(stance.MaximumPitchDegrees), growth) { MinMargin = stance.BalanceMargin };
        return Balance.Correct(feet, Measure.CentreOfMass, limits);
    }
}
