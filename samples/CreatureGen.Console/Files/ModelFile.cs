using System.IO;
using CreatureGen.Console.Arguments;
using CreatureGen.Gltf.Models;

namespace CreatureGen.Console.Files;

/// <summary>A skinned character in a .glb file, of whatever program.</summary>
internal static class ModelFile
{
    /// <summary>Reads one.</summary>
    /// <exception cref="UsageError">There is no such file, or it holds no skinned character that can be read.</exception>
    public static SkinnedModel Read(string path, Surroundings surroundings)
    {
        using Stream stream = SourceFile.Open(path, "a .glb file", surroundings);
        ModelReading reading = ModelReader.Read(stream);
        return reading.Model ?? throw new UsageError($"cannot read '{path}': {reading.Problem}");
    }
}
