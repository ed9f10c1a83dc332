using System;
using System.Numerics;

namespace CreatureGen.Appearance;

/// <summary>Smooth random clouds: random values at the points of an integer lattice, eased between them.</summary>
/// <remarks>
/// It remembers the corners of the last cell, because one place after another mostly lies in the same cell: what it answers does not depend on that, but each thread needs its own.
/// </remarks>
internal sealed class ValueNoise
{
    private readonly uint salt;
    private bool known;
    private int cellX;
    private int cellY;
    private int cellZ;

    /// <summary>At the left ends of the cell's four edges along x (near low, far low, near high, far high) and from there to the right ends.</summary>
    private Vector4 left;
    private Vector4 across;

    /// <summary>Chooses the clouds.</summary>
    /// <param name="salt">Which ones.</param>
    public ValueNoise(int salt) => this.salt = LatticeHash.Salt(salt);

    /// <summary>A value 0..1 at a point; the mean is ½ and one lattice cell is one unit wide.</summary>
    public float At(Vector3 point)
    {
        int x = Floor(point.X);
        int y = Floor(point.Y);
        int z = Floor(point.Z);
        if (x != cellX || y != cellY || z != cellZ || !known)
        {
            Enter(x, y, z);
        }

        Vector4 edges = left + (across * new Vector4(LatticeHash.Ease(point.X - x)));
        float v = LatticeHash.Ease(point.Y - y);
        return Lerp(Lerp(edges.X, edges.Y, v), Lerp(edges.Z, edges.W, v), LatticeHash.Ease(point.Z - z));
    }

    private void Enter(int x, int y, int z)
    {
        uint x0 = LatticeHash.AlongX(x) ^ salt;
        uint x1 = LatticeHash.AlongX(unchecked(x + 1)) ^ salt;
        uint y0 = LatticeHash.AlongY(y);
        uint y1 = LatticeHash.AlongY(unchecked(y + 1));
        uint z0 = LatticeHash.AlongZ(z);
        uint z1 = LatticeHash.AlongZ(unchecked(z + 1));
        left = new Vector4(LatticeHash.Value(x0 ^ y0 ^ z0), LatticeHash.Value(x0 ^ y1 ^ z0), LatticeHash.Value(x0 ^ y0 ^ z1), LatticeHash.Value(x0 ^ y1 ^ z1));
        across = new Vector4(LatticeHash.Value(x1 ^ y0 ^ z0), LatticeHash.Value(x1 ^ y1 ^ z0), LatticeHash.Value(x1 ^ y0 ^ z1), LatticeHash.Value(x1 ^ y1 ^ z1)) - left;
        cellX = x;
        cellY = y;
        cellZ = z;
        known = true;
    }

    private static float Lerp(float a, float b, float t) => a + ((b - a) * t);

    private static int Floor(float x) => (int)Math.Floor((double)x);
}
