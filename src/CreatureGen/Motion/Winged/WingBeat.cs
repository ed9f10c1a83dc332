using CreatureGen.Maths;

namespace CreatureGen.Motion.Winged;

/// <summary>Where a joint of a wing is in its beat: height c (1 at the top, −1 at the bottom), and how far it is in the downstroke and in the upstroke.</summary>
internal readonly struct WingBeat
{
    // Downstroke 56 % of the cycle: 2πp + a(1 − cos 2πp) is π there. The angle runs on smoothly, so the turning points have no kink.
    private const double Warp = -0.1954;

    /// <summary>By how much down- and upstroke reach into each other, as part of the sine: joints of the wing bend and stretch the more gently.</summary>
    private const double Early = 0.45;

    private WingBeat(double height, double sine, double down, double up)
    {
        Height = height;
        Sine = sine;
        Down = down;
        Up = up;
    }

    /// <summary>1 at the top, −1 at the bottom.</summary>
    public double Height { get; }

    /// <summary>Positive going down, negative going up.</summary>
    public double Sine { get; }

    /// <summary>0..1 in the downstroke, 0 in most of the upstroke.</summary>
    public double Down { get; }

    /// <summary>0..1 in the upstroke, 0 in most of the downstroke.</summary>
    public double Up { get; }

    /// <summary>Angle in the beat at a phase in cycles: 0 at the top, π at the bottom.</summary>
    public static double Angle(double phase) => (2 * PortableMath.Pi * phase) + (Warp * (1 - PortableMath.Cos(2 * PortableMath.Pi * phase)));

    /// <summary>The beat at a phase in cycles.</summary>
    public static WingBeat At(double phase)
    {
        PortableMath.SinCos(Angle(phase), out double sine, out double cosine);
        return new WingBeat(cosine, sine, Ease(sine), Ease(-sine));
    }

    /// <summary>Rises from 0 without a kink, somewhat before the turning point, and reaches 1 at 1.</summary>
    private static double Ease(double sine)
    {
        double x = (sine + Early) / (1 + Early);
        return x <= 0 ? 0 : x * x * (2 - x);
    }
}
