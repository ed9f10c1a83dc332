using System;
using CreatureGen.Maths;

namespace CreatureGen.Seeding;

/// <summary>Random numbers of one node of the seed tree.</summary>
/// <remarks>Based on: D. Blackman and S. Vigna, "Scrambled linear pseudorandom number generators" (2021): xoshiro256**, its state filled by SplitMix64.</remarks>
public sealed class RandomStream
{
    private ulong s0;
    private ulong s1;
    private ulong s2;
    private ulong s3;

    /// <summary>Starts the stream of a 64-bit seed.</summary>
    public RandomStream(ulong seed)
    {
        unchecked
        {
            s0 = Seed.Mix(seed += 0x9E3779B97F4A7C15UL);
            s1 = Seed.Mix(seed += 0x9E3779B97F4A7C15UL);
            s2 = Seed.Mix(seed += 0x9E3779B97F4A7C15UL);
            s3 = Seed.Mix(seed + 0x9E3779B97F4A7C15UL);
        }
    }

    /// <summary>The next 64 random bits.</summary>
    public ulong NextUInt64()
    {
        unchecked
        {
            ulong result = Rotate(s1 * 5, 7) * 9;
            ulong t = s1 << 17;
            s2 ^= s0;
            s3 ^= s1;
            s1 ^= s2;
            s0 ^= s3;
            s2 ^= t;
            s3 = Rotate(s3, 45);
            return result;
        }
    }

    /// <summary>Uniform in [0, 1).</summary>
    public double Uniform() => (NextUInt64() >> 11) * (1.0 / 9007199254740992.0);

    /// <summary>Uniform in [min, max).</summary>
    public double Uniform(double min, double max) => min + ((max - min) * Uniform());

    /// <summary>Uniform whole number in [min, max).</summary>
    public int Integer(int min, int max)
    {
        ulong range = (ulong)((long)max - min);
        return (int)(min + (long)(((NextUInt64() >> 32) * range) >> 32));
    }

    /// <summary>True with the given probability.</summary>
    public bool Chance(double probability) => Uniform() < probability;

    /// <summary>Normally distributed (Box and Muller 1958, the cosine of the pair).</summary>
    public double Normal(double mean, double deviation)
    {
        double u = 1.0 - Uniform();
        double v = Uniform();
        return mean + (deviation * Math.Sqrt(-2.0 * PortableMath.Log(u)) * PortableMath.Cos(PortableMath.Tau * v));
    }

    /// <summary>exp of a normal number of mean 0, kept within [min, max].</summary>
    public double LogNormal(double deviation, double min, double max) => Scalar.Clamp(PortableMath.Exp(Normal(0, deviation)), min, max);

    /// <summary>An index drawn with probability proportional to its weight. At least one weight must be positive, none negative.</summary>
    /// <exception cref="ArgumentException">The weights do not add up to a positive number.</exception>
    public int Weighted(ReadOnlySpan<double> weights)
    {
        double total = 0;
        foreach (double w in weights)
        {
            total += w;
        }

        if (!(total > 0))
        {
            throw new ArgumentException("the weights add up to " + total.ToString(System.Globalization.CultureInfo.InvariantCulture) + "; expected a positive sum", nameof(weights));
        }

        double at = Uniform() * total;
        int last = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            if (weights[i] <= 0)
            {
                continue;
            }

            last = i;
            at -= weights[i];
            if (at < 0)
            {
                return i;
            }
        }

        return last;
    }

    private static ulong Rotate(ulong x, int k) => (x << k) | (x >> (64 - k));
}
