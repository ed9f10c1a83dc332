using System.Globalization;
using System.Numerics;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Creatures;
using CreatureGen.Gltf;

namespace CreatureGen.Console.Verbs;

/// <summary>Options that say how a GLB file is written.</summary>
internal static class ExportOptions
{
    private static readonly OptionSyntax textures = new("--textures", "SIZE", "texture atlas in the GLB, texels along a side: 256, 512, 1024 (the default), 2048 or 4096; none: colours in the vertices, as with --flat") { Words = ["none", "256", "512", "1024", "2048", "4096"] };
    private static readonly OptionSyntax levels = new("--levels", "CHOICE", "levels of detail in the GLB: finest (the default), half, quarter, tenth or all (MSFT_lod)") { Words = WordList<LodChoice>.Instance.All };
    private static readonly OptionSyntax materials = new("--materials", "CHOICE", "materials in the GLB at most: two (the default: solid skin, double-sided membrane) or one, double-sided, for a single draw call") { Words = WordList<MaterialChoice>.Instance.All };

    private static readonly OptionSyntax clips = new("--clips", "all", "the creature's motion as clips: idle, every gait, flight, swimming, crawling (default: none)") { Words = ["none", "all"] };

    /// <summary>All of them.</summary>
    public static OptionSyntax[] Syntax { get; } = [textures, levels, materials, clips, CommonOptions.Flat];

    /// <summary>Whether motion is to be in the file.</summary>
    /// <exception cref="UsageError">A value is none of the known ones.</exception>
    public static ClipChoice ReadClips(ParsedArguments arguments, ClipChoice otherwise) => arguments.Value(clips.Name) switch
    {
        null => otherwise,
        "none" => ClipChoice.None,
        "all" => ClipChoice.All,
        string other => throw arguments.Wrong(clips.Name, other, "all or none"),
    };

    /// <summary>What was asked for, over what holds otherwise.</summary>
    /// <exception cref="UsageError">A value is none of the known ones.</exception>
    public static GltfOptions Read(ParsedArguments arguments, GltfOptions otherwise) => otherwise with
    {
        Shading = arguments.Has(CommonOptions.Flat.Name) ? Shading.Flat : otherwise.Shading,
        Lods = arguments.Choice(levels.Name, WordList<LodChoice>.Instance, otherwise.Lods),
        Materials = arguments.Choice(materials.Name, WordList<MaterialChoice>.Instance, otherwise.Materials),
        TextureSize = SizeOf(arguments, arguments.Has(CommonOptions.Flat.Name) ? 0 : otherwise.TextureSize),
    };

    private static int SizeOf(ParsedArguments arguments, int otherwise) => arguments.Value(textures.Name) switch
    {
        null => otherwise,
        "none" => 0,
        string text => int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int size) && BitOperations.IsPow2(size) && size is >= CreatureTextures.SmallestSize and <= CreatureTextures.LargestSize
            ? size
            : throw arguments.Wrong(textures.Name, text, "none, 256, 512, 1024, 2048 or 4096"),
    };
}
