using System;
using CreatureGen.Seeding;
using Xunit;

namespace CreatureGen.Tests.Seeding;

public sealed class RandomStreamTests
{
    private const int Draws = 100_000;

    [Fact]
    public void From_the_state_1_2_3_4_come_the_reference_numbers_of_xoshiro256_star_star()
    {
        var stream = new RandomStream(1, 2, 3, 4);
        ulong[] expected =
        {
            11520, 0, 1509978240, 1215971899390074240, 1216172134540287360,
            607988272756665600, 16172922978634559625, 8476171486693032832, 10595114339597558777, 2904607092377533576,
        };
        Assert.All(expected, number => Assert.Equal(number, stream.NextUInt64()));
    }

    [Fact]
    public void The_state_of_a_seed_is_the_first_four_numbers_of_SplitMix64()
    {
        var expected = new RandomStream(6457827717110365317UL, 3203168211198807973UL, 9817491932198370423UL, 4593380528125082431UL);
        var actual = new RandomStream(1234567);
        for (int i = 0; i < 20; i++)
        {
            Assert.Equal(expected.NextUInt64(), actual.NextUInt64());
        }
    }

    [Fact]
    public void The_first_numbers_of_a_seed_stay_the_same()
    {
        var stream = new Seed(1).Child("body").Stream();
        Assert.Equal(0x1C2D2C62C1E0F379UL, stream.NextUInt64());
        Assert.Equal(0.6390128684403156, stream.Uniform());
        Assert.Equal(845, stream.Integer(0, 1000));
        Assert.Equal(-0.3410425383529796, stream.Normal(0, 1));
        Assert.Equal(1.6540191446050889, stream.LogNormal(0.3, 0.1, 10));
        Assert.Equal(0, stream.Weighted([1, 2, 3]));
    }

    [Fact]
    public void Uniform_numbers_fill_zero_to_one_evenly()
    {
        var stream = new RandomStream(3);
        var counts = new int[100];
        double sum = 0;
        double squares = 0;
        double lagged = 0;
        double before = 0.5;
        for (int i = 0; i < Draws; i++)
        {
            double u = stream.Uniform();
            Assert.True(u is >= 0 and < 1);
            counts[(int)(u * 100)]++;
            sum += u;
            squares += u * u;
            lagged += (u - 0.5) * (before - 0.5);
            before = u;
        }

        Assert.Equal(0.5, sum / Draws, 4 * Math.Sqrt(1 / 12.0 / Draws));
        Assert.Equal(1 / 3.0, squares / Draws, 4 * Math.Sqrt(4 / 45.0 / Draws));
        Assert.Equal(0, lagged * 12 / Math.Sqrt(Draws), 4.0);
        Assert.InRange(ChiSquare(counts, _ => Draws / 100.0), 45, 165);
    }

    [Fact]
    public void Every_bit_is_set_half_of_the_time()
    {
        var stream = new RandomStream(4);
        var counts = new int[64];
        for (int i = 0; i < Draws; i++)
        {
            ulong bits = stream.NextUInt64();
            for (int b = 0; b < 64; b++)
            {
                counts[b] += (int)((bits >> b) & 1);
            }
        }

        Assert.All(counts, count => Assert.InRange(count, (Draws / 2) - 700, (Draws / 2) + 700));
    }

    [Theory]
    [InlineData(2)]
    [InlineData(7)]
    [InlineData(10)]
    [InlineData(97)]
    [InlineData(1000)]
    public void Whole_numbers_are_equally_likely(int range)
    {
        var stream = new RandomStream((ulong)range);
        var counts = new int[range];
        for (int i = 0; i < Draws; i++)
        {
            counts[stream.Integer(-3, range - 3) + 3]++;
        }

        // Chi-square of n − 1 degrees of freedom: mean n − 1, deviation √(2n − 2).
        Assert.InRange(ChiSquare(counts, _ => (double)Draws / range), 0, range - 1 + (4.5 * Math.Sqrt(2 * (range - 1))));
    }

