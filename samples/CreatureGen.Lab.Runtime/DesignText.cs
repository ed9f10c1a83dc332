using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using CreatureGen.Blueprints;
using CreatureGen.Gltf;
using CreatureGen.Motion;
using CreatureGen.Sampling;

namespace CreatureGen.Lab.Runtime;

/// <summary>What the page says of a creature, read strictly.</summary>
internal static class DesignText
{
    /// <summary>Texel of the atlas of files that are taken home.</summary>
    private const int FileTextureSize = 512;

    public static ulong Seed(string seed) =>
        ulong.TryParse(seed, NumberStyles.None, CultureInfo.InvariantCulture, out ulong value)
            ? value
            : throw new ArgumentException("\u201c" + Short(seed) + "\u201d is no seed; expected a whole number from 0 to 18446744073709551615");

    /// <param name="seed">Of the creature, or of its species.</param>
    /// <param name="kind">How it gets about.</param>
    /// <param name="strangeness">0..1.</param>
    /// <param name="individual">Which one of the species; empty for the creature of the seed itself.</param>
    public static CreatureBlueprint Sample(string seed, string kind, double strangeness, string individual) =>
        BlueprintSampler.Sample(Seed(seed), CreatureOptions.Default with { Kind = Kind(kind), Strangeness = strangeness, Individual = individual.Length > 0 ? Seed(individual) : null });

    public static CreatureBlueprint Read(string blueprint) => Require(BlueprintJson.Read(blueprint));

    /// <summary>The blueprint, or what is wrong with it.</summary>
    public static CreatureBlueprint Require(BlueprintReading reading)
    {
        if (reading.Blueprint != null)
        {
            return reading.Blueprint;
        }

        IEnumerable<string> told = reading.Problems.Take(3).Select(problem => problem.ToString());
        string more = reading.Problems.Count > 3 ? FormattableString.Invariant($"\nand {reading.Problems.Count - 3} more") : "";
        throw new ArgumentException(string.Join('\n', told) + more);
    }

    /// <summary>How a file is written: <c>plain</c>, or <c>whole</c> with textures and clips.</summary>
    public static GltfOptions Files(string what, Actor actor) => what == "whole"
        ? GltfOptions.Default with { TextureSize = FileTextureSize, Clips = ClipBaker.Bake(actor.Creature) }
        : GltfOptions.Default;

    private static RequestedKind Kind(string kind) => kind switch
    {
        "any" => RequestedKind.Any,
        "walking" => RequestedKind.Walking,
        "flying" => RequestedKind.Flying,
        "swimming" => RequestedKind.Swimming,
        _ => throw new ArgumentException("\u201c" + Short(kind) + "\u201d is no kind; expected any, walking, flying or swimming"),
    };

    private static string Short(string text) => text.Length <= 24 ? text : text[..24] + "\u2026";
}
