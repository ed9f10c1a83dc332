using System;

namespace CreatureGen.Animation.Locomotion;

/// <summary>Sums over some legs of w·cos k m and w·sin k m, k from 1, with m the angle of a leg from the middle of its stance and w its weight.</summary>
internal sealed class PhaseSums
{
    public float[] Cosines { get; } = new float[ForceResponse.Harmonics + 1];

    public float[] Sines { get; } = new float[ForceResponse.Harmonics + 1];

    public void Clear()
    {
        Array.Clear(Cosines, 0, Cosines.Length);
        Array.Clear(Sines, 0, Sines.Length);
    }

    /// <summary>Adds a leg, from the sine and cosine of m.</summary>
    public void Add(float sine, float cosine, float weight)
    {
        float s = weight * sine;
        float c = weight * cosine;
        Cosines[1] += c;
        Sines[1] += s;
        for (int k = 2; k <= ForceResponse.Harmonics; k++)
        {
            float next = (c * cosine) - (s * sine);
            s = (s * cosine) + (c * sine);
            c = next;
            Cosines[k] += c;
            Sines[k] += s;
        }
    }
}
