using System;
using CreatureGen.Maths;
using CreatureGen.Seeding;

namespace CreatureGen.Sounds;

/// <summary>Adds tones and noise to samples, from their beginning on.</summary>
internal readonly ref struct Voice
{
    /// <summary>Decays after which a sound is not heard any more.</summary>
    private const double Decays = 8;

    /// <summary>Part by which level and pitch vary from sound to sound.</summary>
    private const double Variety = 0.08;

    private readonly Span<float> samples;
    private readonly int rate;
    private readonly RandomStream random;

    public Voice(Span<float> samples, int rate, RandomStream random)
    {
        this.samples = samples;
        this.rate = rate;
        this.random = random;
    }

    /// <summary>A tone that glides from one pitch to another.</summary>
    /// <param name="level">0..1.</param>
    /// <param name="from">Hz.</param>
    /// <param name="to">Hz, towards the end of its decay.</param>
    /// <param name="attack">Seconds until it is at its level.</param>
    /// <param name="decay">Seconds in which it then falls to 1/e.</param>
    public void Tone(double level, double from, double to, double attack, double decay)
    {
        double pitch = 1 + (Variety * random.Uniform(-1, 1));
        double loud = level * (1 + (Variety * random.Uniform(-1, 1)));
        double phase = 0;
        for (int i = 0; i < Length(attack, decay); i++)
        {
            double time = i / (double)rate;
            double glide = 1 - PortableMath.Exp(-time / decay);
            phase += pitch * (from + ((to - from) * glide)) / rate;
            phase -= Math.Floor(phase);
            samples[i] += (float)(loud * Envelope(time, attack, decay) * PortableMath.Sin(PortableMath.Tau * phase));
        }
    }

    /// <summary>Noise around a pitch.</summary>
    /// <param name="level">0..1.</param>
    /// <param name="pitch">Hz of the middle of its band.</param>
    /// <param name="attack">Seconds until it is at its level.</param>
    /// <param name="decay">Seconds in which it then falls to 1/e.</param>
    public void Noise(double level, double pitch, double attack, double decay)
    {
        // A state-variable filter, an octave wide; below a sixth of the rate it is stable.
        double f = 2 * PortableMath.Sin(PortableMath.Pi * Math.Min(pitch * (1 + (Variety * random.Uniform(-1, 1))), rate / 6.0) / rate);
        double loud = level * (1 + (Variety * random.Uniform(-1, 1)));
        double low = 0;
        double band = 0;
        for (int i = 0; i < Length(attack, decay); i++)
        {
            low += f * band;
            double high = random.Uniform(-1, 1) - low - band;
            band += f * high;
            samples[i] += (float)(loud * Envelope(i / (double)rate, attack, decay) * band / Math.Sqrt(f));
        }
    }

    private static double Envelope(double time, double attack, double decay) => time < attack ? Scalar.Smooth(time / attack) : PortableMath.Exp((attack - time) / decay);

    private int Length(double attack, double decay) => Math.Min(samples.Length, (int)Math.Ceiling((attack + (Decays * decay)) * rate));
}
