using System;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Toolkit.Gaze;

/// <summary>How far ears are flicked back, as a pure function of time and seed.</summary>
/// <remarks>One flick of one ear in every slot of time, at a random moment of it; the ear goes in 0.10 s and comes back in 0.22 s, and every third flick on average comes twice.</remarks>
internal static class EarFlicks
{
    private const double Going = 0.10;
    private const double Coming = 0.22;
    private const double Length = Going + Coming;
    private const double Twice = 1.0 / 3;

    /// <summary>How far the ears are flicked, 0..1 each.</summary>
    /// <param name="seed">Of this creature's habits.</param>
    /// <param name="seconds">Any time.</param>
    /// <param name="period">Mean seconds from flick to flick, at least 0.7.</param>
    public static (float Left, float Right) At(Seed seed, double seconds, float period)
    {
        int slot = Slots.At(seconds, period, out double since);
        Seed now = seed.Child(slot);
        double x = since - (Slots.Number(now, 0) * (period - (2 * Length)));
        if (x > Length && Slots.Number(now, 1) < Twice)
        {
            x -= Length;
        }

        float flick = Once(x);
        return flick == 0f ? default : Slots.Number(now, 2) < 0.5 ? (flick, 0f) : (0f, flick);
    }

    /// <summary>How far an ear is in a single flick, so many seconds after it began; 0 before and after it.</summary>
    public static float Once(double seconds) => seconds <= 0 || seconds >= Length
        ? 0f
        : (float)(seconds < Going ? Scalar.Smooth(seconds / Going) : 1 - Scalar.Smooth((seconds - Going) / Coming));
}
