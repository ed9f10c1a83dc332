using System.Globalization;
using System.Numerics;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Motion.Toolkit;

namespace CreatureGen.Console.Verbs;

/// <summary>Options that say how a GLB file is written.</summary>
internal static class ExportOptions
{
    private static readonly OptionSyntax textures = new("--textures", "SIZE", "texture atlas in the GLB, texels along a side: 256, 512, 1024 (the default), 2048 or 4096; none: colours in the vertices, as with --flat") { Words = ["none", "256", "512", "1024", "2048", "4096"] };
    private static readonly OptionSyntax levels = new("--levels", "CHOICE", "levels of detail in the GLB: finest (the default), half, quarter, tenth or all (MSFT_lod)") { Words = WordList<LodChoice>.Instance.All };
    private static readonly OptionSyntax materials = new("--materials", "CHOICE", "materials in the GLB at most: two (the default: solid skin, double-sided membrane) or one, double-sided, for a single draw call") { Words = WordList<MaterialChoice>.Instance.All };

    /// <summary>Which motion.</summary>
    public static readonly OptionSyntax Clips = new("--clips", "NAMES", "the creature's motion as clips: all that it does, or names with commas between, such as idle,walk,turn-left,bite; what a creature cannot do is left out (default: none)") { Words = ["none", "all"] };
    private static readonly OptionSyntax rootMotion = new("--root-motion", "CHOICE", "with --clips: in-place, the game moves the creature (the default), or travels, its root joint does") { Words = ["in-place", "travels"] };
    private static readonly OptionSyntax keys = new("--keys", "CHOICE", "with --clips: reduced, no more than motion within a tenth of a millimetre takes (the default), or all, those of every frame") { Words = ["reduced", "all"] };
    private static readonly OptionSyntax engine = new("--engine", "ENGINE", "with --clips: whose importer the names and extras of clips are for: generic (the default), godot, unity or unreal") { Words = WordList<TargetEngine>.Instance.All };

    /// <summary>All of them.</summary>
    public static OptionSyntax[] Syntax { get; } = [textures, levels, materials, Clips, rootMotion, keys, engine, CommonOptions.Flat];

    /// <summary>Which motion is to be in the file.</summary>
    /// <exception cref="UsageError">A value is none of the known ones.</exception>
    public static ClipChoice ReadClips(ParsedArguments arguments, ClipChoice otherwise) =>
        arguments.Value(Clips.Name) is string text ? ClipChoice.Read(text, expected => arguments.Wrong(Clips.Name, text, expected)) : otherwise;

    /// <summary>What was asked for, over what holds otherwise.</summary>
    /// <exception cref="UsageError">A value is none of the known ones.</exception>
    public static GltfOptions Read(ParsedArguments arguments, GltfOptions otherwise) => otherwise with
    {
        Shading = arguments.Has(CommonOptions.Flat.Name) ? Shading.Flat : otherwise.Shading,
        Lods = arguments.Choice(levels.Name, WordList<LodChoice>.Instance, otherwise.Lods),
        Materials = arguments.Choice(materials.Name, WordList<MaterialChoice>.Instance, otherwise.Materials),
        ClipPrecision = arguments.Value(keys.Name) switch
        {
            null => otherwise.ClipPrecision,
            "reduced" => ClipPrecision.Default,
            "all" => null,
            string other => throw arguments.Wrong(keys.Name, other, "reduced or all"),
        },
        RootMotion = arguments.Value(rootMotion.Name) switch
        {
            null => otherwise.RootMotion,
            "in-place" => RootMotionChoice.InPlace,
            "travels" => RootMotionChoice.Travels,
            string other => throw arguments.Wrong(rootMotion.Name, other, "in-place or travels"),
        },
        Engine = arguments.Choice(engine.Name, WordList<TargetEngine>.Instance, otherwise.Engine),
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
