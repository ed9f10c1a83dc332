using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>
/// A pair of legs or arms of a swimmer. At speed they lie back along the flanks and bend with these; slow, they hang half folded and paddle by turns; they are spread against the stream to brake, and the inner
/// one to steer.
/// </summary>
/// <remarks>
/// All that a leg does is one way between its spread and its fold (<see cref="LegFold"/>): paddling goes to and fro on it, the joints further out a little later, so that a foot is spread as the leg goes back and
/// trails as it comes forward. Based on: Ashley-Ross and Bechtel, "Kinematics of the transition between aquatic and terrestrial locomotion in the newt Taricha torosa", J. Exp. Biol. 207 (2004): limbs held back along
/// the body while swimming.
/// </remarks>
internal sealed class SwimLeg
{
    private const double Tau = 2 * PortableMath.Pi;

    /// <summary>The joint of the girdle, which does not turn, is 0.</summary>
    private const int Hip = 1;

    /// <summary>How far along the folded leg the flank is that it bends with, tails bending more and more towards their tips, and how much of that it does.</summary>
    private const float Beside = 0.78f;
    private const double Follows = 0.85;

    /// <summary>Slope at which folded legs go down before others, so as to pass below these when the flank between them is hollow.</summary>
    private const double Droop = 0.28;

    /// <summary>Share of the fold at which legs hang when the body stands still.</summary>
    private const double Drift = 0.42;

    /// <summary>Share of the fold that paddling goes to and fro, and how much later each further joint does, radians of the beat.</summary>
    private const double Paddle = 0.26;
    private const double Lag = 0.7;

    /// <summary>How much earlier than a leg the one behind it goes back and forth, radians of the beat: it makes room for it.</summary>
    private const double PairLead = PortableMath.Pi / 2;

    /// <summary>How much less they paddle where the body stands still.</summary>
    private const double Calm = 0.4;

    /// <summary>Paddling in one beat of the tail: odd, so that half a beat later all is its mirror image.</summary>
    private const double PaddlesPerBeat = 3;

    /// <summary>Share of the fold that is left where a leg is spread against the stream.</summary>
    private const double Spread = 0.05;

    /// <summary>How much of spreading the inner leg of the tightest turn does.</summary>
    private const double Steering = 0.45;

    private readonly PairedChain chain;
    private readonly LegFold fold;
    private readonly Quaternion[] spread;
    private readonly int carrier;
    private readonly int beside;
    private readonly double beat;

    private SwimLeg(PairedChain chain, LegFold fold, Quaternion[] spread, int carrier, int beside, double beat)
    {
        this.chain = chain;
        this.fold = fold;
        this.spread = spread;
        this.carrier = carrier;
        this.beside = beside;
        this.beat = beat;
    }

    /// <summary>All legs and arms of a creature that have a counterpart, front to rear.</summary>
    public static SwimLeg[] Of(MotionSubject subject, AxialChain axis)
    {
        List<PairedChain> pairs = PairsOf(subject);
        var legs = new SwimLeg[pairs.Count];
        List<FoldedBone> beside = TrunkOf(subject, axis);
        for (int i = legs.Length - 1; i >= 0; i--)
        {
            PairedChain pair = pairs[i];
            LegFold fold = LegFold.Of(pair, subject, beside, i == legs.Length - 1 ? 0 : Droop);

            // Legs in front of it keep clear of this one too.
            beside.AddRange(fold.Bones);
            int carrier = axis.IndexOf(subject.Skeleton.Parents[pair.Limb.Joints[0]]);
            int bone = axis.BoneAt(Scalar.Lerp(pair.Points[Hip].Z, fold.Tip.Z, Beside));
            legs[i] = new SwimLeg(pair, fold, LegFold.Spread(pair, subject), carrier, bone, PairLead * i);
        }

        return legs;
    }

    private static List<PairedChain> PairsOf(MotionSubject subject)
    {
        var pairs = new List<PairedChain>();
        foreach (LimbChain limb in subject.Limbs)
        {
            if (limb.Kind is LimbKind.Leg or LimbKind.Arm && PairedChain.Of(subject.Skeleton, limb) is { } pair)
            {
                pairs.Add(pair);
            }
        }

        pairs.Sort((a, b) => b.Points[Hip].Z.CompareTo(a.Points[Hip].Z));
        return pairs;
    }

    private static List<FoldedBone> TrunkOf(MotionSubject subject, AxialChain axis)
    {
        var bones = new List<FoldedBone>();
        foreach (CapsuleCollider capsule in subject.Bones)
        {
            int bone = axis.IndexOf(capsule.Joint);
            if (bone >= 0)
            {
                bones.Add(new FoldedBone(bone, capsule, subject.Skeleton.ModelPositions[capsule.Joint], subject.Skeleton.ModelRotations[capsule.Joint]));
            }
        }

        return bones;
    }

    /// <summary>Writes the joints of both sides.</summary>
    /// <param name="local">Receives them.</param>
    /// <param name="stroke">The moment.</param>
    /// <param name="turns">How each bone of the axis lies, in the body's axes.</param>
    public void Write(in Pose local, in SwimStroke stroke, ReadOnlySpan<Quaternion> turns)
    {
        // The flank beside a folded leg heads as the bone there does, seen from the bone that carries the leg.
        Quaternion from = carrier < 0 ? Quaternion.Identity : turns[carrier];
        Quaternion flank = Rotation.Nlerp(Quaternion.Identity, Rotation.Multiply(Rotation.Inverse(from), turns[beside]), Follows * stroke.Trail);
        Write(local, Side.Left, stroke, flank);
        Write(local, Side.Right, stroke, Rotation.Mirror(flank));
    }

    private void Write(in Pose local, Side side, in SwimStroke stroke, Quaternion flank)
    {
        double inside = side == Side.Left ? stroke.Steer : -stroke.Steer;
        double flare = Curve.Either(stroke.Brake, Steering * Curve.Positive(inside));
        double phase = (PaddlesPerBeat * Tau * stroke.Phase) + beat + (side == Side.Left ? 0 : PortableMath.Pi);
        double backing = 1 - (2 * stroke.Back);
        double middle = Scalar.Lerp(Scalar.Lerp(Drift, 1, stroke.Trail), Spread, flare);
        double way = Paddle * (1 - (Calm * stroke.Hover)) * (1 - stroke.Trail) * (1 - flare);
        for (int k = Hip; k < chain.Count; k++)
        {
            double fraction = middle + (way * PortableMath.Cos(phase - (backing * Lag * (k - Hip))));
            Quaternion turn = Rotation.Nlerp(spread[k], fold.Turns[k], fraction);
            chain.Write(local, side, k, k == Hip ? Rotation.Multiply(flank, turn) : turn);
        }
    }
}
