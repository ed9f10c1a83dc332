using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Security.Cryptography;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Motion;
using CreatureGen.Png;
using CreatureGen.Sampling;

namespace CreatureGen.Digest;

/// <summary>A line of the golden file of assets: something that is made of a creature besides its plain file, told by a hash.</summary>
/// <param name="What">"textures" for the texels of its three pictures, "png" for the first of them as a file, "clips" for its file with all clips.</param>
/// <param name="Kind">The kind that was asked for.</param>
/// <param name="Seed">The seed.</param>
/// <param name="Sha256">SHA-256 of its bytes, in lower-case hexadecimal digits.</param>
public sealed record AssetEntry(string What, RequestedKind Kind, ulong Seed, string Sha256)
{
    private const int TextureSize = 256;

    /// <summary>What is told of each creature.</summary>
    public static IReadOnlyList<string> All { get; } = new[] { "textures", "png", "clips" };

    /// <summary>The entry as the library would have it now.</summary>
    public static AssetEntry Compute(string what, RequestedKind kind, ulong seed)
    {
        Creature creature = CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind });
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        using var stream = new MemoryStream();
        if (what == "clips")
        {
            GlbWriter.Write(creature, GltfOptions.Default with { Clips = ClipBaker.Bake(creature) }, stream);
        }
        else
        {
            CreatureTextures textures = CreatureTextures.Bake(creature, TextureSize);
            if (what == "png")
            {
                PngEncoder.Write(textures.BaseColour, textures.Size, textures.Size, PngPixels.Rgb, stream);
            }
            else
            {
                stream.Write(textures.BaseColour);
                stream.Write(textures.Normal);
                stream.Write(textures.Roughness);
            }
        }

        hash.AppendData(stream.GetBuffer().AsSpan(0, (int)stream.Length));
        return new AssetEntry(what, kind, seed, Convert.ToHexStringLower(hash.GetHashAndReset()));
    }

    /// <summary>The entries of a golden file in its order; lines that begin with # are remarks.</summary>
    /// <exception cref="FormatException">A line is none of an entry.</exception>
    public static IReadOnlyList<AssetEntry> Parse(string text) =>
        text.ReplaceLineEndings("\n").Split('\n').Where(l => l.Length > 0 && l[0] != '#').Select(ParseLine).ToArray();

    /// <summary>The text of a golden file: the remarks of an old one, then its entries as the library would have them now.</summary>
    public static string Renew(string old) =>
        string.Concat(old.ReplaceLineEndings("\n").Split('\n').Where(l => l.StartsWith('#')).Concat(Parse(old).Select(e => Compute(e.What, e.Kind, e.Seed).ToString())).Select(l => l + "\n"));

    /// <inheritdoc/>
    public override string ToString() => string.Create(CultureInfo.InvariantCulture, $"{What} {Kind} {Seed} {Sha256}");

    private static AssetEntry ParseLine(string line)
    {
        string[] words = line.Split(' ');
        return words.Length == 4 && All.Contains(words[0]) && Enum.TryParse(words[1], out RequestedKind kind) && ulong.TryParse(words[2], NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed)
            ? new AssetEntry(words[0], kind, seed, words[3])
            : throw new FormatException($"\"{line}\"; expected textures, png or clips, kind, seed and SHA-256");
    }
}