    [Fact]
    public void Whole_numbers_of_a_wide_range_have_no_preferred_remainder()
    {
        // A range of 3 · 2^30: numbers made from 32 bits alone would hit every third place twice as often.
        var stream = new RandomStream(8);
        var counts = new int[3];
        for (int i = 0; i < Draws; i++)
        {
            counts[(int)(((long)stream.Integer(int.MinValue, 1 << 30) - int.MinValue) % 3)]++;
        }

        Assert.InRange(ChiSquare(counts, _ => Draws / 3.0), 0, 20);
    }

    [Fact]
    public void Whole_numbers_reach_both_ends_of_their_range_and_not_beyond()
    {
        var stream = new RandomStream(5);
        bool low = false;
        bool high = false;
        for (int i = 0; i < 1000; i++)
        {
            Assert.Equal(7, stream.Integer(7, 8));
            Assert.Equal(int.MaxValue - 1, stream.Integer(int.MaxValue - 1, int.MaxValue));
            Assert.Equal(int.MinValue, stream.Integer(int.MinValue, int.MinValue + 1));
            int wide = stream.Integer(int.MinValue, int.MaxValue);
            low |= wide < -2_000_000_000;
            high |= wide > 2_000_000_000;
            Assert.InRange(stream.Integer(-2, 3), -2, 2);
        }

        Assert.True(low && high);

        // The largest and the smallest draw: xoshiro's scrambler is a bijection, and 0 comes of s1 = 0.
        Assert.Equal(int.MinValue, new RandomStream(1, 0, 1, 1).Integer(int.MinValue, int.MaxValue));
        ulong all = unchecked(RotateRight(ulong.MaxValue * InverseOf(9), 7) * InverseOf(5));
        Assert.Equal(int.MaxValue - 1, new RandomStream(1, all, 1, 1).Integer(int.MinValue, int.MaxValue));
        Assert.Equal(9, new RandomStream(1, all, 1, 1).Integer(0, 10));
        Assert.Equal(1 - (1 / 9007199254740992.0), new RandomStream(1, all, 1, 1).Uniform());
    }

