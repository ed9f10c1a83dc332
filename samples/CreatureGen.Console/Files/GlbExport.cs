using System;
using System.Buffers.Binary;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Console.Files;

/// <summary>With which options GLB files of creatures are written, and were.</summary>
internal static class GlbExport
{
    /// <summary>What holds unless something else is asked for: all that the picture of a creature shows is in its file.</summary>
    public static GltfOptions Default { get; } = GltfOptions.Default with { TextureSize = 1024 };

    private const int LengthOfJson = 12;
    private const int StartOfJson = 20;

    // Deeper than the library reads, which has read it before.
    private const int DeepestJson = 1024;

    /// <summary>Reads a file from which <see cref="GlbReader"/> has read a blueprint.</summary>
    /// <param name="stream">The file, from its beginning.</param>
    /// <param name="clips">The motion in it.</param>
    public static GltfOptions Read(Stream stream, out ClipChoice clips)
    {
        byte[] start = new byte[StartOfJson];
        stream.ReadExactly(start);
        byte[] text = new byte[BinaryPrimitives.ReadUInt32LittleEndian(start.AsSpan(LengthOfJson))];
        stream.ReadExactly(text);
        using JsonDocument document = JsonDocument.Parse(text, new JsonDocumentOptions { MaxDepth = DeepestJson });
        JsonElement root = document.RootElement;
        JsonElement extras = root.GetProperty("asset").GetProperty("extras").GetProperty("creaturegen");
        clips = ClipChoice.OfNames(ClipNames(root));
        return new GltfOptions
        {
            Provenance = Provenance(root),
            Shading = IsFlat(root) ? Shading.Flat : Shading.Smooth,
            Lods = Choice(extras, "levels", LodChoice.Finest),
            Materials = Choice(extras, "materials", MaterialChoice.Two),
            ClipPrecision = extras.TryGetProperty("keys", out JsonElement keys) && keys.ValueKind == JsonValueKind.String ? null : ClipPrecision.Default,
            RootMotion = Choice(extras, "rootMotion", RootMotionChoice.InPlace),
            Engine = Choice(extras, "engine", TargetEngine.Generic),
            TextureSize = extras.TryGetProperty("textureSize", out JsonElement size) && size.ValueKind == JsonValueKind.Number && size.TryGetInt32(out int texels) && IsTextureSize(texels) ? texels : 0,
        };
    }

    private static string[] ClipNames(JsonElement root)
    {
        if (!root.TryGetProperty("animations", out JsonElement animations) || animations.ValueKind != JsonValueKind.Array)
        {
            return [];
        }

        return [.. animations.EnumerateArray().Select(animation => animation.TryGetProperty("name", out JsonElement name) ? name.ToString() : "").Select(name => name.EndsWith("-loop", StringComparison.Ordinal) ? name[..^5] : name).Where(name => name.Length > 0)];
    }

    private static T Choice<T>(JsonElement extras, string name, T otherwise)
        where T : struct, Enum => extras.TryGetProperty(name, out JsonElement word) && Enum.TryParse(word.ToString(), true, out T choice) && Enum.IsDefined(choice) ? choice : otherwise;

    private static bool IsTextureSize(int size) => size is >= CreatureTextures.SmallestSize and <= CreatureTextures.LargestSize && (size & (size - 1)) == 0;

    private static string? Provenance(JsonElement root)
    {
        JsonElement extras = root.GetProperty("asset").GetProperty("extras").GetProperty("creaturegen");
        return extras.TryGetProperty("options", out JsonElement options) && options.ValueKind == JsonValueKind.String ? options.GetString() : null;
    }

    /// <summary>Whether no two corners share a vertex: as many vertices as indices, or no indices at all.</summary>
    private static bool IsFlat(JsonElement root)
    {
        try
        {
            long corners = 0;
            JsonElement accessors = root.GetProperty("accessors");
            JsonElement primitives = root.GetProperty("meshes")[0].GetProperty("primitives");
            long vertices = accessors[primitives[0].GetProperty("attributes").GetProperty("POSITION").GetInt32()].GetProperty("count").GetInt64();
            foreach (JsonElement primitive in primitives.EnumerateArray())
            {
                corners += primitive.TryGetProperty("indices", out JsonElement indices) ? accessors[indices.GetInt32()].GetProperty("count").GetInt64() : 0;
            }

            return corners == 0 || corners == vertices;
        }
        catch (Exception problem) when (problem is KeyNotFoundException or InvalidOperationException or IndexOutOfRangeException or FormatException)
        {
            // Another program has rearranged the file; the creature in it is whole all the same.
            return false;
        }
    }
}
