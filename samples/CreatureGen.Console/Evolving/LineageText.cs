using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.Json;
using CreatureGen.Blueprints;
using CreatureGen.Console.Text;
using CreatureGen.Genetics.Populations;

namespace CreatureGen.Console.Evolving;

/// <summary>A run as JSON: the file <c>lineage.json</c>. The names are a contract. Blueprints are files of their own.</summary>
internal static class LineageText
{
    private const int Format = 1;

    /// <summary>The text of a run.</summary>
    public static string Write(EvolutionRun run) => JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteNumber("format", Format);
        json.WriteStartObject("settings");
        foreach ((string name, string value) in run.Settings)
        {
            json.WriteString(name, value);
        }

        json.WriteEndObject();
        WriteAll(json, "picks", run.Picks, pick => json.WriteStringValue(HashText.Of(pick)));
        WriteAll(json, "generations", run.Rows, row => WriteRow(json, row));
        WriteAll(json, "population", run.Now.Individuals, one => WriteIndividual(json, one));
        WriteAll(json, "archive", run.Now.Archive, one => WriteIndividual(json, one));
        WriteAll(json, "creatures", run.Ancestors, one => WriteAncestor(json, one));
        json.WriteEndObject();
    });

    /// <summary>Reads a run.</summary>
    /// <param name="text">What was written.</param>
    /// <param name="recall">Finds a creature again by its number, its verdict and its scores.</param>
    /// <exception cref="FormatException">It is no such text.</exception>
    public static EvolutionRun Read(string text, Func<ulong, Verdict, ValueList<double>, Individual> recall) => Read(text, root =>
    {
        GenerationRow[] rows = All(root, "generations", ReadRow);
        var now = new Generation(rows.Length - 1, All(root, "population", one => ReadIndividual(one, recall)), All(root, "archive", one => ReadIndividual(one, recall)));
        return new EvolutionRun(
            root.GetProperty("settings").EnumerateObject().Select(setting => (setting.Name, setting.Value.GetString()!)).ToArray(),
            All(root, "picks", HashOf),
            rows,
            All(root, "creatures", ReadAncestor),
            now);
    });

    /// <summary>Reads which creatures were picked in a run.</summary>
    /// <exception cref="FormatException">It is no such text.</exception>
    public static IReadOnlyList<ulong> ReadPicks(string text) => Read(text, root => All(root, "picks", HashOf));

    private static T Read<T>(string text, Func<JsonElement, T> read)
    {
        try
        {
            using JsonDocument document = JsonDocument.Parse(text);
            JsonElement root = document.RootElement;
            if (root.GetProperty("format").GetInt32() != Format)
            {
                throw new FormatException($"its format is {root.GetProperty("format")}; expected {Format}");
            }

            return read(root);
        }
        catch (Exception problem) when (problem is JsonException or KeyNotFoundException or InvalidOperationException or ArgumentException or FormatException)
        {
            throw new FormatException(problem.Message.Split('\n')[0], problem);
        }
    }

    private static void WriteAll<T>(Utf8JsonWriter json, string name, IReadOnlyList<T> items, Action<T> write)
    {
        json.WriteStartArray(name);
        foreach (T item in items)
        {
            write(item);
        }

        json.WriteEndArray();
    }

    private static T[] All<T>(JsonElement element, string name, Func<JsonElement, T> read) => element.GetProperty(name).EnumerateArray().Select(read).ToArray();

    private static ulong HashOf(JsonElement element) => HashText.TryRead(element.GetString(), out ulong hash) ? hash : throw new FormatException($"'{element}' is no creature's number; expected 16 hexadecimal digits");

    private static void WriteRow(Utf8JsonWriter json, GenerationRow row)
    {
        json.WriteStartObject();
        json.WriteNumber("generation", row.Number);
        json.WriteNumber("best", row.Best);
        json.WriteNumber("median", row.Median);
        json.WriteString("champion", HashText.Of(row.Champion));
        json.WriteNumber("creatures", row.Creatures);
        json.WriteEndObject();
    }

    private static GenerationRow ReadRow(JsonElement row) =>
        new(row.GetProperty("generation").GetInt32(), row.GetProperty("best").GetDouble(), row.GetProperty("median").GetDouble(), HashOf(row.GetProperty("champion")), row.GetProperty("creatures").GetInt32());

    private static void WriteIndividual(Utf8JsonWriter json, Individual one)
    {
        json.WriteStartObject();
        json.WriteString("hash", HashText.Of(one.Identity));
        json.WriteString("verdict", Arguments.WordList<Verdict>.Instance[one.Verdict]);
        json.WriteStartArray("scores");
        foreach (double score in one.Scores)
        {
            json.WriteNumberValue(score);
        }

        json.WriteEndArray();
        json.WriteEndObject();
    }

    private static Individual ReadIndividual(JsonElement one, Func<ulong, Verdict, ValueList<double>, Individual> recall) => recall(
        HashOf(one.GetProperty("hash")),
        Arguments.WordList<Verdict>.Instance.TryFind(one.GetProperty("verdict").GetString()!, out Verdict verdict) ? verdict : throw new FormatException($"'{one.GetProperty("verdict")}' is no verdict"),
        new ValueList<double>(All(one, "scores", score => score.GetDouble())));

    private static void WriteAncestor(Utf8JsonWriter json, Ancestor one)
    {
        json.WriteStartObject();
        json.WriteString("hash", HashText.Of(one.Identity));
        json.WriteNumber("born", one.Born);
        json.WriteNumber("score", one.Score);
        if (one.Lineage is LineageBlueprint lineage)
        {
            json.WriteString("first", HashText.Of(lineage.First));
            json.WriteString("second", HashText.Of(lineage.Second));
            json.WriteNumber("generation", lineage.Generation);
            json.WriteNumber("mutation", lineage.Mutation);
            json.WriteString("inherited", string.Concat(new[] { lineage.Frame, lineage.Head, lineage.Tail, lineage.Ornaments, lineage.Skin }.Select(parent => parent == ParentName.First ? 'A' : 'B')));
        }

        json.WriteEndObject();
    }

    private static Ancestor ReadAncestor(JsonElement one) => new(
        HashOf(one.GetProperty("hash")),
        one.GetProperty("born").GetInt32(),
        one.GetProperty("score").GetDouble(),
        one.TryGetProperty("first", out JsonElement first) ? ReadLineage(one, HashOf(first)) : null);

    private static LineageBlueprint ReadLineage(JsonElement one, ulong first)
    {
        string inherited = one.GetProperty("inherited").GetString()!;
        ParentName Parent(int place) => inherited.Length == 5 && inherited[place] is 'A' or 'B'
            ? inherited[place] == 'A' ? ParentName.First : ParentName.Second
            : throw new FormatException(string.Create(CultureInfo.InvariantCulture, $"'{inherited}' is no inheritance; expected five letters A or B"));
        return new LineageBlueprint(one.GetProperty("generation").GetInt32(), first, HashOf(one.GetProperty("second")), one.GetProperty("mutation").GetDouble(), Parent(0), Parent(1), Parent(2), Parent(3), Parent(4));
    }
}