    [Fact]
    public void An_empty_range_is_refused()
    {
        var stream = new RandomStream(1);
        Assert.Contains("[5, 5)", Assert.Throws<ArgumentOutOfRangeException>(() => stream.Integer(5, 5)).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentOutOfRangeException>(() => stream.Integer(int.MaxValue, int.MinValue));
    }

    [Fact]
    public void Chances_come_true_as_often_as_they_say()
    {
        var stream = new RandomStream(6);
        int count = 0;
        for (int i = 0; i < Draws; i++)
        {
            count += stream.Chance(0.3) ? 1 : 0;
            Assert.False(stream.Chance(0));
            Assert.True(stream.Chance(1));
        }

        Assert.Equal(0.3, count / (double)Draws, 4 * Math.Sqrt(0.21 / Draws));
    }

    [Fact]
    public void Normal_numbers_have_their_moments_and_their_tails()
    {
        var stream = new RandomStream(9);
        double sum = 0;
        double squares = 0;
        double cubes = 0;
        double fourths = 0;
        var counts = new int[8];
        for (int i = 0; i < Draws; i++)
        {
            double z = (stream.Normal(3, 0.5) - 3) / 0.5;
            sum += z;
            squares += z * z;
            cubes += z * z * z;
            fourths += z * z * z * z;
            counts[Math.Clamp((int)Math.Floor(z) + 4, 0, 7)]++;
        }

        Assert.Equal(0, sum / Draws, 4 / Math.Sqrt(Draws));
        Assert.Equal(1, squares / Draws, 4 * Math.Sqrt(2.0 / Draws));
        Assert.Equal(0, cubes / Draws, 4 * Math.Sqrt(15.0 / Draws));
        Assert.Equal(3, fourths / Draws, 4 * Math.Sqrt(96.0 / Draws));

        // Probabilities of below −3, −3..−2, −2..−1, −1..0 and their mirror images.
        double[] fractions = { 0.001349898, 0.021400234, 0.135905122, 0.341344746, 0.341344746, 0.135905122, 0.021400234, 0.001349898 };
        Assert.InRange(ChiSquare(counts, i => Draws * fractions[i]), 0, 26);
    }

    [Fact]
    public void The_extreme_draws_of_a_normal_number_are_finite()
    {
        ulong all = unchecked(RotateRight(ulong.MaxValue * InverseOf(9), 7) * InverseOf(5));
        double far = new RandomStream(1, all, 1, 1).Normal(0, 1);
        Assert.InRange(Math.Abs(far), 0, 8.58);
        Assert.Equal(2.5, new RandomStream(1, 0, 1, 1).Normal(2.5, 1));
    }

    [Fact]
    public void Log_normal_numbers_stay_in_their_range_and_are_as_often_above_one_as_below()
    {
        var stream = new RandomStream(10);
        int above = 0;
        for (int i = 0; i < Draws; i++)
        {
            double x = stream.LogNormal(0.4, 0.5, 2);
            Assert.InRange(x, 0.5, 2);
            above += x > 1 ? 1 : 0;
        }

        Assert.Equal(0.5, above / (double)Draws, 4 * Math.Sqrt(0.25 / Draws));
    }

    [Fact]
    public void Weighted_indices_come_as_often_as_they_weigh()
    {
        var stream = new RandomStream(11);
        double[] weights = { 0, 1, 0.5, 0, 3, 0.1, 0 };
        var counts = new int[weights.Length];
        for (int i = 0; i < Draws; i++)
        {
            counts[stream.Weighted(weights)]++;
        }

        Assert.Equal(0, counts[0] + counts[3] + counts[6]);
        Assert.InRange(ChiSquare([counts[1], counts[2], counts[4], counts[5]], i => Draws * new[] { 1, 0.5, 3, 0.1 }[i] / 4.6), 0, 20);
    }

    [Fact]
    public void The_last_weighted_index_is_never_one_without_weight()
    {
        ulong all = unchecked(RotateRight(ulong.MaxValue * InverseOf(9), 7) * InverseOf(5));
        Assert.Equal(1, new RandomStream(1, all, 1, 1).Weighted([0.1, 0.7, 0]));
        Assert.Equal(1, new RandomStream(1, 0, 1, 1).Weighted([0, 0.7, 0]));
    }

    [Fact]
    public void Weights_without_meaning_are_refused_with_their_place()
    {
        var stream = new RandomStream(1);
        Assert.Contains("weights[1]", Assert.Throws<ArgumentException>(() => stream.Weighted([1, -1])).Message, StringComparison.Ordinal);
        Assert.Contains("weights[0]", Assert.Throws<ArgumentException>(() => stream.Weighted([double.NaN, 1])).Message, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => stream.Weighted([double.PositiveInfinity]));
        Assert.Throws<ArgumentException>(() => stream.Weighted([0, 0]));
        Assert.Throws<ArgumentException>(() => stream.Weighted([]));
    }

    [Fact]
    public void Each_method_takes_as_many_draws_as_it_says()
    {
        Takes(1, s => s.Uniform());
        Takes(1, s => s.Uniform(2, 5));
        Takes(1, s => s.Integer(0, 1));
        Takes(1, s => s.Integer(int.MinValue, int.MaxValue));
        Takes(1, s => s.Chance(1));
        Takes(1, s => s.Weighted([0, 1, 2]));
        Takes(2, s => s.Normal(0, 0));
        Takes(2, s => s.LogNormal(3, 1, 1));
    }

    private static void Takes(int draws, Action<RandomStream> use)
    {
        for (ulong seed = 0; seed < 50; seed++)
        {
            var used = new RandomStream(seed);
            var skipped = new RandomStream(seed);
            use(used);
            for (int i = 0; i < draws; i++)
            {
                skipped.NextUInt64();
            }

            Assert.Equal(skipped.NextUInt64(), used.NextUInt64());
        }
    }

    private static double ChiSquare(int[] counts, Func<int, double> expected)
    {
        double sum = 0;
        for (int i = 0; i < counts.Length; i++)
        {
            double difference = counts[i] - expected(i);
            sum += difference * difference / expected(i);
        }

        return sum;
    }

    private static ulong RotateRight(ulong x, int k) => (x >> k) | (x << (64 - k));

    /// <summary>The inverse of an odd number modulo 2^64, by Newton's steps.</summary>
    private static ulong InverseOf(ulong odd)
    {
        ulong inverse = odd;
        for (int i = 0; i < 6; i++)
        {
            inverse = unchecked(inverse * (2 - (odd * inverse)));
        }

        return inverse;
    }
}
