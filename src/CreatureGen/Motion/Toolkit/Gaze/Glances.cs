using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Toolkit.Gaze;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Where an idle creature looks, as a pure function of time and seed: any moment can be asked for, in any order, on any machine.</summary>
/// <remarks>
/// Time is cut into slots of one period; in each there is one glance, which begins at a random moment of the slot's first 37 %, takes 0.25–0.42 s by x³(10 − 15x + 6x²), and holds until the next.
/// Every fourth glance on average looks straight ahead again.
/// </remarks>
public static class Glances
{
    private const double Jitter = 0.37;
    private const double Shortest = 0.25;
    private const double Longest = 0.42;
    private const double Home = 0.25;

    /// <summary>Where the creature looks.</summary>
    /// <param name="seed">Of this creature's habits, for example <c>new Seed(1).Child("glances")</c>.</param>
    /// <param name="seconds">Any time, also negative.</param>
    /// <param name="settings">How far and how often.</param>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public static LookAngles At(Seed seed, double seconds, in GlanceSettings settings)
    {
        if (!(settings.Period > 0f))
        {
            throw new ArgumentException("settings without a period; expected GlanceSettings.Default or settings made by its constructor", nameof(settings));
        }

        int slot = Slots.At(seconds, settings.Period, out double since);
        Seed now = seed.Child(slot);
        double start = Slots.Number(now, 0) * Jitter * settings.Period;
        double moving = Math.Min(Shortest + (Slots.Number(now, 1) * (Longest - Shortest)), 0.6 * settings.Period);
        double x = Scalar.Clamp((since - start) / moving, 0, 1);
        double t = x * x * x * (10 - (x * (15 - (6 * x))));
        LookAngles from = Of(seed.Child(slot - 1), settings);
        LookAngles to = Of(now, settings);
        return new LookAngles((float)Scalar.Lerp(from.Yaw, to.Yaw, t), (float)Scalar.Lerp(from.Pitch, to.Pitch, t));
    }

    private static LookAngles Of(Seed slot, in GlanceSettings settings)
    {
        if (Slots.Number(slot, 2) < Home)
        {
            return default;
        }

        return new LookAngles((float)((2 * Slots.Number(slot, 3)) - 1) * settings.Yaw, (float)((2 * Slots.Number(slot, 4)) - 1) * settings.Pitch);
    }
}
