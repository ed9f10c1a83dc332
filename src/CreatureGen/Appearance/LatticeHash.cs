namespace CreatureGen.Appearance;

/// <summary>Random numbers of the cells of an integer lattice: the same cell always has the same number, whatever the order of questions.</summary>
internal static class LatticeHash
{
    /// <summary>32 well mixed bits of a cell; any signs of the coordinates.</summary>
    /// <remarks>Mixing steps of C. Wellons, "Prospecting for hash functions" (2018), lowbias32.</remarks>
    public static uint Bits(int x, int y, int z, int salt)
    {
        unchecked
        {
            uint h = ((uint)x * 0x8DA6B343u) ^ ((uint)y * 0xD8163841u) ^ ((uint)z * 0xCB1AB31Fu) ^ ((uint)salt * 0x9E3779B9u);
            return Mix(h);
        }
    }

    /// <summary>The bits that follow some others, for a second number of the same cell.</summary>
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
    public static float Unit(uint bits) => (bits >> 8) * (1f / 16777216f);
}
