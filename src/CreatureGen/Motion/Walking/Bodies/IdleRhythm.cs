using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Bodies;

/// <summary>The times of what a standing creature does, by its mass: big ones are slow. All of it begins anew after one period, so that a recording of one closes.</summary>
/// <param name="Period">Seconds in which the weight goes to one side and back.</param>
/// <param name="Breaths">Breaths in a period.</param>
/// <param name="TailSwings">Swings of the tail to and fro in a period.</param>
internal readonly record struct IdleRhythm(double Period, int Breaths, int TailSwings)
{
    /// <summary>Breaths per second of a kilogram; ∝ M^−0.26 (Stahl 1967).</summary>
    private const double BreathAtOneKilogram = 0.9;

    /// <summary>Seconds for which a kilogram stands on one side; ∝ M^0.08.</summary>
    private const double ShiftAtOneKilogram = 2.4;

    /// <summary>Swings of a kilogram's tail per second; ∝ M^−0.08.</summary>
    private const double TailAtOneKilogram = 0.6;

    /// <summary>The rhythm of a mass.</summary>
    /// <param name="mass">Kilograms.</param>
    public static IdleRhythm Of(float mass)
    {
        double period = 2 * ShiftAtOneKilogram * PortableMath.Pow(mass, 0.08);
        return new IdleRhythm(period, Whole(period * BreathAtOneKilogram * PortableMath.Pow(mass, -0.26)), Whole(period * TailAtOneKilogram * PortableMath.Pow(mass, -0.08)));
    }

    private static int Whole(double times) => Math.Max(1, (int)Math.Round(times));
}
