using System;
using System.Numerics;
using CreatureGen.Motion.Walking.Trunk;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

public class FourierSumsTests
{
    private static readonly (double Angle, float Weight)[] Legs = { (0.3, 1f), (-1.9, 0.7f), (2.8, -1.2f), (1.1, 1f) };

    /// <summary>Of the four weights over that of a leg.</summary>
    private static readonly Vector4 Factors = new(1f, 0f, -0.5f, 2f);

    [Fact]
    public void Turned_sums_are_those_of_the_legs_turned_one_by_one_for_each_of_four_weights()
    {
        FourierSums sums = Summed();
        foreach (double turn in new[] { 0, 0.4, 2.2, 3.9, 6.1 })
        {
            sums.Turn((float)Math.Sin(turn), (float)Math.Cos(turn));
            for (int k = 1; k <= ForceResponse.Harmonics; k++)
            {
                double cosine = 0;
                double sine = 0;
                foreach ((double angle, float weight) in Legs)
                {
                    cosine += weight * Math.Cos(k * (angle + turn));
                    sine += weight * Math.Sin(k * (angle + turn));
                }

                double amplitude = Math.Sqrt((cosine * cosine) + (sine * sine));
                FourierSums.Harmonic harmonic = sums.Harmonics[k];
                for (int weight = 0; weight < 4; weight++)
                {
                    Assert.Equal(cosine * At(Factors, weight), At(harmonic.Cosine, weight), 4);
                    Assert.Equal(sine * At(Factors, weight), At(harmonic.Sine, weight), 4);
                    Assert.Equal(amplitude * Math.Abs(At(Factors, weight)), At(harmonic.Amplitude, weight), 4);
                }
            }
        }
    }

    [Fact]
    public void Cleared_sums_are_none()
    {
        FourierSums sums = Summed();
        sums.Clear();
        sums.Turn(0.6f, 0.8f);
        Assert.All(sums.Harmonics.ToArray(), harmonic => Assert.Equal(default, harmonic));
    }

    private static float At(Vector4 numbers, int place) => place switch { 0 => numbers.X, 1 => numbers.Y, 2 => numbers.Z, _ => numbers.W };

    private static FourierSums Summed()
    {
        var sums = new FourierSums();
        foreach ((double angle, float weight) in Legs)
        {
            sums.Add((float)Math.Sin(angle), (float)Math.Cos(angle), Factors * weight);
        }

        return sums;
    }
}
