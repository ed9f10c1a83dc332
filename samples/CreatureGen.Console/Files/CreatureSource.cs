using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Pictures;

namespace CreatureGen.Console.Files;

/// <summary>What a file is in which a creature is kept.</summary>
internal enum SourceForm
{
    /// <summary>A blueprint as JSON.</summary>
    Blueprint,

    /// <summary>A creature as GLB.</summary>
    Glb,

    /// <summary>A picture that holds a blueprint.</summary>
    Picture,
}

/// <summary>A file in which a creature is kept.</summary>
/// <param name="Path">Where it is.</param>
/// <param name="Form">What it is.</param>
/// <param name="Bytes">Its size.</param>
/// <param name="Blueprint">The creature.</param>
/// <param name="Export">How the creature was written as GLB, and would be again.</param>
/// <param name="Clips">Whether its motion was written too.</param>
internal sealed record CreatureSource(string Path, SourceForm Form, long Bytes, CreatureBlueprint Blueprint, GltfOptions Export, ClipChoice Clips)
{
    private const string Expectation = "a blueprint (.json) or a creature (.glb) written by creaturegen, or a picture (.png) of the creature lab";

    /// <summary>What was read, if it cannot be read again.</summary>
    private byte[]? Content { get; init; }

    /// <summary>Reads a file, whatever its name, by what it begins with.</summary>
    /// <param name="operand">What somebody typed: a path, or <c>-</c> for the standard input.</param>
    /// <param name="surroundings">Where paths start, and the standard input.</param>
    /// <exception cref="UsageError">It cannot be read; the message tells all that is wrong with it.</exception>
    public static CreatureSource Read(string operand, Surroundings surroundings) => Read(operand, surroundings, reading => reading.Blueprint);

    /// <summary>Reads a file for a repair: what can be read of its blueprint will do, whatever is wrong with it.</summary>
    /// <param name="operand">What somebody typed: a path, or <c>-</c> for the standard input.</param>
    /// <param name="surroundings">Where paths start, and the standard input.</param>
    /// <exception cref="UsageError">There is nothing in it that could be repaired; the message tells all that is wrong with it.</exception>
    public static CreatureSource ReadDraft(string operand, Surroundings surroundings) => Read(operand, surroundings, reading => reading.Draft);

    private static CreatureSource Read(string operand, Surroundings surroundings, Func<BlueprintReading, CreatureBlueprint?> take)
    {
        string path = surroundings.Locate(operand);
        try
        {
            using Stream stream = SourceFile.Open(path, Expectation, surroundings);
            CreatureSource source = Begins(stream, "glTF"u8) || path.EndsWith(".glb", StringComparison.OrdinalIgnoreCase) ? ReadGlb(path, stream, take)
                : Begins(stream, [0x89, (byte)'P', (byte)'N', (byte)'G']) ? ReadPicture(path, stream, take)
                : ReadBlueprint(path, stream, take);
            return stream is MemoryStream memory ? source with { Content = memory.ToArray() } : source;
        }
        catch (Exception problem) when (Reason.IsOfFiles(problem))
        {
            throw new UsageError($"cannot read '{path}': {Reason.Of(problem)}; expected {Expectation}");
        }
    }

    /// <summary>Whether the file is, byte for byte, what would be written for a creature now.</summary>
    public bool IsWhatWouldBeWritten(Creature creature)
    {
        byte[] expected = CreatureFiles.Glb(creature, Export, Clips);
        return expected.Length == Bytes && (Content ?? File.ReadAllBytes(Path)).AsSpan().SequenceEqual(expected);
    }

    private static bool Begins(Stream stream, ReadOnlySpan<byte> with)
    {
        Span<byte> start = stackalloc byte[4];
        int read = stream.ReadAtLeast(start, start.Length, throwOnEndOfStream: false);
        stream.Position = 0;
        return start[..read].SequenceEqual(with);
    }

    private static CreatureSource ReadGlb(string path, Stream stream, Func<BlueprintReading, CreatureBlueprint?> take)
    {
        CreatureBlueprint blueprint = Require(path, "creature", GlbReader.ReadBlueprint(stream), take);
        stream.Position = 0;
        GltfOptions export = GlbExport.Read(stream, out ClipChoice clips);
        return new CreatureSource(path, SourceForm.Glb, stream.Length, blueprint, export, clips);
    }

    private static CreatureSource ReadBlueprint(string path, Stream stream, Func<BlueprintReading, CreatureBlueprint?> take) =>
        new(path, SourceForm.Blueprint, stream.Length, Require(path, "blueprint", BlueprintJson.Read(stream), take), GlbExport.Default, ClipChoice.None);

    private static CreatureSource ReadPicture(string path, Stream stream, Func<BlueprintReading, CreatureBlueprint?> take) =>
        new(path, SourceForm.Picture, stream.Length, Require(path, "creature", BlueprintPicture.Read(stream), take), GlbExport.Default, ClipChoice.None);

    private static CreatureBlueprint Require(string path, string what, BlueprintReading reading, Func<BlueprintReading, CreatureBlueprint?> take) =>
        take(reading) ?? throw new UsageError($"'{path}' holds no {what} that can be built:", reading.Problems.Select(problem => problem.ToString()));
}
