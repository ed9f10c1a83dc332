using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Toolkit;

/// <summary>Times within clips: what an <see cref="IClip"/> of one's own needs to loop and to stay as those of the library do.</summary>
public static class ClipTime
{
    /// <summary>The time within a clip that a time on the clock of its player means: around again in a clip that loops, both ways; at the end or the beginning in one that stays.</summary>
    /// <param name="time">Seconds, of either sign.</param>
    /// <param name="duration">Of the clip, seconds.</param>
    /// <param name="end">What becomes of the clip at its end.</param>
    /// <exception cref="ArgumentException">The time is not finite.</exception>
    public static float Within(float time, float duration, ClipEnd end)
    {
        Finite.Require(time, nameof(time));
        if (end == ClipEnd.Stays || duration <= 0f)
        {
            return Scalar.Clamp(time, 0f, duration);
        }

        if (time >= 0f && time <= duration)
        {
            return time;
        }

        double within = time - (Math.Floor((double)time / duration) * duration);
        return (float)Scalar.Clamp(within, 0, duration);
    }

    /// <summary>Events of a clip in order, proved to lie within it.</summary>
    internal static ClipEvent[] Ordered(System.Collections.Generic.IReadOnlyList<ClipEvent> events, float duration, string clip)
    {
        var ordered = new ClipEvent[events.Count];
        for (int i = 0; i < ordered.Length; i++)
        {
            ClipEvent next = events[i] ?? throw new ArgumentException(FormattableString.Invariant($"event {i} of clip {clip} is null; expected an event"), nameof(events));
            if (next.Time > duration)
            {
                throw new ArgumentException(FormattableString.Invariant($"event {next.Name} of clip {clip} at {next.Time} s; expected 0 to {duration}"), nameof(events));
            }

            int k = i;
            while (k > 0 && ordered[k - 1].Time > next.Time)
            {
                ordered[k] = ordered[k - 1];
                k--;
            }

            ordered[k] = next;
        }

        return ordered;
    }
}
