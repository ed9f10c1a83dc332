using System;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Preview.Pictures;
using CreatureGen.Preview.Png;
using CreatureGen.Preview.Rendering;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;

namespace CreatureGen.Lab;

/// <summary>Pictures by the library's own renderer, for browsers that cannot run the page.</summary>
internal static class Stills
{
    /// <summary>Where they are, below the page.</summary>
    public const string FolderName = "stills";

    private const int Width = 360;
    private const int Height = 300;

    private static readonly (ulong Seed, RequestedKind Kind)[] shown =
    [
        (3, RequestedKind.Walking), (7, RequestedKind.Walking), (12, RequestedKind.Walking), (22, RequestedKind.Walking), (31, RequestedKind.Walking), (42, RequestedKind.Walking),
        (2, RequestedKind.Flying), (5, RequestedKind.Flying), (9, RequestedKind.Flying), (4, RequestedKind.Swimming), (8, RequestedKind.Swimming), (15, RequestedKind.Swimming),
    ];

    /// <summary>Draws them all, and a list of them.</summary>
    public static void Write(string folder)
    {
        Directory.CreateDirectory(folder);
        var list = shown.Select(one => new { seed = one.Seed, kind = one.Kind.ToString().ToLowerInvariant(), file = FormattableString.Invariant($"{one.Seed}-{one.Kind.ToString().ToLowerInvariant()}.png") }).ToArray();
        foreach (((ulong seed, RequestedKind kind), string file) in shown.Zip(list.Select(one => one.file)))
        {
            Picture picture = Portrait.Take(CreatureGenerator.Generate(seed, CreatureOptions.Default with { Kind = kind }), View.ThreeQuarter, new RenderOptions { Width = Width, Height = Height });
            File.WriteAllBytes(Path.Combine(folder, file), PngWriter.ToBytes(picture));
        }

        File.WriteAllText(Path.Combine(folder, "list.json"), JsonSerializer.Serialize(list));
    }
}
