using System;

namespace CreatureGen.Appearance.Textures;

/// <summary>Scattered middles of plates, one in each cell of a plane's lattice, and how far a place is from the seam between two of them.</summary>
/// <remarks>It remembers the middles around the last cell: what it answers does not depend on that, but each thread needs its own.</remarks>
internal sealed class PlateCentres
{
    private const int Nearest = 9;

    private readonly int salt;
    private readonly float[] alongX = new float[Nearest];
    private readonly float[] alongY = new float[Nearest];
    private bool known;
    private int cellX;
    private int cellY;

    /// <summary>Scatters the middles.</summary>
    /// <param name="salt">Which scatter.</param>
    public PlateCentres(int salt) => this.salt = salt;

    /// <summary>By how much the second nearest middle is farther away than the nearest, in cells: 0 on a seam.</summary>
    public float Gap(float x, float y)
    {
        int i = (int)Math.Floor(x - 0.5);
        int j = (int)Math.Floor(y - 0.5);
        if (i != cellX || j != cellY || !known)
        {
            Enter(i, j);
        }

        float first = float.MaxValue;
        float second = float.MaxValue;
        for (int k = 0; k < Nearest; k++)
        {
            float dx = alongX[k] - x;
            float dy = alongY[k] - y;
            float squared = (dx * dx) + (dy * dy);
            float farther = squared > first ? squared : first;
            second = farther < second ? farther : second;
            first = squared < first ? squared : first;
        }

        return (float)Math.Sqrt(second) - (float)Math.Sqrt(first);
    }

    private void Enter(int x, int y)
    {
        for (int k = 0; k < Nearest; k++)
        {
            int column = x + (k % 3);
            int row = y + (k / 3);
            uint bits = LatticeHash.Bits(column, row, 0, salt);
            alongX[k] = column + 0.2f + (0.6f * LatticeHash.Unit(bits));
            alongY[k] = row + 0.2f + (0.6f * LatticeHash.Unit(LatticeHash.Mix(bits)));
        }

        cellX = x;
        cellY = y;
        known = true;
    }
}
