using System;
using System.Collections.Generic;
using System.IO;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Motion;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;

namespace CreatureGen.Console.Working;

/// <summary>Whether a creature gets its picture.</summary>
internal enum PictureChoice
{
    /// <summary>It does.</summary>
    Portrait,

    /// <summary>It does not.</summary>
    None,
}

/// <summary>A file of a creature.</summary>
/// <param name="Form"><c>glb</c>, <c>png</c> or <c>json</c>, which is also how its name ends.</param>
/// <param name="Path">Where it is.</param>
/// <param name="Bytes">Its size.</param>
internal sealed record CreatureFile(string Form, string Path, int Bytes);

/// <summary>The files of one creature: surface and rig, picture, blueprint.</summary>
internal static class CreatureFiles
{
    private const int PictureWidth = 1024;
    private const int PictureHeight = 768;

    /// <summary>The creature's surface, skeleton and skin.</summary>
    public static byte[] Glb(Creature creature, GltfOptions options, ClipChoice clips)
    {
        GltfOptions moving = clips == ClipChoice.All ? options with { Clips = ClipBaker.Bake(creature) } : options;
        var bytes = new MemoryStream();
        GlbWriter.Write(creature, moving, bytes);
        return bytes.ToArray();
    }

    /// <summary>The same options with the atlas painted, where there is to be one: file and picture share it.</summary>
    public static GltfOptions WithAtlas(Creature creature, GltfOptions options) =>
        options.TextureSize == 0 ? options : options with { Textures = CreatureTextures.Bake(creature, options.TextureSize) };

    /// <summary>The picture of what the file holds.</summary>
    public static byte[] Png(Creature creature, GltfOptions options, int threads)
    {
        Picture picture = Portrait.Take(creature, options.Textures, View.ThreeQuarter, new RenderOptions
        {
            Width = PictureWidth,
            Height = PictureHeight,
            Shading = options.Shading == Shading.Flat ? ShadingMode.Faceted : ShadingMode.Smooth,
            Threads = threads,
        });
        return PngWriter.ToBytes(picture);
    }

    /// <summary>The creature's blueprint.</summary>
    public static byte[] Json(CreatureBlueprint blueprint) => Encoding.UTF8.GetBytes(BlueprintJson.Write(blueprint));

    /// <summary>Puts files of a creature into a folder, all or none.</summary>
    /// <exception cref="WriteFailure">One cannot be written.</exception>
    public static IReadOnlyList<CreatureFile> Write(string folder, string name, IEnumerable<(string Form, byte[] Content)> contents, Surroundings surroundings)
    {
        var files = new List<CreatureFile>();
        using var set = new FileSet(surroundings);
        foreach ((string form, byte[] content) in contents)
        {
            string path = Path.Combine(folder, $"creature-{name}.{form}");
            set.Stage(path, stream => stream.Write(content));
            files.Add(new CreatureFile(form, path, content.Length));
        }

        set.Commit();
        return files;
    }
}
