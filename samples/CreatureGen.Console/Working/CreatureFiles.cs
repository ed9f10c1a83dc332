using System;
using System.Collections.Generic;
using System.IO;
using System.Security.Cryptography;
using System.Text;
using System.Threading;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Creatures;
using CreatureGen.Gltf;

namespace CreatureGen.Console.Working;

/// <summary>A file of a creature.</summary>
/// <param name="Form">How its name ends: <c>glb</c>, <c>png</c> or <c>json</c>, before it a word and a dot where there are several of a kind.</param>
/// <param name="Path">Where it is.</param>
/// <param name="Bytes">Its size.</param>
/// <param name="Sha256">Of its content, 64 hexadecimal digits.</param>
internal sealed record CreatureFile(string Form, string Path, int Bytes, string Sha256)
{
    /// <summary>The file of a content.</summary>
    public static CreatureFile Of(string form, string path, byte[] content) => new(form, path, content.Length, Convert.ToHexStringLower(SHA256.HashData(content)));
}

/// <summary>The files of one creature: surface and rig, picture, blueprint.</summary>
internal static class CreatureFiles
{
    /// <summary>The creature's surface, skeleton and skin.</summary>
    public static byte[] Glb(Creature creature, GltfOptions options, ClipChoice clips) => Glb(creature, options with { Clips = clips.Bake(creature, CancellationToken.None) });

    /// <summary>The creature's surface, skeleton, skin, and the motion that is in the options.</summary>
    public static byte[] Glb(Creature creature, GltfOptions options)
    {
        var bytes = new MemoryStream();
        GlbWriter.Write(creature, options, bytes);
        return bytes.ToArray();
    }

    /// <summary>The same options with the atlas painted, where there is to be one: file and picture share it.</summary>
    public static GltfOptions WithAtlas(Creature creature, GltfOptions options) =>
        options.TextureSize == 0 ? options : options with { Textures = CreatureTextures.Bake(creature, options.TextureSize) };

    /// <summary>The creature's blueprint.</summary>
    public static byte[] Json(CreatureBlueprint blueprint) => Encoding.UTF8.GetBytes(BlueprintJson.Write(blueprint));

    /// <summary>Where a file of a creature is.</summary>
    /// <param name="folder">The folder of all.</param>
    /// <param name="name">The creature's name.</param>
    /// <param name="form">Its <see cref="CreatureFile.Form"/>.</param>
    public static string PathOf(string folder, string name, string form) => Path.Combine(folder, $"creature-{name}{(form.Contains('.', StringComparison.Ordinal) ? '-' : '.')}{form}");

    /// <summary>Puts files of a creature into a folder, all or none.</summary>
    /// <exception cref="WriteFailure">One cannot be written.</exception>
    public static IReadOnlyList<CreatureFile> Write(string folder, string name, IEnumerable<(string Form, byte[] Content)> contents, Surroundings surroundings)
    {
        var files = new List<CreatureFile>();
        using var set = new FileSet(surroundings);
        foreach ((string form, byte[] content) in contents)
        {
            string path = PathOf(folder, name, form);
            set.Stage(path, stream => stream.Write(content));
            files.Add(CreatureFile.Of(form, path, content));
        }

        set.Commit();
        return files;
    }
}
