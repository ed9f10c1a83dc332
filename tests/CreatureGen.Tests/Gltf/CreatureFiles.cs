using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Sampling;

namespace CreatureGen.Tests.Gltf;

/// <summary>A creature as a file.</summary>
/// <param name="Name">Name of the file in its folder.</param>
/// <param name="Creature">What was to be written.</param>
/// <param name="Options">How it was to be written.</param>
internal sealed record CreatureFile(string Name, Creature Creature, GltfOptions Options);

/// <summary>The files that other programs are asked about: creatures of seeds, and two made by hand that reach wider indices than seeds do.</summary>
internal static class CreatureFiles
{
    /// <summary>Creatures of each kind.</summary>
    public static int OfEachKind { get; } = Thoroughness.IsExhaustive ? 20 : 3;

    /// <summary>Pairs of legs that every third creature of a kind with legs has at least.</summary>
    public const int ManyPairs = 5;

    /// <summary>Writes them into a folder and tells what they should hold, in order of their names.</summary>
    public static IReadOnlyList<CreatureFile> Write(string folder)
    {
        var files = new List<CreatureFile>();
        foreach (RequestedKind kind in new[] { RequestedKind.Flying, RequestedKind.Swimming, RequestedKind.Walking })
        {
            for (int i = 0; i < OfEachKind; i++)
            {
                // The last seeds are as large as seeds get.
                ulong seed = i < OfEachKind / 2 ? (ulong)i : ulong.MaxValue - (ulong)i;
                CreatureOptions options = OptionsOf(kind, i);
                string name = kind.ToString().ToLowerInvariant() + i.ToString("-000", CultureInfo.InvariantCulture);
                Write(folder, name, CreatureGenerator.Generate(seed, options), options.ToString(), files);
            }
        }

        foreach (SampleShape shape in new[] { Large, ManyJoints })
        {
            Write(folder, "x" + shape.Number.ToString("000", CultureInfo.InvariantCulture), SampleCreature.Build(shape), "made by hand", files);
        }

        return files;
    }

    /// <summary>More vertices than short indices reach.</summary>
    private static SampleShape Large => new(100, Rings: 400, Segments: 170, Fins: 2);

    /// <summary>More joints than bytes number.</summary>
    private static SampleShape ManyJoints => new(101, Rings: 60, Segments: 12, Spine: 290);

    private static CreatureOptions OptionsOf(RequestedKind kind, int number) => CreatureOptions.Default with
    {
        Kind = kind,
        MinLegPairs = kind != RequestedKind.Swimming && number % 3 == 2 ? ManyPairs : 0,
        Ornaments = number % 2 == 0 ? OrnamentLevel.Normal : OrnamentLevel.Rich,
    };

    private static void Write(string folder, string name, Creature creature, string provenance, List<CreatureFile> files)
    {
        foreach (Shading shading in new[] { Shading.Flat, Shading.Smooth })
        {
            var options = new GltfOptions { Shading = shading, Provenance = provenance };
            var file = new CreatureFile(name + "-" + shading.ToString().ToLowerInvariant() + ".glb", creature, options);
            using FileStream stream = File.Create(Path.Combine(folder, file.Name));
            GlbWriter.Write(creature, options, stream);
            files.Add(file);
        }
    }
}
