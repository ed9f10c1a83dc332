using System;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>
/// Sums over some legs of w·cos k m and w·sin k m, k from 1, with m the angle of a leg from the middle of its stance and w its weight. Legs are added as they are at the beginning of the cycle, as often as the gait
/// changes; the place in the cycle turns all of them alike.
/// </summary>
/// <remarks>All numbers of a harmonic lie side by side in one array: in a crowd what is not in the caches costs more than the sums.</remarks>
internal sealed class FourierSums
{
    private readonly Harmonic[] harmonics = new Harmonic[ForceResponse.Harmonics + 1];

    /// <summary>The sums of each harmonic; the first of the list is of none.</summary>
    public ReadOnlySpan<Harmonic> Harmonics => harmonics;

    public void Clear() => Array.Clear(harmonics, 0, harmonics.Length);

    /// <summary>Adds a leg, from the sine and cosine of m at the beginning of the cycle.</summary>
    public void Add(float sine, float cosine, float weight)
    {
        float s = weight * sine;
        float c = weight * cosine;
        for (int k = 1; k < harmonics.Length; k++)
        {
            ref Harmonic harmonic = ref harmonics[k];
            float x = harmonic.FirstCosine += c;
            float y = harmonic.FirstSine += s;
            harmonic.Amplitude = (float)Math.Sqrt((x * x) + (y * y));
            (c, s) = ((c * cosine) - (s * sine), (s * cosine) + (c * sine));
        }
    }

    /// <summary>Goes to a place in the cycle, from the sine and cosine of its angle.</summary>
    public void Turn(float sine, float cosine)
    {
        float s = sine;
        float c = cosine;
        for (int k = 1; k < harmonics.Length; k++)
        {
            ref Harmonic harmonic = ref harmonics[k];
            harmonic.Cosine = (harmonic.FirstCosine * c) - (harmonic.FirstSine * s);
            harmonic.Sine = (harmonic.FirstSine * c) + (harmonic.FirstCosine * s);
            (c, s) = ((c * cosine) - (s * sine), (s * cosine) + (c * sine));
        }
    }

    /// <summary>How much of a number of equal terms fall together, 0..1.</summary>
    public float Together(int terms)
    {
        Harmonic first = harmonics[1];
        return Math.Max(0f, (2f * ((first.Cosine * first.Cosine) + (first.Sine * first.Sine)) / (terms * terms)) - 1f);
    }

    /// <summary>The sums of one harmonic.</summary>
    public struct Harmonic
    {
        /// <summary>Σ w·cos k m at the beginning of the cycle.</summary>
        public float FirstCosine;

        /// <summary>Σ w·sin k m there.</summary>
        public float FirstSine;

        /// <summary>Σ w·cos k m now.</summary>
        public float Cosine;

        /// <summary>Σ w·sin k m now.</summary>
        public float Sine;

        /// <summary>√(cosine² + sine²): the same all through the cycle.</summary>
        public float Amplitude;
    }
}
