using System;
using System.Text;

namespace CreatureGen.Seeding;

/// <summary>A node of the seed tree: children are found by name, so that a new child never changes another.</summary>
public readonly struct Seed : IEquatable<Seed>
{
    /// <summary>The root of a tree.</summary>
    public Seed(ulong value) => Value = value;

    /// <summary>The 64 bits of this node.</summary>
    public ulong Value { get; }

    /// <summary>The child with the given name.</summary>
    public Seed Child(string name)
    {
        ulong hash = 14695981039346656037UL;
        foreach (byte b in Encoding.UTF8.GetBytes(name))
        {
            hash = unchecked((hash ^ b) * 1099511628211UL);
        }

        return new Seed(Mix(unchecked(Value + (hash * 0x9E3779B97F4A7C15UL))));
    }

    /// <summary>The child with the given number.</summary>
    public Seed Child(int index) => new(Mix(unchecked(Value ^ (((ulong)(uint)index + 1) * 0xD1B54A32D192ED03UL))));

    /// <summary>The random numbers of this node.</summary>
    public RandomStream Stream() => new(Value);

    /// <inheritdoc/>
    public bool Equals(Seed other) => Value == other.Value;

    /// <inheritdoc/>
    public override bool Equals(object? obj) => obj is Seed other && Equals(other);

    /// <inheritdoc/>
    public override int GetHashCode() => unchecked((int)(Value ^ (Value >> 32)));

    internal static ulong Mix(ulong z)
    {
        unchecked
        {
            z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9UL;
            z = (z ^ (z >> 27)) * 0x94D049BB133111EBUL;
            return z ^ (z >> 31);
        }
    }
}
