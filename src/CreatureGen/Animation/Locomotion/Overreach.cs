using System;
using CreatureGen.Animation.Gaits;
using CreatureGen.Maths;

namespace CreatureGen.Animation.Locomotion;

/// <summary>
/// How far the feet of a four-footed body can go in a stance before a hind foot runs into the fore foot of its side: a shorter one the longer the feet and the shorter the trunk is, and
/// the later the fore foot leaves its place before the hind foot comes to it.
/// </summary>
internal static class Overreach
{
    private const int Samples = 48;

    /// <summary>Part of the length of the two feet by which they keep apart: one of them is in the air, with its toes down.</summary>
    private const float FootShare = 0.8f;

    /// <summary>The longest stance, metres; without end for bodies whose hind and fore feet go past each other side by side.</summary>
    public static float LongestStance(LeggedBody body, Gait gait)
    {
        float least = float.MaxValue;
        if (body.Rows != 2)
        {
            return least;
        }

        float duty = gait.Duty.At(gait.Comfortable);
        foreach (LegShape hind in body.Legs)
        {
            foreach (LegShape fore in body.Legs)
            {
                if (hind.Row == 0 && fore.Row == 1 && hind.Side == fore.Side && !hind.Lateral && !fore.Lateral && InOneTrack(hind, fore))
                {
                    float room = fore.Home.Z - hind.Home.Z - (FootShare * (hind.Toe + fore.Heel));
                    least = Math.Min(least, Math.Max(room, 0f) / Nearest(gait, hind, fore, duty));
                }
            }
        }

        return least;
    }

    private static bool InOneTrack(LegShape hind, LegShape fore) => Math.Abs(hind.Home.X - fore.Home.X) < hind.HalfWidth + fore.HalfWidth;

    /// <summary>The most that a hind foot gains on the fore foot, against where they are at rest, stance lengths.</summary>
    private static float Nearest(Gait gait, LegShape hind, LegShape fore, float duty)
    {
        float hindLag = gait.Phases.Lag(0, 2, hind.Side, duty);
        float foreLag = gait.Phases.Lag(1, 2, fore.Side, duty);
        float most = 0.1f;
        for (int i = 0; i < Samples; i++)
        {
            float phase = i / (float)Samples;
            float gain = Along(phase - hindLag, duty) + gait.HindBias - Along(phase - foreLag, duty) - gait.ForeBias;
            most = Math.Max(most, gain);
        }

        return most;
    }

    /// <summary>Where a foot is ahead of the middle of its stance under a body that goes on steadily, stance lengths.</summary>
    private static float Along(float phase, float duty)
    {
        float p = phase - (float)Math.Floor(phase);
        float still = 0.5f - (p / duty);
        return p < duty ? still : still + (FootPoser.Along((p - duty) / (1f - duty)) / duty);
    }
}
