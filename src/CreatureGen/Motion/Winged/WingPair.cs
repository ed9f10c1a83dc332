using System;
using System.Collections.Generic;
using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Winged;

/// <summary>A pair of stitched wings: shoulder, elbow, wrist and hand, beating, gliding or folded.</summary>
internal sealed class WingPair
{
    private const int Joints = 4;

    /// <summary>Share of the way from folded to spread from which on a wing is spread.</summary>
    private const double Spread = 1 - 1e-6;

    /// <summary>How far the shoulder is raised half way between folded and spread, radians.</summary>
    private const double FoldLift = 0.45;

    /// <summary>How far spread wings are turned back as they fold, of what they hang beyond the elbow: somewhat farther, or they would hang off the flank with a corner.</summary>
    private const double Flattened = 1.4;

    // Share of a cycle by which each joint is behind the shoulder.
    private static readonly double[] lags = { 0, 0.035, 0.075, 0.12 };

    // How late each joint unfolds, in shares of the whole.
    private static readonly double[] unfolding = { 0, 0.10, 0.2, 0.25 };

    // How far each joint is raised for a wing that is shown, radians.
    private static readonly double[] shown = { 0.5, 0.12, 0.08, 0.05 };

    // How each joint of a wing that is carried on legs is raised, swept back and twisted from how it grew: half closed, and its blade as hung as at rest, or from the front and behind it would be the line of its edge.
    private static readonly double[] carriedRaise = { 0, 0.12, 0.03, 0 };
    private static readonly double[] carriedSweep = { 0.32, -0.05, 0.28, 0.2 };
    private static readonly double[] carriedTwist = { -0.05, 0, 0, 0 };

    /// <summary>How far the shoulder swings up and down, and how far above level the middle of that is with its dihedral taken back, radians.</summary>
    private const double ShoulderBeat = 0.48;
    private const double MiddleOfBeat = 0.10;

    /// <summary>How much farther down the tip goes than the shoulder alone would take it, as an angle at the shoulder, radians.</summary>
    private const double OuterBeat = 0.12;

    private readonly PairedChain chain;
    private readonly FoldedWing folded;
    private readonly double dihedral;
    private readonly double reach;

    public WingPair(PairedChain chain, FoldedWing folded)
    {
        this.chain = chain;
        this.folded = folded;
        Vector3 out2 = chain.Points[2] - chain.Points[0];
        dihedral = PortableMath.Atan2(out2.Y, out2.X);
        reach = Math.Max(Vec.Distance(chain.Points[0], chain.Points[chain.Count]), 1e-6);
    }

    /// <summary>Stitched wings, folded from the rear: those before them lie over them, as tiles do.</summary>
    /// <param name="subject">Whose.</param>
    /// <param name="stitched">Its pairs of wings.</param>
    /// <param name="range">How they fold.</param>
    /// <param name="room">What the body leaves to them; receives those that lie under others.</param>
    public static WingPair[] Folded(MotionSubject subject, IReadOnlyList<PairedChain> stitched, FoldRange range, FoldRoom room)
    {
        int[] order = new int[stitched.Count];
        double[] places = new double[order.Length];
        for (int k = 0; k < order.Length; k++)
        {
            order[k] = k;
            places[k] = stitched[k].Points[0].Z;
        }

        Array.Sort(places, order);
        var wings = new WingPair[order.Length];
        foreach (int k in order)
        {
            FoldedWing folded = FoldedWing.Of(subject, stitched[k], 0, -Flattened * WingForm.OuterIncidence, range, room);
            wings[k] = new WingPair(stitched[k], folded);
            if (order.Length > 1)
            {
                folded.Cover(subject, room);
            }
        }

        return wings;
    }

    /// <summary>Writes the shoulders of both sides as they are folded, each raised off the flank by an angle in radians.</summary>
    public void Rest(in Pose local, float left, float right)
    {
        chain.Write(local, Side.Left, 0, Rotation.Multiply(AxisRotation.Roll(left), folded.Turn(0)));
        chain.Write(local, Side.Right, 0, Rotation.Multiply(AxisRotation.Roll(right), folded.Turn(0)));
    }

    /// <summary>Writes the joints of both sides.</summary>
    public void Write(in Pose local, in WingStroke stroke)
    {
        double lift = WingFloor.Lift(stroke.Altitude + chain.Points[0].Y, reach, ((ShoulderBeat + OuterBeat) * stroke.Amplitude) - MiddleOfBeat - (0.28 * dihedral));
        for (int k = 0; k < chain.Count && k < Joints; k++)
        {
            WingBeat beat = WingBeat.At(stroke.Phase - lags[k]);
            double open = Scalar.Smooth((stroke.Spread - unfolding[k]) / (1 - 0.25));
            if (k > 0)
            {
                chain.Draw(local, k, Scalar.Lerp(folded.LengthOf(k - 1), 1f, (float)open));
            }

            // Straight ahead both wings lie alike: what costs most of a wing is found once.
            bool alike = stroke.Steer == 0 && stroke.LiftLeft == stroke.LiftRight;
            Quaternion left = Turn(Side.Left, k, beat, stroke, open, k == 0 ? lift : 0);
            Quaternion right = alike ? left : Turn(Side.Right, k, beat, stroke, open, k == 0 ? lift : 0);
            chain.Write(local, Side.Left, k, left);
            chain.Write(local, Side.Right, k, right);
        }
    }

