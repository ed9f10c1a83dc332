using CreatureGen.Maths;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Where the channels of an act are at a place in it.</summary>
internal static class ActCurve
{
    /// <summary>Writes all channels.</summary>
    /// <param name="act">The act.</param>
    /// <param name="phase">Which of its phases.</param>
    /// <param name="at">Place in the phase, 0..1; of phases that last, beyond.</param>
    /// <param name="gain">Factor on what the body does.</param>
    /// <param name="values">Receives a value for each channel.</param>
    public static void Write(Act act, int phase, double at, ActGain gain, float[] values)
    {
        ActPhase now = act.AllPhases[phase];
        for (int i = 0; i < values.Length; i++)
        {
            values[i] = At(act, phase, (float)(at < 1 ? at : 1), i);
        }

        foreach (ActWave wave in now.AllWaves)
        {
            values[(int)wave.Channel] += wave.At(at, now.Lasts);
        }

        for (int i = 0; i < values.Length; i++)
        {
            values[i] *= gain.Of((ActChannel)i);
        }
    }

    /// <summary>Where a channel is that goes on through the ends of phases, and follows late, from the phase before where it must.</summary>
    private static float At(Act act, int phase, float at, int channel)
    {
        float into = (at * act.AllPhases[phase].Duration) - Overlap.Of((ActChannel)channel, act.Kind);
        while (into < 0f && phase > 0)
        {
            phase--;
            if (act.AllPhases[phase].Lasts)
            {
                return act.Ends[phase][channel];
            }

            into += act.AllPhases[phase].Duration;
        }

        float end = act.Ends[phase][channel];
        float start = phase == 0 ? 0f : act.Ends[phase - 1][channel];
        if (start == end || into <= 0f)
        {
            return start;
        }

        ActPhase now = act.AllPhases[phase];
        float x = into / now.Duration;
        float value = start + ((end - start) * Eased(now.Ease, x));
        float speed = act.Speeds[phase][channel];
        float speedBefore = phase == 0 ? 0f : act.Speeds[phase - 1][channel];
        return speed == 0f && speedBefore == 0f ? value : value + (now.Duration * ((speedBefore * Begins(x)) + (speed * Ends(x))));
    }

    /// <summary>What a speed at the beginning adds to a smooth phase, over the phase's time: x − 6x³ + 8x⁴ − 3x⁵.</summary>
    private static float Begins(float x) => x + (x * x * x * (-6f + (x * (8f - (3f * x)))));

    /// <summary>The same at its end: −4x³ + 7x⁴ − 3x⁵.</summary>
    private static float Ends(float x) => x * x * x * (-4f + (x * (7f - (3f * x))));

    private static float Eased(ActEase ease, float x)
    {
        float left = 1f - x;
        return ease switch
        {
            ActEase.In => x * x,
            ActEase.Out => 1f - (left * left * left),
            ActEase.Over => 1f - (2.4f * left * left * left) + (1.4f * left * left),
            _ => Scalar.Smoother(x),
        };
    }
}
