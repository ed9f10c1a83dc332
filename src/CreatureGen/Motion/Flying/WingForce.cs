using System;
using CreatureGen.Maths;
using CreatureGen.Motion.Winged;

namespace CreatureGen.Motion.Flying;

/// <summary>
/// What the beat of wings does to the body: the wings push in the downstroke and little in the upstroke, and the body falls in between. The force F over a cycle, scaled to a mean of one
/// weight, is integrated twice per harmonic: y″ = g(F/F̄ − 1) gives Yₖ = −g·Fₖ/(F̄·(2πkf)²); here for a gravity of 1 m/s² and one beat per second.
/// </summary>
internal sealed class WingForce
{
    private const int Harmonics = 4;
    private const int Samples = 128;
    private const double UpstrokeForce = 0.12;

    private readonly double[] cosines = new double[Harmonics];
    private readonly double[] sines = new double[Harmonics];

    /// <summary>Integrates the force of wings whose stroke follows <see cref="WingBeat"/>.</summary>
    public WingForce()
    {
        double mean = 0;
        for (int i = 0; i < Samples; i++)
        {
            double phase = (double)i / Samples;
            double sine = PortableMath.Sin(WingBeat.Angle(phase));
            double force = sine > 0 ? PortableMath.Pow(sine, 1.2) : -UpstrokeForce * sine;
            mean += force / Samples;
            for (int k = 0; k < Harmonics; k++)
            {
                PortableMath.SinCos(2 * PortableMath.Pi * (k + 1) * phase, out double s, out double c);
                cosines[k] += 2 * force * c / Samples;
                sines[k] += 2 * force * s / Samples;
            }
        }

        for (int k = 0; k < Harmonics; k++)
        {
            double w = 2 * PortableMath.Pi * (k + 1);
            cosines[k] *= -1 / (mean * w * w);
            sines[k] *= -1 / (mean * w * w);
        }

        for (int i = 0; i < Samples; i++)
        {
            Reach = Math.Max(Reach, Math.Abs(At((double)i / Samples)));
        }
    }

    /// <summary>Largest displacement at one beat per second and a gravity of 1 m/s², metres.</summary>
    public double Reach { get; }

    /// <summary>Displacement of the body at one beat per second and a gravity of 1 m/s², metres; it falls with the square of the frequency and grows with gravity.</summary>
    public double At(double phase)
    {
        double y = 0;
        PortableMath.SinCos(2 * PortableMath.Pi * phase, out double sine, out double cosine);
        double s = sine;
        double c = cosine;
        for (int k = 0; k < Harmonics; k++)
        {
            y += (cosines[k] * c) + (sines[k] * s);
            (s, c) = ((s * cosine) + (c * sine), (c * cosine) - (s * sine));
        }

        return y;
    }
}
