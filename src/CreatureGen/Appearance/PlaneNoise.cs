using System;
using System.Numerics;

namespace CreatureGen.Appearance;

/// <summary>The clouds of <see cref="ValueNoise"/> over a plane. It too remembers its last cell, and each thread needs its own.</summary>
internal sealed class PlaneNoise
{
    private readonly uint salt;
    private bool known;
    private int cellX;
    private int cellY;

    /// <summary>At the near and far left corners of the cell, and from there to the right ones.</summary>
    private float near;
    private float far;
    private float nearAcross;
    private float farAcross;

    /// <summary>Chooses the clouds.</summary>
    /// <param name="salt">Which ones.</param>
    public PlaneNoise(int salt) => this.salt = LatticeHash.Salt(salt);

    /// <summary>A value 0..1 at a point; the mean is ½ and one lattice cell is one unit wide.</summary>
    public float At(float x, float y)
    {
        int i = (int)Math.Floor((double)x);
        int j = (int)Math.Floor((double)y);
        if (i != cellX || j != cellY || !known)
        {
            Enter(i, j);
        }

        float u = LatticeHash.Ease(x - i);
        float low = near + (nearAcross * u);
        float high = far + (farAcross * u);
        return low + ((high - low) * LatticeHash.Ease(y - j));
    }

    private void Enter(int x, int y)
    {
        uint x0 = LatticeHash.AlongX(x) ^ salt;
        uint x1 = LatticeHash.AlongX(unchecked(x + 1)) ^ salt;
        uint y0 = LatticeHash.AlongY(y);
        uint y1 = LatticeHash.AlongY(unchecked(y + 1));
        near = LatticeHash.Value(x0 ^ y0);
        far = LatticeHash.Value(x0 ^ y1);
        nearAcross = LatticeHash.Value(x1 ^ y0) - near;
        farAcross = LatticeHash.Value(x1 ^ y1) - far;
        cellX = x;
        cellY = y;
        known = true;
    }
}
