using System;
using System.Numerics;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Winged;

/// <summary>How a wing lies against the body that it belongs to: of the ways of folding that its kind has the one that fits best, found by trying one number after the other in ever smaller steps.</summary>
internal sealed class FoldedWing
{
    private const int Rounds = 10;
    private const double FirstStep = 0.24;
    private const double Shrink = 0.7;

    /// <summary>What crowded skin costs, in relation to being off the body by a body length.</summary>
    private const double CrowdingCost = 0.08;

    private readonly PairedChain chain;
    private readonly WingSkin skin;
    private readonly double incidence;
    private readonly double beyond;
    private readonly float upperArm;
    private readonly Quaternion[] turns;
    private float length;

    private FoldedWing(PairedChain chain, WingSkin skin, double incidence, double beyond, float upperArm)
    {
        this.chain = chain;
        this.skin = skin;
        this.incidence = incidence;
        this.beyond = beyond;
        this.upperArm = upperArm;
        turns = new Quaternion[chain.Count];
    }

    /// <summary>Share of its length that a bone keeps: the upper arm most of it, for there the skin bends.</summary>
    public float LengthOf(int bone) => bone == 0 ? 1f - (upperArm * (1f - length)) : length;

    /// <summary>The turn of a joint of the left wing.</summary>
    public Quaternion Turn(int joint) => turns[joint];

    /// <summary>Fits a pair of wings to a body; their rear edges are raised by an incidence at rest, and by so much more beyond the elbow, radians.</summary>
    public static FoldedWing Of(MotionSubject subject, PairedChain chain, double incidence, double beyond, FoldRange range, FoldRoom room)
    {
        var wing = new FoldedWing(chain, WingSkin.Of(subject, chain), incidence, beyond, range.UpperArm);
        wing.Fold(wing.Search(range, room));
        return wing;
    }

    /// <summary>Lays the folded wing onto the flank: wings that are folded later lie outside of it.</summary>
    public void Cover(MotionSubject subject, FoldRoom room)
    {
        Span<Quaternion> carried = stackalloc Quaternion[chain.Count];
        Span<Vector3> joints = stackalloc Vector3[chain.Count];
        Place(joints, carried);
        skin.Cover(subject.Mesh, joints, carried, room);
    }

    /// <summary>The best way of folding: near the usual one, or near another where a search begins.</summary>
    private WingFold Search(FoldRange range, FoldRoom room)
    {
        WingFold best = Search(range.Usual, range, room, out double min);
        foreach (WingFold start in range.Others)
        {
            WingFold found = Search(start, range, room, out double cost);
            (best, min) = cost < min ? (found, cost) : (best, min);
        }

        return best;
    }

    private WingFold Search(WingFold best, FoldRange range, FoldRoom room, out double min)
    {
        min = Try(best, range, room, double.PositiveInfinity);
        double step = FirstStep;
        for (int round = 0; round < Rounds; round++, step *= Shrink)
        {
            for (int number = 0; number < WingFold.Count; number++)
            {
                for (int sign = -1; sign <= 1; sign += 2)
                {
                    WingFold other = best.With(number, sign * step, range.Min, range.Max);
                    double cost = other == best ? min : Try(other, range, room, min);
                    (best, min) = cost < min ? (other, cost) : (best, min);
                }
            }
        }

        return best;
    }

    /// <summary>What a way of folding costs; infinity where that is more than a sum for certain.</summary>
    private double Try(in WingFold fold, FoldRange range, FoldRoom room, double max)
    {
        Fold(fold);
        Span<Quaternion> carried = stackalloc Quaternion[chain.Count];
        Span<Vector3> joints = stackalloc Vector3[chain.Count];
        Place(joints, carried);
        double corners = range.CornerCost * fold.Corners;
        double cost = skin.Cost(joints, carried, room, range, max - corners);
        return double.IsPositiveInfinity(cost) ? cost : cost + corners + (CrowdingCost * skin.Crowding(joints, carried));
    }

    /// <summary>Where the joints are and how they are turned in the model.</summary>
    private void Place(Span<Vector3> joints, Span<Quaternion> carried)
    {
        Quaternion turn = Quaternion.Identity;
        Vector3 place = chain.Points[0];
        for (int k = 0; k < chain.Count; k++)
        {
            joints[k] = place;
            turn = carried[k] = Rotation.Normalize(Rotation.Multiply(turn, turns[k]));
            place += Rotation.Rotate(turn, (chain.Points[k + 1] - chain.Points[k]) * LengthOf(k));
        }
    }

    /// <summary>Turns the joints as far as they can.</summary>
    private void Fold(in WingFold fold)
    {
        length = (float)fold.Length;
        Quaternion carried = Quaternion.Identity;
        for (int k = 0; k < turns.Length; k++)
        {
            Quaternion rest = Rotation.Multiply(Rotation.FromAxisAngle(chain.Axes[k], incidence + (k == 0 ? 0 : beyond)), JointFrame.Raised(chain.Axes[k], Vector3.UnitY));
            Quaternion target = JointFrame.Raised(fold.Direction(k), fold.Face(k));
            Quaternion wanted = Rotation.Multiply(target, Rotation.Inverse(rest));
            turns[k] = chain.Limit(k, Rotation.Multiply(Rotation.Inverse(carried), wanted));
            carried = Rotation.Normalize(Rotation.Multiply(carried, turns[k]));
        }
    }
}
