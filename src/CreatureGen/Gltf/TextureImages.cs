using System;
using System.Collections.Generic;
using CreatureGen.Concurrency;
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

    /// <summary>Number of the roughness, with ambient occlusion in red.</summary>
    public const int Roughness = 2;

    private readonly byte[][] files;

    private TextureImages(byte[][] files) => this.files = files;

    /// <summary>The names of the pictures.</summary>
    public static IReadOnlyList<string> Names { get; } = new[] { "BaseColour", "Normal", "Roughness" };

    /// <summary>The bytes of the PNG files.</summary>
    public IReadOnlyList<byte[]> Files => files;

    /// <summary>Packs an atlas.</summary>
    public static TextureImages Of(CreatureTextures textures)
    {
        var files = new byte[Names.Count][];
        IndependentParts.Run(files.Length, picture => files[picture] = PngEncoder.FileOf(PixelsOf(textures, picture), textures.Size, textures.Size));
        return new TextureImages(files);
    }

    private static ReadOnlySpan<byte> PixelsOf(CreatureTextures textures, int picture) => picture switch
    {
        BaseColour => textures.BaseColour,
        Normal => textures.Normal,
        Roughness => textures.Roughness,
        _ => throw new ArgumentOutOfRangeException(nameof(picture), picture, "expected 0..2"),
    };
}
