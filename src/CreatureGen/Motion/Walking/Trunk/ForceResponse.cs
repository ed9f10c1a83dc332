using System;
using System.Numerics;
using CreatureGen.Maths;

namespace CreatureGen.Motion.Walking.Trunk;

/// <summary>
/// How the forces of the feet move the body, harmonic by harmonic. A foot in stance pushes with sin πs + q·sin 3πs; the body's height is what those forces, less its weight, integrate to twice.
/// Vault, bounce and flight come out of that one line, with their phase and their size.
/// </summary>
/// <remarks>
/// The Fourier coefficients of such a push of duty β are known in closed form: with θ = πkβ, seen from the middle of stance, they are real, E(θ) = 4π cos θ/(π² − 4θ²) + q·12π cos θ/(9π² − 4θ²).
/// So the height is −g/(n(2πf)²) Σ E_k/(E_0 k²) Σ 2 cos k m over n legs, m the angle of a leg from the middle of its stance: no table, and it follows any change of gait.
/// </remarks>
internal sealed class ForceResponse
{
    /// <summary>Harmonics that are followed.</summary>
    public const int Harmonics = 6;

    private const float NodDamping = 0.55f;
    private const float NodTuning = 1.6f;
    private const double Pi = PortableMath.Pi;

    /// <summary>How a sprung neck answers each harmonic, in step with it and a quarter behind: θ″ + 2ζwθ′ + w²θ = −y″·…, with w in cycles.</summary>
    private static readonly (float InStep, float Behind)[] NodResponses = NodsOf();

    private readonly Push[] pushes = new Push[Harmonics + 1];
    private float tunedDuty = float.NaN;
    private float tunedDip = float.NaN;

    /// <summary>Height above its mean at which a body is whose feet all come down together, in units of g/(2πf)²: below it, more so the longer it flies.</summary>
    public float Touchdown { get; private set; }

    /// <summary>Asks memory for the coefficients.</summary>
    /// <returns>See <see cref="MemoryLines"/>.</returns>
    public int Fetch() => MemoryLines.Touch(ref tunedDuty) ^ MemoryLines.Touch(pushes, Harmonics + 1);

    /// <summary>Finds the coefficients of the push relative to its mean. They are kept while the gait is steady.</summary>
    /// <param name="duty">β, part of the cycle.</param>
    /// <param name="dip">q.</param>
    public void Tune(float duty, float dip)
    {
        if (duty == tunedDuty && dip == tunedDip)
        {
            return;
        }

        tunedDuty = duty;
        tunedDip = dip;
        double mean = (4 / Pi) + (dip * 4 / (3 * Pi));
        PortableMath.SinCos(Pi * duty, out double s1, out double c1);
        double touchdown = 0;
        double s = 0;
        double c = 1;
        for (int k = 1; k <= Harmonics; k++)
        {
            (s, c) = ((s * c1) + (c * s1), (c * c1) - (s * s1));
            double theta = Pi * k * duty;
            float even = (float)(Even(theta, c, dip) / mean);
            pushes[k] = new Push(even, even / (k * k), (float)(Odd(theta, s, c) / mean) / (k * k));
            touchdown -= 2 * pushes[k].Height * c;
        }

        Touchdown = (float)touchdown;
    }

    /// <summary>Heights of the body above its mean, one for each of four sums, in units of the first harmonic's g/(2πf)², and the neck's passive nods.</summary>
    /// <param name="sums">Σ cos k m and Σ sin k m of the legs, k from 1.</param>
    /// <param name="legs">Number of legs in a sum.</param>
    /// <param name="scale">g/(2πf)², metres.</param>
    /// <param name="cap">Most that a harmonic may have as amplitude, metres.</param>
    /// <param name="nod">Angles of a sprung neck per metre of its length.</param>
    public Vector4 Height(FourierSums sums, int legs, float scale, float cap, out Vector4 nod)
    {
        Vector4 max = Vector4.Zero;
        Vector4 height = Vector4.Zero;
        float unit = 2f * scale / legs;
        nod = Vector4.Zero;
        ReadOnlySpan<FourierSums.Harmonic> harmonics = sums.Harmonics;
        for (int k = 1; k < harmonics.Length; k++)
        {
            // Numbers in all four places: an operator that takes one is a call in browsers.
            var y = new Vector4(-unit * pushes[k].Height);
            Vector4 c = harmonics[k].Cosine;
            Vector4 amplitude = harmonics[k].Amplitude * new Vector4(Math.Abs(y.X));
            max = new Vector4(Math.Max(max.X, amplitude.X), Math.Max(max.Y, amplitude.Y), Math.Max(max.Z, amplitude.Z), Math.Max(max.W, amplitude.W));
            height += c * y;
            nod -= ((c * new Vector4(NodResponses[k].InStep)) + (harmonics[k].Sine * new Vector4(NodResponses[k].Behind))) * y;
        }

        var fraction = new Vector4(Fraction(max.X, cap), Fraction(max.Y, cap), Fraction(max.Z, cap), Fraction(max.W, cap));
        nod *= fraction;
        return height * fraction;
    }

