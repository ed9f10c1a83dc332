using System;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Acts.Playing;

/// <summary>Phases of an act up to its last in one go: channels pass where each of them ends without a rest there, and rest only where they turn back, at the beginning and at the end. Immutable.</summary>
internal sealed class ActFlow
{
    private readonly double[] knots;
    private readonly double[][] values;
    private readonly double[][] slopes;

    /// <param name="act">The act; what swings in these phases is left out.</param>
    /// <param name="first">Index of the first of them, above 0.</param>
    /// <param name="gain">Factor on what the body does.</param>
    public ActFlow(Act act, int first, ActGain gain)
    {
        ReadOnlySpan<ActPhase> phases = act.AllPhases;
        knots = new double[phases.Length - first + 1];
        for (int i = 1; i < knots.Length; i++)
        {
            knots[i] = knots[i - 1] + phases[first + i - 1].Duration;
        }

        values = new double[Act.ChannelCount][];
        slopes = new double[Act.ChannelCount][];
        for (int channel = 0; channel < values.Length; channel++)
        {
            values[channel] = new double[knots.Length];
            slopes[channel] = new double[knots.Length];
            for (int i = 0; i < knots.Length; i++)
            {
                values[channel][i] = act.Ends[first + i - 1][channel] * gain.Of((ActChannel)channel);
            }

            MonotoneCubic.Slopes(knots, values[channel], slopes[channel]);
            slopes[channel][0] = slopes[channel][^1] = 0;
        }
    }

    /// <summary>How long they take, times √(leg length / gravity).</summary>
    public float Duration => (float)knots[^1];

    /// <summary>Writes all channels.</summary>
    /// <param name="at">Part of the time, 0..1.</param>
    /// <param name="written">Receives a value for each channel.</param>
    public void Write(double at, float[] written)
    {
        for (int channel = 0; channel < written.Length; channel++)
        {
            written[channel] = (float)MonotoneCubic.Evaluate(knots, values[channel], slopes[channel], at * knots[^1]);
        }
    }
}
