using System.Numerics;
using CreatureGen.Anatomy;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Chains;
using CreatureGen.Rigging;

namespace CreatureGen.Motion.Swimming;

/// <summary>A pair of fins on the flanks: it trims, brakes and sculls on a body that swims with its tail, and drives one that swims with flippers.</summary>
internal sealed class SwimFin
{
    private const double Tau = 2 * PortableMath.Pi;

    /// <summary>How far flippers are raised, drawn forward and turned edge on to push off, radians; they come down, back and flat by half of that.</summary>
    private const double PushRaise = 0.5;
    private const double PushDraw = 0.55;
    private const double PushTurn = 0.6;

    private readonly PairedChain chain;
    private readonly bool fore;

    public SwimFin(PairedChain chain, double along)
    {
        this.chain = chain;
        fore = along < 0.5;
    }

    /// <summary>From top to bottom of the tip's way when it flies under water at cruise, metres: of each bone the sine of its greatest angle.</summary>
    public double TipWay => 2 * (fore ? 1 : 0.64) * ((0.52 * chain.Limb.RestLengths[0]) + (chain.Count > 1 ? 0.66 * chain.Limb.RestLengths[1] : 0));

    /// <summary>Writes the joints of both sides.</summary>
    public void Write(in Pose local, SwimStyle style, in SwimStroke stroke)
    {
        Write(local, Side.Left, style, stroke);
        Write(local, Side.Right, style, stroke);
    }

    private void Write(in Pose local, Side side, SwimStyle style, in SwimStroke stroke)
    {
        // Towards this side a turn is positive.
        double inside = side == Side.Left ? stroke.Steer : -stroke.Steer;
        FinAngles angles = style == SwimStyle.Flippers ? Flipper(stroke, inside)
            : style == SwimStyle.Cetacean ? Rudder(stroke, inside)
            : Scull(stroke, inside, side);
        chain.Write(local, side, 0, chain.Stroke(0, angles.Raise, angles.Sweep, angles.Twist));
        for (int k = 1; k < chain.Count; k++)
        {
            chain.Write(local, side, k, chain.Stroke(k, angles.TipRaise, angles.TipSweep, 0.4 * angles.Twist));
        }
    }

    /// <summary>Fins of fish: swept back at speed, sculling in turn when standing still, spread against the stream to brake, the inner one spread to steer.</summary>
    private FinAngles Scull(in SwimStroke stroke, double inside, Side side)
    {
        double size = fore ? 1 : 0.6;
        double beat = (Tau * stroke.Phase) + (side == Side.Left ? 0 : PortableMath.Pi) - (fore ? 0 : 1.2);
        double row = (2 * Tau * stroke.Phase) + (side == Side.Left ? 0 : PortableMath.Pi) - (fore ? 0 : 1.2);
        double still = stroke.Hover;
        double moving = 1 - still;
        double flare = Curve.Either(stroke.Brake, 0.7 * Curve.Positive(inside));
        PortableMath.SinCos(row, out double rowSine, out double rowCosine);
        PortableMath.SinCos(beat, out double beatSine, out double beatCosine);
        double backing = 1 - (2 * stroke.Back);
        return new FinAngles
        {
            Raise = size * ((0.10 * moving * beatSine) + (still * ((0.22 * rowSine) - 0.05)) - (0.15 * flare)),
            Sweep = (moving * (0.22 + (0.32 * stroke.Fast) + (0.03 * beatCosine))) + (size * still * (0.05 + (0.30 * rowCosine))) - (0.50 * flare),
            Twist = size * ((0.12 * moving * ((beatSine * 0.54) + (beatCosine * 0.84))) + (0.45 * still * rowSine * backing) - (0.75 * flare) - (0.35 * stroke.Rise)),
            TipRaise = size * ((0.12 * moving * PortableMath.Sin(beat - 0.8)) + (0.20 * still * PortableMath.Sin(row - 0.9))),
            TipSweep = size * ((0.18 * still * PortableMath.Cos(row - 0.8)) + (0.1 * stroke.Fast) - (0.15 * flare)),
        };
    }

    /// <summary>Flippers of whales: planes that hold the course, and paddle gently when still.</summary>
    private FinAngles Rudder(in SwimStroke stroke, double inside)
    {
        double size = fore ? 1 : 0.6;
        PortableMath.SinCos((Tau * stroke.Phase) - 0.7, out double sine, out double cosine);
        double still = stroke.Hover;
        double flare = Curve.Either(stroke.Brake, 0.5 * Curve.Positive(inside));
        return new FinAngles
        {
            Raise = size * ((0.07 * stroke.Amplitude * sine) + (0.16 * still * sine) + (0.12 * inside) - (0.2 * flare)),
            Sweep = (0.16 * (1 - still)) + (0.25 * stroke.Fast) + (0.14 * still * cosine) - (0.45 * flare),
            Twist = size * ((0.08 * cosine) + (0.22 * still * cosine) - (0.30 * stroke.Rise) - (0.55 * flare)),
            TipRaise = size * 0.12 * (stroke.Amplitude + still) * PortableMath.Sin((Tau * stroke.Phase) - 1.6),
            TipSweep = 0.05,
        };
    }

    /// <summary>Flippers that drive: under water they fly, up and down with the leading edge turned into the stroke; at low speed they row, back flat against the water and forward edge on.</summary>
    private FinAngles Flipper(in SwimStroke stroke, double inside)
    {
        double lag = fore ? 0 : 0.4 * Tau;
        double size = (fore ? 1 : 0.64) * Scalar.Lerp(stroke.Amplitude, 0.5 + (0.5 * stroke.Amplitude), stroke.Hover) * (1 + (0.25 * Curve.Positive(-inside)) - (0.6 * Curve.Positive(inside)));
        PortableMath.SinCos((Tau * stroke.Phase) - lag, out double sine, out double cosine);
        double power = Scalar.Smooth(0.5 + (0.5 * sine));
        double rowing = stroke.Hover;
        double flying = 1 - rowing;
        double backing = 1 - (2 * stroke.Back);
        double tip = PortableMath.Cos((Tau * stroke.Phase) - lag - 0.9);
        double flare = stroke.Brake;
        double push = (fore ? 1 : 0.64) * stroke.Push;
        return new FinAngles
        {
            Raise = (size * ((flying * 0.55 * cosine) - (rowing * 0.16 * sine))) - 0.05 - (0.1 * flare) + (0.1 * inside) + (PushRaise * push),
            Sweep = (size * ((flying * 0.16 * sine) - (rowing * backing * 0.42 * cosine))) + 0.05 - (0.45 * flare) - (PushDraw * push),
            Twist = (size * ((flying * 0.50 * sine) - (rowing * ((0.9 * power) - 0.25)))) - (0.5 * flare) - (0.25 * stroke.Rise * (fore ? 1 : -1)) + (PushTurn * push),
            TipRaise = size * ((flying * 0.34 * tip) + (rowing * 0.1 * tip)),
            TipSweep = -size * rowing * 0.22 * sine,
        };
    }

    private struct FinAngles
    {
        public double Raise;
        public double Sweep;
        public double Twist;
        public double TipRaise;
        public double TipSweep;
    }
}
