using System;

namespace CreatureGen.Motion.Acts.Data;

/// <summary>How quickly channels go from one phase into the next: who lies down comes through a crouch without a rest there.</summary>
internal static class Passage
{
    /// <summary>How much quicker than in the mean of a phase a channel is at its ends at most: it would come back meanwhile beyond.</summary>
    private const float Quickest = 2f;

    /// <summary>Speed of each channel at the end of each phase, per time unit: 0 where it turns back or stays, and where a phase goes otherwise than smoothly, lasts, takes longer on small bodies, or rolls the body over: what it lies on changes there.</summary>
    /// <param name="phases">Of an act.</param>
    /// <param name="ends">Where channels are at the end of each.</param>
    public static float[][] Speeds(ReadOnlySpan<ActPhase> phases, ReadOnlySpan<float[]> ends)
    {
        var speeds = new float[phases.Length][];
        for (int i = 0; i < speeds.Length; i++)
        {
            speeds[i] = new float[Act.ChannelCount];
            if (i + 1 == speeds.Length || !Passes(phases[i]) || !Passes(phases[i + 1]) || RollsOver(ends, i) || RollsOver(ends, i + 1))
            {
                continue;
            }

            for (int channel = 0; channel < Act.ChannelCount; channel++)
            {
                float start = i == 0 ? 0f : ends[i - 1][channel];
                speeds[i][channel] = Speed(ends[i][channel] - start, phases[i].Duration, ends[i + 1][channel] - ends[i][channel], phases[i + 1].Duration);
            }
        }

        return speeds;
    }

    private static bool RollsOver(ReadOnlySpan<float[]> ends, int phase) => ends[phase][(int)ActChannel.OnFlank] != (phase == 0 ? 0f : ends[phase - 1][(int)ActChannel.OnFlank]);

    private static bool Passes(ActPhase phase) => phase.Ease == ActEase.Smooth && phase.MinSeconds == 0f && !phase.Lasts;

    /// <summary>Between two ways in the same direction the mean of their speeds that never goes past them.</summary>
    /// <remarks>Based on: F. N. Fritsch and J. Butland, "A method for constructing local monotone piecewise cubic interpolants" (1984).</remarks>
    private static float Speed(float way, float time, float next, float nextTime)
    {
        float speed = way / time;
        float nextSpeed = next / nextTime;
        if (!(speed * nextSpeed > 0f))
        {
            return 0f;
        }

        float weight = (2f * nextTime) + time;
        float nextWeight = nextTime + (2f * time);
        float mean = (weight + nextWeight) / ((weight / speed) + (nextWeight / nextSpeed));
        float most = Quickest * Math.Min(Math.Abs(speed), Math.Abs(nextSpeed));
        return Math.Min(Math.Max(mean, -most), most);
    }
}
