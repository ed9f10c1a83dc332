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
        uint x0 = LatticeHash.AlongX(x);
        uint x1 = LatticeHash.AlongX(unchecked(x + 1));
        uint y0 = LatticeHash.AlongY(y);
        uint y1 = LatticeHash.AlongY(unchecked(y + 1));
        uint low = LatticeHash.AlongZ(z) ^ LatticeHash.Salt(salt);
        uint high = LatticeHash.AlongZ(unchecked(z + 1)) ^ LatticeHash.Salt(salt);
        float below = Lerp(Edge(x0, x1, y0 ^ low, u), Edge(x0, x1, y1 ^ low, u), v);
        float above = Lerp(Edge(x0, x1, y0 ^ high, u), Edge(x0, x1, y1 ^ high, u), v);
        return Lerp(below, above, w);
    }

    /// <summary>The same over a plane.</summary>
    public static float At(Vector2 point, int salt)
    {
        int x = Floor(point.X);
        int y = Floor(point.Y);
        float u = Ease(point.X - x);
        float v = Ease(point.Y - y);
        uint x0 = LatticeHash.AlongX(x);
        uint x1 = LatticeHash.AlongX(unchecked(x + 1));
        uint rest = LatticeHash.Salt(salt);
        return Lerp(Edge(x0, x1, LatticeHash.AlongY(y) ^ rest, u), Edge(x0, x1, LatticeHash.AlongY(unchecked(y + 1)) ^ rest, u), v);
    }

    private static float Edge(uint x0, uint x1, uint rest, float u) =>
        Lerp(LatticeHash.Unit(LatticeHash.Mix(x0 ^ rest)), LatticeHash.Unit(LatticeHash.Mix(x1 ^ rest)), u);

    private static float Lerp(float a, float b, float t) => a + ((b - a) * t);

    private static float Ease(float x) => x * x * (3f - (2f * x));

    private static int Floor(float x) => (int)Math.Floor((double)x);
}
