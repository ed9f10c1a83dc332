using System;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Locomotion;

/// <summary>What a standing creature does: it breathes, shifts its weight, sways its tail. By its mass: big ones are slow.</summary>
internal static class IdleLife
{
    /// <summary>Breaths per second of a kilogram; ∝ M^−0.26 (Stahl 1967).</summary>
    private const double BreathAtOneKilogram = 0.9;

    private const float BreathHeight = 0.006f;

    /// <summary>Seconds for which a kilogram stands on one side.</summary>
    private const double ShiftAtOneKilogram = 3;

    private const float ShiftShare = 0.30f;
    private const float ShiftRoll = 0.045f;
    private const float ShiftTime = 0.22f;
    private const float TailSwing = 0.10f;
    private const double TailTempo = 0.45;

    /// <summary>The idle motion at a time.</summary>
    /// <param name="body">Whose.</param>
    /// <param name="seconds">Since the creature came to be.</param>
    /// <param name="activity">0 stands, 1 walks.</param>
    /// <param name="weight">A factor on all of it.</param>
    public static IdlePose At(LeggedBody body, double seconds, float activity, float weight)
    {
        double still = (1 - activity) * weight;
        double breath = Wave(seconds * BreathAtOneKilogram * body.BreathShare) * BreathHeight * body.LegLength * weight * (1 - (0.7 * activity));
        double place = seconds / (ShiftAtOneKilogram * body.ShiftShare);
        double whole = Math.Floor(place);
        double ease = Quintic((place - whole) / ShiftTime);
        bool even = whole % 2 == 0;
        double side = ((2 * ease) - 1) * (even ? 1 : -1);
        double spread = body.Rows > 2 || body.Legs[0].Lateral ? 0.3 : 1;
        double sway = Wave(seconds * TailTempo) * TailSwing * still;
        return new IdlePose((float)breath, (float)(ShiftShare * body.HalfTrack * side * spread * still), (float)(ShiftRoll * side * spread * still), (float)(side * still), (float)sway);
    }

    private static double Wave(double turns) => PortableMath.Sin(PortableMath.Tau * (turns - Math.Floor(turns)));

    private static double Quintic(double x)
    {
        x = Scalar.Clamp(x, 0, 1);
        return x * x * x * (10 + (x * ((6 * x) - 15)));
    }
}
