using System;
using System.Collections.Generic;
using System.Linq;
using System.Numerics;
using CreatureGen.Appearance;
using CreatureGen.Appearance.Textures;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Appearance;

public sealed class NoiseTests
{
    // Worked out by an independent implementation with unbounded integers.
    [Theory]
    [InlineData(0, 0, 0, 0, 0x01FCE552u)]
    [InlineData(1, 2, 3, 4, 0x06378CCDu)]
    [InlineData(-1, -2, -3, -4, 0x5D71F205u)]
    [InlineData(int.MaxValue, int.MinValue, 0, 7, 0x44CFA843u)]
    [InlineData(100, -7, 12, 1603, 0xC21A6D40u)]
    public void The_bits_of_a_cell_are_fixed(int x, int y, int z, int salt, uint bits) => Assert.Equal(bits, LatticeHash.Bits(x, y, z, salt));

    [Theory]
    [InlineData(0f, 0f, 0f, 0.3697049021720886)]
    [InlineData(0.5f, 0.25f, 0.75f, 0.3375194755499251)]
    [InlineData(-3.3f, 2.7f, -0.1f, 0.48274234567327906)]
    [InlineData(17.25f, -8.5f, 1000.125f, 0.5029758304190182)]
    public void Clouds_have_known_values(float x, float y, float z, double value) =>
        Assert.Equal(value, new ValueNoise(5).At(new Vector3(x, y, z)), 1e-5);

    [Fact]
    public void Clouds_stay_in_range_average_one_half_and_use_most_of_it()
    {
        RandomStream random = new Seed(1).Stream();
        double sum = 0;
        float low = 1f;
        float high = 0f;
        const int Count = 20000;
        for (int n = 0; n < Count; n++)
        {
            float v = new ValueNoise(9).At(Point(random, 50));
            sum += v;
            low = Math.Min(low, v);
            high = Math.Max(high, v);
        }

        Assert.InRange(low, 0f, 0.08f);
        Assert.InRange(high, 0.92f, 1f);
        Assert.Equal(0.5, sum / Count, 0.01);
    }

    [Fact]
    public void Clouds_are_continuous_everywhere_and_across_zero()
    {
        var noise = new ValueNoise(2);
        for (int n = -400; n < 400; n++)
        {
            float t = n * 0.01f;
            float step = Math.Abs(noise.At(new Vector3(t, -t, 0.3f)) - noise.At(new Vector3(t + 0.001f, -t - 0.001f, 0.3f)));
            Assert.InRange(step, 0f, 0.006f);
        }
    }

    [Fact]
    public void The_nearest_point_is_the_one_that_a_wide_search_finds()
    {
        RandomStream random = new Seed(2).Stream();
        int close = 0;
        for (int n = 0; n < 4000; n++)
        {
            Vector3 point = Point(random, 30);
            NearestPoint found = new WorleyNoise(3).Nearest(point);
            double[] all = WideSearch(point, 3);
            double wide = all[0];
            double reach = WorleyNoise.Reach;
            Assert.Equal(Math.Max(0, Math.Min(reach, all[1]) - wide), found.Margin, 1e-4);
            Assert.True(found.Distance >= wide - 1e-5);
            if (wide < WorleyNoise.Reach)
            {
                Assert.Equal(wide, found.Distance, 1e-4);
                close++;
            }
        }

        Assert.InRange(close, 2500, 4000);
    }

    [Fact]
    public void The_gap_of_two_nearest_points_is_the_one_that_a_wide_search_finds()
    {
        const float Max = 0.25f;
        RandomStream random = new Seed(6).Stream();
        int beyond = 0;
        for (int n = 0; n < 6000; n++)
        {
            Vector3 point = Point(random, 30);
            double[] nearest = WideSearch(point, 3);
            double gap = nearest[1] - nearest[0];
            float found = new WorleyNoise(3).Gap(point, Max);
            if (gap < Max)
            {
                Assert.Equal(gap, found, 1e-4);
                beyond += nearest[1] > WorleyNoise.Reach ? 1 : 0;
            }
            else
            {
                Assert.True(found >= Max - 1e-4);
            }
        }

        Assert.InRange(beyond, 1000, 6000);
    }

