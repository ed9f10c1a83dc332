using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Gltf;

namespace CreatureGen.Tests.Gltf;

/// <summary>A creature as a file.</summary>
/// <param name="Name">Name of the file in its folder.</param>
/// <param name="Creature">What was to be written.</param>
/// <param name="Options">How it was to be written.</param>
internal sealed record CreatureFile(string Name, Creature Creature, GltfOptions Options);

/// <summary>The files that other programs are asked about.</summary>
internal static class CreatureFiles
{
    /// <summary>Writes them into a folder and tells what they should hold, in order of their names.</summary>
    public static IReadOnlyList<CreatureFile> Write(string folder)
    {
        var files = new List<CreatureFile>();
        foreach (SampleShape shape in Enumerable.Range(0, 33).Select(SampleShape.Of).Append(Large).Append(ManyJoints))
        {
            Creature creature = SampleCreature.Build(shape);
            foreach (Shading shading in new[] { Shading.Flat, Shading.Smooth })
            {
                var options = new GltfOptions { Shading = shading, Provenance = "sample " + shape.Number.ToString(CultureInfo.InvariantCulture) };
                string name = shape.Number.ToString("000", CultureInfo.InvariantCulture) + "-" + shading.ToString().ToLowerInvariant() + ".glb";
                using FileStream stream = File.Create(Path.Combine(folder, name));
                GlbWriter.Write(creature, options, stream);
                files.Add(new CreatureFile(name, creature, options));
            }
        }

        return files;
    }

    /// <summary>More vertices than short indices reach.</summary>
    private static SampleShape Large => new(100, Rings: 400, Segments: 170, Fins: 2);

    /// <summary>More joints than bytes number.</summary>
    private static SampleShape ManyJoints => new(101, Rings: 60, Segments: 12, Spine: 290);
}
