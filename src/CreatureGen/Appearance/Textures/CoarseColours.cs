using System;
using System.Buffers;
using System.Numerics;

namespace CreatureGen.Appearance.Textures;

/// <summary>The coat alone at half the size of an atlas. Its finest edges are several texels of a large atlas wide, which takes its colours from between these.</summary>
internal sealed class CoarseColours : IDisposable
{
    /// <summary>Shares of the nearest texel, of the two beside it and of the one across, for a place a quarter of a texel off on both axes.</summary>
    private const float Nearest = 9f / 16f, Beside = 3f / 16f, Across = 1f / 16f;

    private readonly int size;

    /// <summary>Linear RGB, and 1 where there is one.</summary>
    private readonly Vector4[] texels;

    /// <summary>From so many texels a side on, the coat of an atlas is worked out at half its size.</summary>
    public const int MinAtlas = 1024;

    /// <summary>No colours yet, for an atlas of so many texels a side.</summary>
    public CoarseColours(int atlasSize)
    {
        size = atlasSize / 2;
        texels = ArrayPool<Vector4>.Shared.Rent(size * size);
        Array.Clear(texels, 0, size * size);
    }

    /// <inheritdoc/>
    public void Dispose() => ArrayPool<Vector4>.Shared.Return(texels);

    /// <summary>Texels along a side: half as many as the atlas has.</summary>
    public int Size => size;

    /// <summary>Whether a texel has its colour.</summary>
    public bool Has(int x, int y) => texels[(y * size) + x].W != 0f;

    /// <summary>Sets a texel.</summary>
    public void Set(int x, int y, Vector3 colour) => texels[(y * size) + x] = new Vector4(colour, 1f);

    /// <summary>The colour of a texel of the atlas; false where one of the four around its middle has none.</summary>
    public bool TryRead(int x, int y, out Vector3 colour)
    {
        int column = x >> 1;
        int row = y >> 1;
        int aside = (x & 1) == 0 ? column - 1 : column + 1;
        int over = (y & 1) == 0 ? row - 1 : row + 1;
        if ((uint)aside >= (uint)size || (uint)over >= (uint)size)
        {
            colour = default;
            return false;
        }

        Vector4 mix = (texels[(row * size) + column] * Nearest) + ((texels[(row * size) + aside] + texels[(over * size) + column]) * Beside) + (texels[(over * size) + aside] * Across);
        colour = new Vector3(mix.X, mix.Y, mix.Z);
        return mix.W == 1f;
    }
}
