using System;
using System.Numerics;
using System.Runtime.CompilerServices;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>
/// Sums over some legs of w·cos k m and w·sin k m, k from 1, with m the angle of a leg from the middle of its stance and w its weight, for four weights at once. Legs are added as they are at the beginning of the cycle,
/// as often as the gait changes; the place in the cycle turns all of them alike.
/// </summary>
/// <remarks>Four sums side by side cost little more than one. All numbers of a harmonic lie in one array: in a crowd what is not in the caches costs more than the sums.</remarks>
internal sealed class FourierSums
{
    private readonly Harmonic[] harmonics = new Harmonic[ForceResponse.Harmonics + 1];

    /// <summary>The sums of each harmonic; the first of the list is of none.</summary>
    public ReadOnlySpan<Harmonic> Harmonics => harmonics;

    /// <summary>Asks memory for the sums over the legs.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch() => MemoryLines.Touch(harmonics, ForceResponse.Harmonics + 1);

    public void Clear() => Array.Clear(harmonics, 0, harmonics.Length);

    /// <summary>Adds a leg, from the sine and cosine of m at the beginning of the cycle.</summary>
    public void Add(float sine, float cosine, Vector4 weights)
    {
        Vector4 s = weights * sine;
        Vector4 c = weights * cosine;
        for (int k = 1; k < harmonics.Length; k++)
        {
            ref Harmonic harmonic = ref harmonics[k];
            Vector4 x = harmonic.FirstCosine += c;
            Vector4 y = harmonic.FirstSine += s;
            Vector4 squares = (x * x) + (y * y);
            harmonic.Amplitude = new Vector4((float)Math.Sqrt(squares.X), (float)Math.Sqrt(squares.Y), (float)Math.Sqrt(squares.Z), (float)Math.Sqrt(squares.W));
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
            Vector4 x = harmonic.FirstCosine;
            Vector4 y = harmonic.FirstSine;

            // Numbers in all four places: an operator that takes one is a call in browsers.
            var cosines = new Vector4(c);
            var sines = new Vector4(s);
            harmonic.Cosine = (x * cosines) - (y * sines);
            harmonic.Sine = (y * cosines) + (x * sines);
            (c, s) = ((c * cosine) - (s * sine), (s * cosine) + (c * sine));
        }
    }

    /// <summary>How much of a number of equal terms fall together, 0..1.</summary>
    /// <param name="cosine">Their sum of cosines, of the first harmonic.</param>
    /// <param name="sine">Their sum of sines.</param>
    /// <param name="terms">How many there are.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static float Together(float cosine, float sine, int terms) => Math.Max(0f, (2f * ((cosine * cosine) + (sine * sine)) / (terms * terms)) - 1f);

    /// <summary>The sums of one harmonic.</summary>
    public struct Harmonic
    {
        /// <summary>Σ w·cos k m at the beginning of the cycle.</summary>
        public Vector4 FirstCosine;

        /// <summary>Σ w·sin k m there.</summary>
        public Vector4 FirstSine;

        /// <summary>Σ w·cos k m now.</summary>
        public Vector4 Cosine;

        /// <summary>Σ w·sin k m now.</summary>
        public Vector4 Sine;

        /// <summary>√(cosine² + sine²): the same all through the cycle.</summary>
        public Vector4 Amplitude;
    }
}