    /// <summary>How a joint is turned, of the wing of a side as if it were the left one.</summary>
    private Quaternion Turn(Side side, int k, in WingBeat beat, in WingStroke stroke, double open, double lift)
    {
        double inside = side == Side.Left ? stroke.Steer : -stroke.Steer;
        Beating(k, beat, stroke, inside, out double raise, out double sweep, out double twist);
        if (stroke.Glide > 0)
        {
            Gliding(k, stroke, inside, out double glideRaise, out double glideSweep, out double glideTwist);
            raise = Scalar.Lerp(raise, glideRaise, stroke.Glide);
            sweep = Scalar.Lerp(sweep, glideSweep, stroke.Glide);
            twist = Scalar.Lerp(twist, glideTwist, stroke.Glide);
        }

        if (stroke.Carried > 0)
        {
            raise = Scalar.Lerp(raise, carriedRaise[k], stroke.Carried);
            sweep = Scalar.Lerp(sweep, carriedSweep[k], stroke.Carried);
            twist = Scalar.Lerp(twist, carriedTwist[k], stroke.Carried);
        }

        Quaternion spread = chain.Stroke(k, raise + (0.5 * lift * (1 - beat.Height)) + (shown[k] * stroke.Shown), sweep, twist);
        if (open < Spread)
        {
            spread = Rotation.Slerp(folded.Turn(k), spread, open);
        }

        if (k == 0 && (open < Spread || stroke.Carried > 0))
        {
            // On the way the shoulder is raised, so that the tip does not sweep over the ground. What does not fly swings with the body.
            double square = open * open;
            double swinging = 1 - (square * square * (1 - stroke.Carried));
            spread = Rotation.Multiply(AxisRotation.Roll((4 * FoldLift * open * (1 - open)) + (swinging * (side == Side.Left ? stroke.LiftLeft : stroke.LiftRight))), spread);
        }

        return spread;
    }

    private void Beating(int joint, in WingBeat b, in WingStroke stroke, double inside, out double raise, out double sweep, out double twist)
    {
        double a = stroke.Amplitude * (1 - (0.12 * inside));
        switch (joint)
        {
            case 0:
                raise = (-0.72 * dihedral) + MiddleOfBeat + (ShoulderBeat * a * b.Height) - (0.05 * inside);
                sweep = -0.06 + (a * ((-0.16 * b.Sine) + (0.18 * b.Up))) - (0.22 * stroke.Flare);
                twist = WingForm.RestIncidence + (a * ((0.10 * b.Down) - (0.16 * b.Up))) - (0.30 * stroke.Flare);
                break;
            case 1:
                raise = a * ((0.10 * b.Height) - (0.10 * b.Up));
                sweep = a * -0.34 * b.Up;
                twist = WingForm.OuterIncidence + (a * ((0.05 * b.Down) - (0.10 * b.Up)));
                break;
            case 2:
                raise = a * ((0.09 * b.Height) - (0.34 * b.Up) + (0.06 * b.Down));
                sweep = 0.06 + (a * 0.72 * b.Up) + (0.10 * inside);
                twist = a * ((0.12 * b.Down) - (0.18 * b.Up));
                break;
            default:
                raise = a * ((-0.22 * b.Up) + (0.16 * b.Down));
                sweep = a * 0.34 * b.Up;
                twist = a * 0.10 * (b.Down - b.Up);
                break;
        }
    }

    private void Gliding(int joint, in WingStroke stroke, double inside, out double raise, out double sweep, out double twist)
    {
        switch (joint)
        {
            case 0:
                raise = (-0.55 * dihedral) - 0.02 + (0.02 * stroke.Drift) - (0.06 * inside);
                sweep = -0.05 - (0.25 * stroke.Flare);
                twist = WingForm.RestIncidence + 0.03 - (0.35 * stroke.Flare);
                break;
            case 1:
                raise = -0.10 * dihedral;
                sweep = 0.12;
                twist = WingForm.OuterIncidence;
                break;
            case 2:
                raise = -0.20 * dihedral;
                sweep = 0.16 + (0.12 * inside);
                twist = -0.02;
                break;
            default:
                raise = 0.08;
                sweep = 0.05;
                twist = -0.02 - (0.05 * inside);
                break;
        }
    }
}
