using System.Collections.Generic;
using System.Globalization;
using System.IO;
using CreatureGen.Console.Evolving;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>What came of a run of generations, as text and as JSON. The names of the JSON are a contract.</summary>
internal static class EvolutionText
{
    /// <summary>Writes it for people.</summary>
    public static void Write(TextWriter output, EvolutionRun run, IReadOnlyList<CreatureFile> files, int every)
    {
        output.WriteLine("generation      best    median  creatures");
        foreach (GenerationRow row in run.Rows)
        {
            if (row.Number % every == 0 || row.Number == run.Now.Number)
            {
                output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"{row.Number,10}  {row.Best,8:0.000}  {row.Median,8:0.000}  {row.Creatures,9}"));
            }
        }

        foreach (CreatureFile file in files)
        {
            CreatureText.Row(output, file.Form, file.Path);
        }
    }

    /// <summary>Writes it for programs.</summary>
    public static void WriteJson(TextWriter output, EvolutionRun run, IReadOnlyList<CreatureFile> files) => output.Write(JsonText.Document(json =>
    {
        json.WriteStartObject();
        json.WriteStartArray("generations");
        foreach (GenerationRow row in run.Rows)
        {
            json.WriteStartObject();
            json.WriteNumber("generation", row.Number);
            json.WriteNumber("best", row.Best);
            json.WriteNumber("median", row.Median);
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteString("best", HashText.Of(run.Now.Best.Identity));
        json.WriteNumber("creatures", run.Now.Individuals.Count);
        json.WriteStartObject("files");
        foreach (CreatureFile file in files)
        {
            json.WriteString(file.Form, file.Path);
        }

        json.WriteEndObject();
        json.WriteEndObject();
    }));
}