    [Fact]
    public void Lobes_lie_between_minus_one_and_one_and_change_sign_around_a_point()
    {
        Assert.Equal(0f, new NearestPoint(Vector3.Zero, 77, 1f).Lobes);
        for (uint bits = 0; bits < 200; bits++)
        {
            float[] lobes = Enumerable.Range(0, 360).Select(degree => new NearestPoint(new Vector3(MathF.Cos(degree * MathF.PI / 180f), MathF.Sin(degree * MathF.PI / 180f), 0f), bits, 4f).Lobes).ToArray();
            Assert.All(lobes, lobe => Assert.InRange(lobe, -1f, 1f));
            Assert.Equal(4, Enumerable.Range(0, 360).Count(degree => lobes[degree] < 0f != lobes[(degree + 1) % 360] < 0f));
        }
    }

    [Fact]
    public void All_places_near_one_point_share_its_value()
    {
        RandomStream random = new Seed(4).Stream();
        for (int n = 0; n < 200; n++)
        {
            Vector3 point = Point(random, 10);
            NearestPoint here = new WorleyNoise(3).Nearest(point);
            NearestPoint beside = new WorleyNoise(3).Nearest(point + new Vector3(1e-4f, 0f, 0f));
            if (here.Value != beside.Value)
            {
                // Only a border between two points may part them, and there both are equally far.
                Assert.Equal(here.Distance, beside.Distance, 1e-3f);
            }
        }
    }

    [Fact]
    public void Salts_give_unrelated_fields()
    {
        int equal = 0;
        for (int n = 0; n < 100; n++)
        {
            var point = new Vector3(n * 0.37f, n * 0.11f, n * -0.23f);
            equal += Math.Abs(new ValueNoise(1).At(point) - new ValueNoise(2).At(point)) < 0.02f ? 1 : 0;
        }

        Assert.InRange(equal, 0, 20);
    }

    [Fact]
    public void What_was_asked_before_changes_no_answer()
    {
        RandomStream random = new Seed(4).Stream();
        var clouds = new ValueNoise(11);
        var plane = new PlaneNoise(11);
        var scatter = new WorleyNoise(11);
        for (int n = 0; n < 4000; n++)
        {
            // Small steps mostly stay in a cell, and each tenth is a leap; the first is the cell at zero, where nothing is known yet.
            Vector3 point = n == 0 ? Vector3.Zero : Point(random, n % 10 == 0 ? 40 : 0.7);
            Assert.Equal(new ValueNoise(11).At(point), clouds.At(point));
            Assert.Equal(new PlaneNoise(11).At(point.X, point.Y), plane.At(point.X, point.Y));
            Assert.Equal(new WorleyNoise(11).Nearest(point).Distance, scatter.Nearest(point).Distance);
            Assert.Equal(new WorleyNoise(11).Gap(point, 0.3f), scatter.Gap(point, 0.3f));
        }
    }

    private static Vector3 Point(RandomStream random, double range) =>
        new((float)random.Uniform(-range, range), (float)random.Uniform(-range, range), (float)random.Uniform(-range, range));

    /// <summary>Distances to the nearest and to the second nearest point.</summary>
    private static double[] WideSearch(Vector3 point, int salt)
    {
        var all = new List<double>();
        int cx = (int)Math.Floor(point.X);
        int cy = (int)Math.Floor(point.Y);
        int cz = (int)Math.Floor(point.Z);
        for (int x = cx - 2; x <= cx + 2; x++)
        {
            for (int y = cy - 2; y <= cy + 2; y++)
            {
                for (int z = cz - 2; z <= cz + 2; z++)
                {
                    uint bits = LatticeHash.Bits(x, y, z, salt);
                    double dx = x + Offset(bits >> 22) - point.X;
                    double dy = y + Offset((bits >> 12) & 1023) - point.Y;
                    double dz = z + Offset((bits >> 2) & 1023) - point.Z;
                    all.Add(Math.Sqrt((dx * dx) + (dy * dy) + (dz * dz)));
                }
            }
        }

        return all.Order().Take(2).ToArray();
    }

    private static double Offset(uint tenBits) => 0.5 + (WorleyNoise.Jitter * ((tenBits / 511.5) - 1));
}