    /// <summary>Sway towards the loaded feet.</summary>
    /// <param name="sums"><see cref="LegSums.Aside"/> of them is Σ x cos k m of the legs, x the place of the foot to the left.</param>
    /// <param name="legs">Number of legs.</param>
    /// <param name="pendulum">w²/(2πf)², w² = g/height of the hips: an inverted pendulum follows slow feet and not quick ones.</param>
    public float Sway(FourierSums sums, int legs, float pendulum)
    {
        float sway = 0f;
        for (int k = 1; k <= 4; k++)
        {
            sway += 2f * pushes[k].Even / legs * pendulum / (pendulum + (k * k)) * sums.Harmonics[k].Cosine.Aside();
        }

        return sway;
    }

    /// <summary>Surge ahead as feet brake and push, by the sums over <see cref="LegSums.All"/> legs, for the same scale as the height and a stance of the given length over the hips' height.</summary>
    public float Surge(FourierSums sums, int legs, float scale, float stance, float cap)
    {
        float surge = 0f;
        float max = 0f;
        float unit = scale * stance / legs;
        ReadOnlySpan<FourierSums.Harmonic> harmonics = sums.Harmonics;
        for (int k = 1; k < harmonics.Length; k++)
        {
            float z = -unit * pushes[k].Surge;
            max = Math.Max(max, Math.Abs(z) * harmonics[k].Amplitude.All());
            surge += z * harmonics[k].Sine.All();
        }

        return max > cap ? surge * cap / max : surge;
    }

    private static float Fraction(float max, float cap) => max > cap ? cap / max : 1f;

    private static (float InStep, float Behind)[] NodsOf()
    {
        var nods = new (float InStep, float Behind)[Harmonics + 1];
        for (int k = 1; k <= Harmonics; k++)
        {
            float re = (NodTuning * NodTuning) - (k * k);
            float im = 2f * NodDamping * NodTuning * k;
            float over = k * k / ((re * re) + (im * im));
            nods[k] = (over * re, over * im);
        }

        return nods;
    }

    private static double Even(double theta, double cosine, double dip)
    {
        double d = (Pi * Pi) - (4 * theta * theta);
        double first = Math.Abs(d) < 1e-3 ? 1 : 4 * Pi * cosine / d;
        double d3 = (9 * Pi * Pi) - (4 * theta * theta);
        double third = Math.Abs(d3) < 1e-3 ? -1 : 12 * Pi * cosine / d3;
        return first + (dip * third);
    }

    private static double Odd(double theta, double sine, double cosine)
    {
        if (Math.Abs(theta - (Pi / 2)) < 0.05)
        {
            return (1 / Pi) + (0.1307 * (theta - (Pi / 2)));
        }

        double d = (Pi * Pi) - (4 * theta * theta);
        return 4 * Pi * ((sine / d) - (8 * theta * cosine / (d * d)));
    }

    /// <summary>What a foot's push is of a harmonic, relative to its mean: side by side, as they are asked for together.</summary>
    /// <param name="Even">Its coefficient, seen from the middle of stance.</param>
    /// <param name="Height">The same integrated twice.</param>
    /// <param name="Surge">Of braking and pushing, integrated twice.</param>
    private readonly record struct Push(float Even, float Height, float Surge);
}
