using System;
using System.Numerics;

namespace CreatureGen.Appearance;

/// <summary>Smooth random clouds: random values at the points of an integer lattice, eased between them.</summary>
internal static class ValueNoise
{
    /// <summary>A value 0..1 at a point; the mean is ½ and one lattice cell is one unit wide.</summary>
    public static float At(Vector3 point, int salt)
    {
        int x = Floor(point.X);
        int y = Floor(point.Y);
        int z = Floor(point.Z);
        float u = Ease(point.X - x);
        float v = Ease(point.Y - y);
        float w = Ease(point.Z - z);
        float low = Layer(x, y, z, salt, u, v);
        float high = Layer(x, y, unchecked(z + 1), salt, u, v);
        return low + ((high - low) * w);
    }

    private static float Layer(int x, int y, int z, int salt, float u, float v)
    {
        int x1 = unchecked(x + 1);
        int y1 = unchecked(y + 1);
        float a = LatticeHash.Unit(LatticeHash.Bits(x, y, z, salt));
        float b = LatticeHash.Unit(LatticeHash.Bits(x1, y, z, salt));
        float c = LatticeHash.Unit(LatticeHash.Bits(x, y1, z, salt));
        float d = LatticeHash.Unit(LatticeHash.Bits(x1, y1, z, salt));
        float near = a + ((b - a) * u);
        float far = c + ((d - c) * u);
        return near + ((far - near) * v);
    }

    private static float Ease(float x) => x * x * (3f - (2f * x));

    private static int Floor(float x) => (int)Math.Floor((double)x);
}
