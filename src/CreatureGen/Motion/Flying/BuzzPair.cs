using System;
using System.Numerics;
using CreatureGen.Anatomy.Wings;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Motion.Winged;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>A pair of thin insect wings: the tip draws a figure of eight, the blade flips at both ends of the stroke, and its outer part lags.</summary>
internal sealed class BuzzPair
{
    private const double StrokeAngle = 0.64;
    private const double MiddleOfBeat = 0.42;
    private const double Deviation = 0.16;
    private const double Flip = 0.70;
    private const double TipBend = 0.22;
    private const double TipLag = 0.4;

    /// <summary>How much wider the outer wing beats in the tightest turn.</summary>
    private const double Steering = 0.15;

    /// <summary>How far the top of the stroke lies behind its bottom, radians: the more the slower it flies, until wings beat to and fro. Hind wings have the body in their way.</summary>
    private const double StrokePlane = 0.25;
    private const double HoverPlane = 0.85;
    private const double HindHoverPlane = 0.5;

    /// <summary>Share of a beat by which narrow and broad hind wings are behind the fore wings: broad ones are hooked to these.</summary>
    private const double NarrowLag = 0.25;
    private const double BroadLag = 0.03;

    /// <summary>How far wings are raised that are shown, radians.</summary>
    private const double Shown = 0.3;

    private readonly PairedChain chain;
    private readonly FoldedWing folded;
    private readonly double level;
    private readonly double lag;
    private readonly double plane;
    private readonly double incidence;
    private readonly double reach;

    /// <summary>Takes a pair, how it folds, its place among those of the creature from the front, 0 the first, and how broad the wings are, 0..1.</summary>
    public BuzzPair(PairedChain chain, FoldedWing folded, int place, double breadth)
    {
        this.chain = chain;
        this.folded = folded;
        lag = Scalar.Lerp(NarrowLag, BroadLag, breadth) * place;
        plane = place == 0 ? HoverPlane : HindHoverPlane;
        Vector3 axis = chain.Axes[0];
        incidence = ThinWingBlade.RestIncidence(axis);

        // The stroke's middle lies a little above level.
        reach = Math.Max(Vec.Distance(chain.Points[0], chain.Points[chain.Count]), 1e-6);
        level = MiddleOfBeat - PortableMath.Atan2(axis.Y, Math.Sqrt(((double)axis.X * axis.X) + ((double)axis.Z * axis.Z)));
    }

    /// <summary>Fastest that a wing turns at its root for each radian of its beat and a width of 1: as it goes through the middle of its stroke or flips.</summary>
    public static double FastestBlade { get; } = Math.Sqrt(Math.Max(StrokeAngle * StrokeAngle, Flip * Flip) + (4 * Deviation * Deviation));

    /// <summary>Factor on the width of the beat of the wing outside of a turn, at most.</summary>
    public const double WidestSteer = 1 + Steering;

    /// <summary>Writes the joints of both sides.</summary>
    public void Write(in Pose local, in WingStroke stroke)
    {
        Write(local, Side.Left, stroke);
        Write(local, Side.Right, stroke);
    }

    private void Write(in Pose local, Side side, in WingStroke stroke)
    {
        double inside = side == Side.Left ? stroke.Steer : -stroke.Steer;
        double a = stroke.Amplitude * (1 - (Steering * inside));
        double angle = 2 * PortableMath.Pi * (stroke.Phase - lag);
        PortableMath.SinCos(angle, out double sine, out double cosine);
        double lift = WingFloor.Lift(stroke.Altitude + chain.Points[0].Y, reach, (a * StrokeAngle) - MiddleOfBeat);
        double raise = level + (0.5 * lift * (1 - cosine)) + (Shown * stroke.Shown) + (a * StrokeAngle * cosine);
        double sweep = a * Deviation * 2 * sine * cosine;
        double twist = a * Flip * sine;
        double bend = a * TipBend * PortableMath.Sin(angle - TipLag);
        double open = Scalar.Smooth(stroke.Spread);
        for (int k = 0; k < chain.Count; k++)
        {
            Quaternion beat = k == 0
                ? Rotation.Multiply(AxisRotation.Pitch(-Scalar.Lerp(StrokePlane, plane, stroke.Hover)), chain.Stroke(0, raise, sweep, twist - incidence))
                : chain.Stroke(k, bend, 0, 0.3 * twist);
            chain.Write(local, side, k, open >= 1 ? beat : Rotation.Slerp(folded.Turn(k), beat, open));
        }
    }
}
