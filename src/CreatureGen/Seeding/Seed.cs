using System;
using System.Globalization;

namespace CreatureGen.Seeding;

/// <summary>A node of the seed tree: children are found by name, so that a new child never changes another.</summary>
/// <remarks>
/// <para>All arithmetic is on 64-bit unsigned numbers, modulo 2^64. With</para>
/// <code>
/// mix(z):  z = (z xor (z &gt;&gt; 30)) · BF58476D1CE4E5B9
///          z = (z xor (z &gt;&gt; 27)) · 94D049BB133111EB
///          z xor (z &gt;&gt; 31)
/// fnv(s):  h = CBF29CE484222325; for each byte b of s in UTF-8: h = (h xor b) · 100000001B3
/// </code>
/// <para>the child of v by the name s has the value mix(v + fnv(s) · 9E3779B97F4A7C15), and its child by the number i has
/// mix(v xor ((i mod 2^32) + 1) · D1B54A32D192ED03). Names are taken as they are, without Unicode normalisation; half of a surrogate pair counts as U+FFFD.</para>
/// <para>Based on: G. Steele, D. Lea and C. Flood, "Fast splittable pseudorandom number generators" (2014), for mix (SplitMix64 with D. Stafford's constants);
/// G. Fowler, L. C. Noll, K.-P. Vo, "The FNV non-cryptographic hash algorithm", FNV-1a of 64 bits.</para>
/// </remarks>
public readonly struct Seed : IEquatable<Seed>
{
    /// <summary>The odd whole number nearest to 2^64 over the golden ratio: the step of SplitMix64.</summary>
    internal const ulong GoldenStep = 0x9E3779B97F4A7C15UL;

    private const ulong NumberStep = 0xD1B54A32D192ED03UL;
    private const ulong FnvOffset = 0xCBF29CE484222325UL;
    private const ulong FnvPrime = 0x100000001B3UL;

    /// <summary>The root of a tree. Any value will do; neighbouring values give unrelated trees.</summary>
    public Seed(ulong value) => Value = value;

    /// <summary>The 64 bits of this node.</summary>
    public ulong Value { get; }

    /// <summary>Whether two nodes are the same.</summary>
    public static bool operator ==(Seed left, Seed right) => left.Value == right.Value;

    /// <summary>Whether two nodes differ.</summary>
    public static bool operator !=(Seed left, Seed right) => left.Value != right.Value;

    /// <summary>The child with the given name.</summary>
    /// <exception cref="ArgumentNullException"><paramref name="name"/> is null.</exception>
    public Seed Child(string name) => new(Mix(unchecked(Value + (Hash(name) * GoldenStep))));

    /// <summary>The child with the given number, for things that are counted rather than named. Every whole number has its own.</summary>
    public Seed Child(int index) => new(Mix(unchecked(Value ^ (((ulong)(uint)index + 1) * NumberStep))));

    /// <summary>The random numbers of this node, from their beginning.</summary>
    public RandomStream Stream() => new(Value);

    /// <inheritdoc/>
    public bool Equals(Seed other) => Value == other.Value;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Seed other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((int)(Value ^ (Value >> 32)));

    /// <summary>The value in 16 hexadecimal digits.</summary>
    public override string ToString() => Value.ToString("x16", CultureInfo.InvariantCulture);

    internal static ulong Mix(ulong z)
    {
        unchecked
        {
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
            return z ^ (z >> 31);
        }
    }

    /// <summary>FNV-1a of the text in UTF-8.</summary>
    internal static ulong Hash(string text)
    {
        if (text is null)
        {
            throw new ArgumentNullException(nameof(text));
        }

        ulong hash = FnvOffset;
        for (int i = 0; i < text.Length; i++)
        {
            uint code = text[i];
            if (code < 0x80)
            {
                hash = Add(hash, code);
                continue;
            }

            if (char.IsSurrogate(text[i]))
            {
                if (char.IsHighSurrogate(text[i]) && i + 1 < text.Length && char.IsLowSurrogate(text[i + 1]))
                {
                    code = (uint)char.ConvertToUtf32(text[i], text[i + 1]);
                    i++;
                }
                else
                {
                    code = 0xFFFD;
                }
            }

            if (code < 0x800)
            {
                hash = Add(hash, 0xC0 | (code >> 6));
            }
            else
            {
                if (code < 0x10000)
                {
                    hash = Add(hash, 0xE0 | (code >> 12));
                }
                else
                {
                    hash = Add(hash, 0xF0 | (code >> 18));
                    hash = Add(hash, 0x80 | ((code >> 12) & 0x3F));
                }

                hash = Add(hash, 0x80 | ((code >> 6) & 0x3F));
            }

            hash = Add(hash, 0x80 | (code & 0x3F));
        }

        return hash;
    }

    private static ulong Add(ulong hash, uint octet) => unchecked((hash ^ octet) * FnvPrime);
}
