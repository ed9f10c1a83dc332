using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Trunk;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

public class ForceResponseTests
{
    [Theory]
    [InlineData(0.66f, 0.5f)]
    [InlineData(0.5f, 0f)]
    [InlineData(0.3f, 0f)]
    [InlineData(0.25f, 0.2f)]
    public void Height_is_the_force_integrated_twice(float duty, float dip)
    {
        float[] lags = { 0f, 0.5f };
        const float Scale = 0.37f;
        foreach (float phase in new[] { 0f, 0.11f, 0.42f, 0.77f })
        {
            double expected = 0;
            for (int k = 1; k <= ForceResponse.Harmonics; k++)
            {
                // The Fourier coefficient of the summed force over its mean, numerically.
                double re = 0;
                double im = 0;
                double mean = 0;
                const int Samples = 20000;
                for (int i = 0; i < Samples; i++)
                {
                    double t = (i + 0.5) / Samples;
                    double force = 0;
                    foreach (float lag in lags)
                    {
                        double p = t - lag;
                        p -= Math.Floor(p);
                        force += p < duty ? Math.Sin(Math.PI * p / duty) + (dip * Math.Sin(3 * Math.PI * p / duty)) : 0;
                    }

                    mean += force;
                    re += force * Math.Cos(2 * Math.PI * k * t);
                    im += force * Math.Sin(2 * Math.PI * k * t);
                }

                expected -= 2 * Scale / (k * k) * ((re / mean * Math.Cos(2 * Math.PI * k * phase)) + (im / mean * Math.Sin(2 * Math.PI * k * phase)));
            }

            var response = new ForceResponse();
            response.Tune(duty, dip);
            var sums = new FourierSums();
            foreach (float lag in lags)
            {
                double m = 2 * Math.PI * (-lag - (duty / 2));
                sums.Add((float)Math.Sin(m), (float)Math.Cos(m), Vector4.One);
            }

            sums.Turn((float)Math.Sin(2 * Math.PI * phase), (float)Math.Cos(2 * Math.PI * phase));

            Assert.Equal(expected, response.Height(sums, lags.Length, Scale, float.MaxValue, out _).W, 4);
        }
    }
}
