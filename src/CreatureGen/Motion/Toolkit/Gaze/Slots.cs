using System;
using CreatureGen.Seeding;

namespace CreatureGen.Motion.Toolkit.Gaze;

/// <summary>Time cut into slots of equal length, each with random numbers of its own.</summary>
internal static class Slots
{
    /// <summary>The slot of a time and how long it has lasted. Slot numbers wrap round after 2³² slots.</summary>
    public static int At(double seconds, double period, out double since)
    {
        if (!(Math.Abs(seconds) <= 1e15))
        {
            throw new ArgumentException(FormattableString.Invariant($"a time of {seconds} s; expected a finite number"), nameof(seconds));
        }

        double slot = Math.Floor(seconds / period);
        since = Math.Max(0, seconds - (slot * period));
        return unchecked((int)(long)slot);
    }

    /// <summary>A number 0..1, 1 excluded, of a slot.</summary>
    public static double Number(Seed slot, int index) => (slot.Child(index).Value >> 11) * (1.0 / 9007199254740992.0);
}
