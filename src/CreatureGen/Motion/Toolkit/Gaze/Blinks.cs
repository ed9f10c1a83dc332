using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Toolkit;

/// <summary>How far a creature's eyelids are shut, as a pure function of time and seed.</summary>
/// <remarks>One blink in every slot of time, at a random moment of it; lids close in 0.08 s, stay for 0.04 s and open in 0.16 s, and every sixth blink on average comes twice.</remarks>
public static class Blinks
{
    private const double Closing = 0.08;
    private const double Shut = 0.04;
    private const double Opening = 0.16;
    private const double Length = Closing + Shut + Opening;
    private const double Twice = 1.0 / 6;

    /// <summary>0 open, 1 shut.</summary>
    /// <param name="seed">Of this creature's habits, for example <c>new Seed(1).Child("blinks")</c>.</param>
    /// <param name="seconds">Any time, also negative.</param>
    /// <param name="period">Mean seconds from blink to blink, at least 0.6; people 4, dogs 5, cows 9.</param>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    /// <exception cref="ArgumentOutOfRangeException">The period is too short or not finite.</exception>
    public static float At(Seed seed, double seconds, float period)
    {
        Finite.RequireWithin(period, 0.6f, 1e6f, nameof(period));
        int slot = Slots.At(seconds, period, out double since);
        Seed now = seed.Child(slot);
        bool twice = Slots.Number(now, 1) < Twice;
        double start = Slots.Number(now, 0) * (period - (2 * Length));
        double x = since - start;
        if (twice && x > Length)
        {
            x -= Length;
        }

        return Once(x);
    }

    /// <summary>How far lids are shut in a single blink, so many seconds after it began; 0 before and after it.</summary>
    internal static float Once(double seconds) =>
        (float)(seconds < Closing ? Scalar.Smooth(seconds / Closing) : 1 - Scalar.Smooth((seconds - Closing - Shut) / Opening));
}
