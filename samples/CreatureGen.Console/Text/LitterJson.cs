using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Text.Json;
using CreatureGen.Console.Files;
using CreatureGen.Console.Working;
using CreatureGen.Genetics;
using CreatureGen.Repairs;

namespace CreatureGen.Console.Text;

/// <summary>A litter as JSON. The names are a contract.</summary>
internal static class LitterJson
{
    /// <summary>Writes parents and children.</summary>
    public static void Write(TextWriter output, IReadOnlyList<Parent> parents, IReadOnlyList<Child> children, string picture) => output.Write(JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteStartArray("parents");
        foreach (Parent parent in parents)
        {
            json.WriteStartObject();
            json.WriteString("name", parent.Name);
            json.WriteString("hash", BlueprintIdentity.Of(parent.Blueprint).ToString("x16", CultureInfo.InvariantCulture));
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("distance", SpeciesDistance.Between(parents[0].Blueprint, parents[1].Blueprint));
        json.WriteStartArray("litter");
        foreach (Child child in children)
        {
            WriteChild(json, child);
        }

        json.WriteEndArray();
        json.WriteString("picture", picture);
        json.WriteEndObject();
    }));

    private static void WriteChild(Utf8JsonWriter json, Child child)
    {
        json.WriteStartObject();
        json.WriteString("hash", child.Name);
        json.WriteString("seed", child.Offspring.Blueprint.Seed.ToString(CultureInfo.InvariantCulture));
        json.WriteNumber("generation", child.Offspring.Blueprint.Lineage!.Generation);
        json.WriteString("inherited", child.Inherited());
        json.WriteNumber("attempts", child.Offspring.Attempts);
        json.WriteStartArray("repairs");
        foreach (RepairChange change in child.Offspring.Repairs)
        {
            json.WriteStringValue(change.ToString());
        }

        json.WriteEndArray();
        json.WriteStartObject("files");
        foreach (CreatureFile file in child.Files)
        {
            json.WriteString(file.Form, file.Path);
        }

        json.WriteEndObject();
        json.WriteEndObject();
    }
}
