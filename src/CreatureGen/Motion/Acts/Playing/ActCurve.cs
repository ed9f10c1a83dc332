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
        float[] to = act.Ends[phase];
        float[]? from = phase == 0 ? null : act.Ends[phase - 1];
        float fraction = Eased(now.Ease, (float)(at < 1 ? at : 1));
        for (int i = 0; i < values.Length; i++)
        {
            float start = from == null ? 0f : from[i];
            values[i] = start + ((to[i] - start) * fraction);
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
