using System.Numerics;
using System.Text.Json;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;
using CreatureGen.Geometry;
using CreatureGen.Rigging;

namespace CreatureGen.Console.Text;

/// <summary>A creature as JSON. The names are a contract.</summary>
internal static class CreatureJson
{
    /// <summary>Writes the facts as members of the object that is open.</summary>
    public static void WriteFacts(Utf8JsonWriter json, CreatureFacts facts)
    {
        json.WriteString("seed", SeedText.Of(facts.Specimen.Seed));
        if (facts.Specimen.Individual is ulong individual)
        {
            json.WriteString("individual", SeedText.Of(individual));
        }

        WriteLooks(json, facts);
    }

    /// <summary>Writes what a creature is, without its seed, as members of the object that is open.</summary>
    public static void WriteLooks(Utf8JsonWriter json, CreatureFacts facts)
    {
        json.WriteString("kind", CreatureText.Kind(facts));
        json.WriteString("plan", CreatureText.Plan(facts));
        json.WriteNumber("scale", facts.Scale);
        json.WriteStartObject("body");
        foreach ((string name, double part) in facts.Body)
        {
            json.WriteNumber(name, part);
        }

        json.WriteEndObject();
        json.WriteStartObject("limbs");
        foreach ((LimbKind kind, int count) in facts.Limbs)
        {
            json.WriteNumber(WordList<LimbKind>.Instance[kind], count);
        }

        json.WriteEndObject();
        json.WriteNumber("joints", facts.Joints);
        json.WriteNumber("vertices", facts.Vertices);
        json.WriteNumber("triangles", facts.Triangles);
        json.WriteStartObject("materials");
        foreach ((MaterialKind material, int triangles) in facts.Materials)
        {
            json.WriteNumber(WordList<MaterialKind>.Instance[material], triangles);
        }

        json.WriteEndObject();
        json.WriteStartObject("bounds");
        WriteVector(json, "min", facts.Min);
        WriteVector(json, "max", facts.Max);
        json.WriteEndObject();
        json.WriteNumber("mass", facts.Mass);
        json.WriteNumber("speed", facts.Speed);
    }

    private static void WriteVector(Utf8JsonWriter json, string name, Vector3 vector)
    {
        json.WriteStartArray(name);
        json.WriteNumberValue(vector.X);
        json.WriteNumberValue(vector.Y);
        json.WriteNumberValue(vector.Z);
        json.WriteEndArray();
    }
}
