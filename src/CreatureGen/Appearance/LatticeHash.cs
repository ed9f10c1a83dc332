using System.Runtime.CompilerServices;

namespace CreatureGen.Appearance;

/// <summary>Random numbers of the cells of an integer lattice: the same cell always has the same number, whatever the order of questions.</summary>
internal static class LatticeHash
{
    /// <summary>32 well mixed bits of a cell; any signs of the coordinates.</summary>
    public static uint Bits(int x, int y, int z, int salt) => Mix(AlongX(x) ^ AlongY(y) ^ AlongZ(z) ^ Salt(salt));

    /// <summary>Part of a cell's bits before mixing; neighbours share it.</summary>
    public static uint AlongX(int x) => unchecked((uint)x * 0x8DA6B343u);

    /// <summary>Part of a cell's bits before mixing; neighbours share it.</summary>
    public static uint AlongY(int y) => unchecked((uint)y * 0xD8163841u);

    /// <summary>Part of a cell's bits before mixing; neighbours share it.</summary>
    public static uint AlongZ(int z) => unchecked((uint)z * 0xCB1AB31Fu);

    /// <summary>Part of all cells' bits before mixing.</summary>
    public static uint Salt(int salt) => unchecked((uint)salt * 0x9E3779B9u);

    /// <summary>Mixes the exclusive or of the four parts, or other bits for one more number of the same cell.</summary>
    /// <remarks>Mixing steps of C. Wellons, "Prospecting for hash functions" (2018), lowbias32.</remarks>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static uint Mix(uint h)
    {
        unchecked
        {
            h += 0x9E3779B9u;
            h ^= h >> 16;
            h *= 0x7FEB352Du;
            h ^= h >> 15;
            h *= 0x846CA68Bu;
            return h ^ (h >> 16);
        }
    }

    /// <summary>The upper 24 bits as a number 0..1, 1 excluded.</summary>
    public static float Unit(uint bits) => (int)(bits >> 8) * (1f / 16777216f);

    /// <summary>The number 0..1 of a point of the lattice, from the exclusive or of its parts.</summary>
    public static float Value(uint parts) => Unit(Mix(parts));

    /// <summary>Eases the way 0..1 from one point of the lattice to the next: level at both.</summary>
    public static float Ease(float x) => x * x * (3f - (2f * x));
}
