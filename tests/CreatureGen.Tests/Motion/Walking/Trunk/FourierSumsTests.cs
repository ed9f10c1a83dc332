using System;
using CreatureGen.Motion.Walking.Trunk;
using Xunit;

namespace CreatureGen.Tests.Motion.Walking.Trunk;

public class FourierSumsTests
{
    private static readonly (double Angle, float Weight)[] Legs = { (0.3, 1f), (-1.9, 0.7f), (2.8, -1.2f), (1.1, 1f) };

    [Fact]
    public void Turned_sums_are_those_of_the_legs_turned_one_by_one()
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

                Assert.Equal(cosine, sums.Harmonics[k].Cosine, 4);
                Assert.Equal(sine, sums.Harmonics[k].Sine, 4);
                Assert.Equal(Math.Sqrt((cosine * cosine) + (sine * sine)), sums.Harmonics[k].Amplitude, 4);
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

    private static FourierSums Summed()
    {
        var sums = new FourierSums();
        foreach ((double angle, float weight) in Legs)
        {
            sums.Add((float)Math.Sin(angle), (float)Math.Cos(angle), weight);
        }

        return sums;
    }
}
