using CreatureGen.Console.Arguments;
using CreatureGen.Creatures;
using CreatureGen.Gltf;

namespace CreatureGen.Console.Verbs;

/// <summary>Options that say how a GLB file is written.</summary>
internal static class ExportOptions
{
    private static readonly OptionSyntax textures = new("--textures", "SIZE", "texture atlas in the GLB, texels along a side: 256, 512, 1024, 2048 or 4096 (default: none, colours in the vertices)");
    private static readonly OptionSyntax levels = new("--levels", "CHOICE", "levels of detail in the GLB: finest (the default), half, quarter, tenth or all (MSFT_lod)");

    /// <summary>All of them.</summary>
    public static OptionSyntax[] Syntax { get; } = [textures, levels, CommonOptions.Flat];

    /// <summary>What was asked for, over what holds otherwise.</summary>
    /// <exception cref="UsageError">A value is none of the known ones.</exception>
    public static GltfOptions Read(ParsedArguments arguments, GltfOptions otherwise) => otherwise with
    {
        Shading = arguments.Has(CommonOptions.Flat.Name) ? Shading.Flat : otherwise.Shading,
        Levels = arguments.Choice(levels.Name, WordList<LevelChoice>.Instance, otherwise.Levels),
        TextureSize = arguments.Value(textures.Name) is null ? otherwise.TextureSize : SizeOf(arguments),
    };

    private static int SizeOf(ParsedArguments arguments)
    {
        int size = arguments.Whole(textures.Name, CreatureTextures.SmallestSize, CreatureTextures.LargestSize, 0);
        return (size & (size - 1)) == 0 ? size : throw arguments.Wrong(textures.Name, arguments.Value(textures.Name)!, "256, 512, 1024, 2048 or 4096");
    }
}
