using System;
using System.Globalization;
using CreatureGen.Maths;

namespace CreatureGen.Seeding;

/// <summary>Random numbers of one node of the seed tree. Not for use by several threads at a time.</summary>
/// <remarks>
/// <para>Based on: D. Blackman and S. Vigna, "Scrambled linear pseudorandom number generators" (2021): xoshiro256**, period 2^256 − 1. The four words of its state are the
/// first four numbers of SplitMix64, mix(seed + k · 9E3779B97F4A7C15) for k = 1..4, with mix as in <see cref="Seed"/>; no two of them are the same, so they are never all zero.</para>
/// <para>Each method says how many 64-bit draws it takes; the number never depends on what is drawn or on the arguments.</para>
/// </remarks>
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
            s0 = Seed.Mix(seed += Seed.GoldenStep);
            s1 = Seed.Mix(seed += Seed.GoldenStep);
            s2 = Seed.Mix(seed += Seed.GoldenStep);
            s3 = Seed.Mix(seed + Seed.GoldenStep);
        }
    }

    /// <summary>Starts from a state of the generator, not all zero.</summary>
    internal RandomStream(ulong state0, ulong state1, ulong state2, ulong state3)
    {
        s0 = state0;
        s1 = state1;
        s2 = state2;
        s3 = state3;
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

    /// <summary>Uniform in [0, 1): one of the 2^53 multiples of 2^−53. One draw.</summary>
    public double Uniform() => (NextUInt64() >> 11) * (1.0 / 9007199254740992.0);

    /// <summary>Uniform in [min, max); max itself only where rounding cannot tell it from a smaller number. One draw.</summary>
    public double Uniform(double min, double max) => min + ((max - min) * Uniform());

    /// <summary>Uniform whole number in [min, max): the draw times (max − min), over 2^64. One draw.</summary>
    /// <exception cref="ArgumentOutOfRangeException">No whole number is at least <paramref name="min"/> and less than <paramref name="max"/>.</exception>
    /// <remarks>No number is more than 2^−32 of its probability likelier than another.</remarks>
    public int Integer(int min, int max)
    {
        if (max <= min)
        {
            throw new ArgumentOutOfRangeException(nameof(max), string.Format(CultureInfo.InvariantCulture, "no whole number is in [{0}, {1}); expected max above min", min, max));
        }

        ulong range = (ulong)((long)max - min);
        ulong bits = NextUInt64();
        ulong high = ((bits >> 32) * range) + (((bits & 0xFFFFFFFFUL) * range) >> 32);
        return (int)(min + (long)(high >> 32));
    }

    /// <summary>True with the given probability; never at 0, always at 1. One draw.</summary>
    public bool Chance(double probability) => Uniform() < probability;

    /// <summary>Normally distributed, at most 8.6 deviations from the mean. Two draws.</summary>
    /// <remarks>Based on: G. Box and M. Muller, "A note on the generation of random normal deviates" (1958), the cosine of the pair.</remarks>
    public double Normal(double mean, double deviation)
    {
        double u = 1.0 - Uniform();
        double v = Uniform();
        return mean + (deviation * Math.Sqrt(-2.0 * PortableMath.Log(u)) * PortableMath.Cos(PortableMath.Tau * v));
    }

    /// <summary>exp of a normal number of mean 0, clamped to [min, max], whose ends take what lies beyond them. Two draws.</summary>
    public double LogNormal(double deviation, double min, double max) => Scalar.Clamp(PortableMath.Exp(Normal(0, deviation)), min, max);

    /// <summary>An index drawn with probability proportional to its weight. One draw.</summary>
    /// <exception cref="ArgumentException">A weight is negative or not finite, or no weight is positive.</exception>
    public int Weighted(ReadOnlySpan<double> weights)
    {
        double total = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            if (!(weights[i] >= 0 && weights[i] <= double.MaxValue))
            {
                throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "weights[{0}] = {1:R}; expected a finite number not below 0", i, weights[i]), nameof(weights));
            }

            total += weights[i];
        }

        if (!(total > 0 && total <= double.MaxValue))
        {
            throw new ArgumentException(string.Format(CultureInfo.InvariantCulture, "the {0} weights add up to {1:R}; expected a positive finite sum", weights.Length, total), nameof(weights));
        }

        double at = Uniform() * total;
        int last = 0;
        for (int i = 0; i < weights.Length; i++)
        {
            if (weights[i] == 0)
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
