using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Flying;

/// <summary>A pair of thin insect wings: the tip draws a figure of eight, the blade flips at both ends of the stroke, and its outer part lags.</summary>
internal sealed class BuzzPair
{
    private const double StrokeAngle = 0.52;
    private const double Deviation = 0.16;
    private const double Flip = 0.70;
    private const double TipBend = 0.22;
    private const double TipLag = 0.4;
    private const double StrokePlane = 0.25;
    private const double PairLag = 0.25;

    private readonly PairedChain chain;
    private readonly FoldedWing folded;
    private readonly double level;
    private readonly double lag;

    /// <summary>Takes a pair, how it folds, and its place among those of the creature from the front, 0 the first.</summary>
    public BuzzPair(PairedChain chain, FoldedWing folded, int place)
    {
        this.chain = chain;
        this.folded = folded;
        lag = PairLag * place;
        Vector3 axis = chain.Axes[0];

        // The stroke's middle lies a little above level.
        level = 0.30 - PortableMath.Atan2(axis.Y, System.Math.Sqrt(((double)axis.X * axis.X) + ((double)axis.Z * axis.Z)));
    }

    /// <summary>Writes the joints of both sides.</summary>
    public void Write(in Pose local, in WingStroke stroke)
    {
        Write(local, Side.Left, stroke);
        Write(local, Side.Right, stroke);
    }

    private void Write(in Pose local, Side side, in WingStroke stroke)
    {
        double inside = side == Side.Left ? stroke.Steer : -stroke.Steer;
        double a = stroke.Amplitude * (1 - (0.15 * inside));
        double angle = 2 * PortableMath.Pi * (stroke.Phase - lag);
        PortableMath.SinCos(angle, out double sine, out double cosine);
        double raise = level + (a * StrokeAngle * cosine);
        double sweep = a * Deviation * 2 * sine * cosine;
        double twist = a * Flip * sine;
        double bend = a * TipBend * PortableMath.Sin(angle - TipLag);
        double open = Scalar.Smooth(stroke.Spread);
        for (int k = 0; k < chain.Count; k++)
        {
            Quaternion beat = k == 0
                ? Rotation.Multiply(AxisRotation.Pitch(-StrokePlane), chain.Stroke(0, raise, sweep, twist))
                : chain.Stroke(k, bend, 0, 0.3 * twist);
            chain.Write(local, side, k, open >= 1 ? beat : Rotation.Slerp(folded.Turn(k), beat, open));
        }
    }
}
