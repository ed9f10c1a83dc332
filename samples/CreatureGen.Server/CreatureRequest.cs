using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Security.Cryptography;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Preview.Scenes;
using CreatureGen.Sampling;
using Microsoft.AspNetCore.Http;

namespace CreatureGen.Server;

/// <summary>What is wanted of a creature: <c>7.glb</c>, <c>7.png?view=side&amp;size=256</c> or <c>7.json</c>, each with <c>kind</c> and <c>individual</c>, GLB files with <c>textures</c> and <c>clips</c>.</summary>
/// <param name="Seed">Its seed.</param>
/// <param name="Form">What it is to be: <c>glb</c>, <c>png</c> or <c>json</c>.</param>
/// <param name="Options">Which creature of the seed.</param>
/// <param name="TextureSize">Texels along a side of the atlas, 0 for none.</param>
/// <param name="HasClips">Whether its motion is wanted.</param>
/// <param name="View">From where its picture is taken.</param>
/// <param name="Size">Pixels along a side of its picture.</param>
internal sealed record CreatureRequest(ulong Seed, string Form, CreatureOptions Options, int TextureSize, bool HasClips, View View, int Size)
{
    private const int MaxTexels = 1024;
    private const int MaxPixels = 1024;

    private static readonly string[] known = ["kind", "individual", "textures", "clips", "view", "size"];

    /// <summary>Version of the library.</summary>
    public static string Library { get; } = typeof(CreatureGenerator).Assembly.GetName().Version!.ToString(3);

    /// <summary>What the bytes are.</summary>
    public string MediaType => Form switch { "glb" => "model/gltf-binary", "png" => "image/png", _ => "application/json" };

    /// <summary>A tag that two requests share if, and only if, they are answered with the same bytes: a hash of all that decides about them.</summary>
    public string Tag
    {
        get
        {
            string all = string.Create(CultureInfo.InvariantCulture, $"{Seed} {Form} {TextureSize} {HasClips} {View} {Size} {CreatureBlueprint.CurrentAlgorithm} {typeof(CreatureGenerator).Assembly.ManifestModule.ModuleVersionId} {OptionsJson.Write(Options)}");
            return '"' + Convert.ToHexStringLower(SHA256.HashData(Encoding.UTF8.GetBytes(all)))[..32] + '"';
        }
    }

    /// <summary>Reads a request.</summary>
    /// <param name="name">Seed, dot and form.</param>
    /// <param name="query">The rest.</param>
    /// <param name="request">What was read.</param>
    /// <param name="problem">What is wrong, in a line.</param>
    /// <returns>Whether it could be read.</returns>
    public static bool TryRead(string name, IQueryCollection query, out CreatureRequest? request, out string problem)
    {
        request = null;
        string[] parts = name.Split('.', 2);
        if (parts.Length < 2 || parts[1] is not ("glb" or "png" or "json") || !ulong.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out ulong seed))
        {
            problem = $"'{name}'; expected a seed 0..18446744073709551615 and .glb, .png or .json";
            return false;
        }

        if (query.Keys.FirstOrDefault(key => !known.Contains(key)) is string stranger)
        {
            problem = $"'{stranger}'; expected one of {string.Join(", ", known)}";
            return false;
        }

        var reader = new QueryReader(query);
        RequestedKind kind = reader.Word("kind", Enum.GetValues<RequestedKind>().ToDictionary(value => value.ToString().ToLowerInvariant()), RequestedKind.Any);
        ulong? individual = reader.Seed("individual");
        int textures = reader.Word("textures", new Dictionary<string, int> { ["none"] = 0, ["256"] = 256, ["512"] = 512, ["1024"] = MaxTexels }, 0);
        bool clips = reader.Word("clips", new Dictionary<string, bool> { ["none"] = false, ["all"] = true }, false);
        View view = reader.Word("view", Enum.GetValues<View>().ToDictionary(Views.Word), View.ThreeQuarter);
        int size = reader.Whole("size", 16, MaxPixels, 512);
        problem = reader.Problem ?? "";
        request = new CreatureRequest(seed, parts[1], CreatureOptions.Default with { Kind = kind, Individual = individual }, textures, clips, view, size);
        return reader.Problem is null;
    }

    /// <summary>Reads values, and remembers the first that is wrong.</summary>
    private sealed class QueryReader(IQueryCollection query)
    {
        public string? Problem { get; private set; }

        public T Word<T>(string name, IReadOnlyDictionary<string, T> words, T absent)
        {
            string text = query[name].ToString();
            return text.Length == 0 ? absent : words.TryGetValue(text, out T? value) ? value : Wrong(name, text, "one of " + string.Join(", ", words.Keys), absent);
        }

        public int Whole(string name, int least, int most, int absent)
        {
            string text = query[name].ToString();
            return text.Length == 0 ? absent
                : int.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out int number) && number >= least && number <= most ? number
                : Wrong(name, text, FormattableString.Invariant($"a whole number {least}..{most}"), absent);
        }

        public ulong? Seed(string name)
        {
            string text = query[name].ToString();
            return text.Length == 0 ? null : ulong.TryParse(text, NumberStyles.None, CultureInfo.InvariantCulture, out ulong number) ? number : Wrong<ulong?>(name, text, "a whole number from 0 on", null);
        }

        private T Wrong<T>(string name, string text, string expectation, T absent)
        {
            Problem ??= $"{name} = '{text}'; expected {expectation}";
            return absent;
        }
    }
}
