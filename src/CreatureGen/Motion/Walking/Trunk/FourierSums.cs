using System;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>
/// Sums over some legs of w·cos k m and w·sin k m, k from 1, with m the angle of a leg from the middle of its stance and w its weight. Legs are added as they are at the beginning of the cycle, as often as the gait
/// changes; the place in the cycle turns all of them alike.
/// </summary>
internal sealed class FourierSums
{
    private readonly float[] firstCosines = new float[ForceResponse.Harmonics + 1];
    private readonly float[] firstSines = new float[ForceResponse.Harmonics + 1];

    public float[] Cosines { get; } = new float[ForceResponse.Harmonics + 1];

    public float[] Sines { get; } = new float[ForceResponse.Harmonics + 1];

    /// <summary>√(cosine² + sine²): the same all through the cycle.</summary>
    public float[] Amplitudes { get; } = new float[ForceResponse.Harmonics + 1];

    public void Clear()
    {
        Array.Clear(firstCosines, 0, firstCosines.Length);
        Array.Clear(firstSines, 0, firstSines.Length);
        Array.Clear(Amplitudes, 0, Amplitudes.Length);
    }

    /// <summary>Adds a leg, from the sine and cosine of m at the beginning of the cycle.</summary>
    public void Add(float sine, float cosine, float weight)
    {
        float s = weight * sine;
        float c = weight * cosine;
        for (int k = 1; k <= ForceResponse.Harmonics; k++)
        {
            float x = firstCosines[k] += c;
            float y = firstSines[k] += s;
            Amplitudes[k] = (float)Math.Sqrt((x * x) + (y * y));
            (c, s) = ((c * cosine) - (s * sine), (s * cosine) + (c * sine));
        }
    }

    /// <summary>Goes to a place in the cycle, from the sine and cosine of its angle.</summary>
    public void Turn(float sine, float cosine)
    {
        float s = sine;
        float c = cosine;
        for (int k = 1; k <= ForceResponse.Harmonics; k++)
        {
            Cosines[k] = (firstCosines[k] * c) - (firstSines[k] * s);
            Sines[k] = (firstSines[k] * c) + (firstCosines[k] * s);
            (c, s) = ((c * cosine) - (s * sine), (s * cosine) + (c * sine));
        }
    }

    /// <summary>How much of a number of equal terms fall together, 0..1.</summary>
    public float Together(int terms) => Math.Max(0f, (2f * ((Cosines[1] * Cosines[1]) + (Sines[1] * Sines[1])) / (terms * terms)) - 1f);
}
