using System;
using System.Collections.Generic;
using System.IO;
using CreatureGen.Creatures;
using CreatureGen.Png;

namespace CreatureGen.Gltf;

/// <summary>The pictures of a creature's atlas as PNG files, in the order of their numbers in the file: base colour, normals, roughness.</summary>
internal sealed class TextureImages
{
    /// <summary>Number of the base colour.</summary>
    public const int BaseColour = 0;

    /// <summary>Number of the normals.</summary>
    public const int Normal = 1;

    /// <summary>Number of the roughness.</summary>
    public const int Roughness = 2;

    private readonly byte[][] files;

    private TextureImages(byte[][] files) => this.files = files;

    /// <summary>The names of the pictures.</summary>
    public static IReadOnlyList<string> Names { get; } = new[] { "BaseColour", "Normal", "Roughness" };

    /// <summary>The bytes of the PNG files.</summary>
    public IReadOnlyList<byte[]> Files => files;

    /// <summary>Paints and packs the atlas.</summary>
    /// <exception cref="ArgumentOutOfRangeException">The size is not a power of two within its range.</exception>
    public static TextureImages Of(Creature creature, int size)
    {
        CreatureTextures textures = CreatureTextures.Bake(creature, size);
        return new TextureImages(new[] { Pack(textures.BaseColour, size), Pack(textures.Normal, size), Pack(textures.Roughness, size) });
    }

    private static byte[] Pack(ReadOnlySpan<byte> pixels, int size)
    {
        using var stream = new MemoryStream();
        PngEncoder.Write(pixels, size, size, PngPixels.Rgb, stream);
        return stream.ToArray();
    }
}
