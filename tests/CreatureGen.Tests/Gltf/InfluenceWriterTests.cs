using System;
using System.Numerics;
using CreatureGen.Gltf;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Gltf;

public sealed class InfluenceWriterTests
{
    [Fact]
    public void Weights_sum_to_one_within_what_importers_allow()
    {
        var random = new RandomStream(7);
        for (int i = 0; i < Thoroughness.Of(200_000); i++)
        {
            int used = 1 + (i % 4);
            Vector4 given = Descending(random, used);
            Vector4 w = InfluenceWriter.SumToOne(given);
            float sum = 0f;
            for (int k = 0; k < 4; k++)
            {
                Assert.Equal(k < used, w[k] > 0f);
                Assert.True(Math.Abs(w[k] - given[k]) <= 1.2e-5f, $"{given[k]:R} became {w[k]:R}");
                sum += w[k];
            }

            Assert.True(Math.Abs(sum - 1f) <= 2e-7f * used, $"{w} sums to {sum:R}");
        }
    }

    [Fact]
    public void Weights_that_floats_hold_exactly_are_left_alone()
    {
        foreach (Vector4 w in new[] { Vector4.UnitX, new Vector4(0.5f, 0.5f, 0, 0), new Vector4(0.5f, 0.25f, 0.25f, 0), new Vector4(0.25f), new Vector4(0.625f, 0.25f, 0.0625f, 0.0625f) })
        {
            Assert.Equal(w, InfluenceWriter.SumToOne(w));
        }
    }

    /// <summary>Positive weights that sum to one within a hundred-thousandth.</summary>
    private static Vector4 Descending(RandomStream random, int used)
    {
        var raw = new double[4];
        double sum = 0;
        for (int k = 0; k < used; k++)
        {
            raw[k] = random.Uniform() < 0.1 ? 1e-7 : random.Uniform(1e-3, 1.0);
            sum += raw[k];
        }

        Array.Sort(raw);
        sum *= random.Uniform(1.0 - 9e-6, 1.0 + 9e-6);
        return new Vector4((float)(raw[3] / sum), (float)(raw[2] / sum), (float)(raw[1] / sum), (float)(raw[0] / sum));
    }
}
