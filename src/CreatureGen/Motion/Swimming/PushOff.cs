using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Swimming;

/// <summary>
/// How a swimmer leaves out of rest. Fish curl up to one side and strike back to the other, as in a C-start but less and straight ahead; whales raise their flukes and bring them down; flippers and discs are drawn
/// up and beat down together. Then the wave takes over.
/// </summary>
/// <remarks>
/// The clock is that of <see cref="EscapeCurve"/>; how hard it pushes follows what is asked, so that a stick may be pushed slowly.
/// Based on: Webb, "The effect of size on the fast-start performance of rainbow trout", J. Exp. Biol. 65 (1976): two strokes, then steady swimming.
/// </remarks>
internal struct PushOff
{
    /// <summary>Cruises below which it leaves out of rest, and those that have to be missing.</summary>
    private const double RestSpeed = 0.3;
    private const double LeastGap = 0.1;

    /// <summary>With which it follows how hard it works, in stages.</summary>
    private const double Sharpness = 4;

    private double age;
    private double side;
    private CriticallyDampedSpring hardness;

    /// <summary>1 with the body curled up to the left (the tail raised, flippers up), negative as it strikes back.</summary>
    public readonly double Bend => side * hardness.Value * EscapeCurve.Bend(age);

    /// <summary>How much of the swimming wave is left.</summary>
    public readonly double Wave => side == 0 ? 1 : 1 - (hardness.Value * (1 - EscapeCurve.Wave(age)));

    /// <summary>Moves on.</summary>
    /// <param name="hard">How hard it works to get faster, 0..1.</param>
    /// <param name="missing">Cruises that it is to be faster by.</param>
    /// <param name="cruises">How fast it goes.</param>
    /// <param name="towards">1 or −1: the side to which it curls up if it begins now.</param>
    /// <param name="stages">By which it moves on.</param>
    public void Step(double hard, double missing, double cruises, double towards, double stages)
    {
        if (side == 0 && missing > LeastGap && Math.Abs(cruises) < RestSpeed)
        {
            side = towards;
            age = 0;
        }

        hardness.Step(hard, Sharpness, stages);
        age = side == 0 ? 0 : age + stages;
        side = age < EscapeCurve.Duration ? side : 0;
    }
}
