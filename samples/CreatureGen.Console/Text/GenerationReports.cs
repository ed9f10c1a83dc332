using System;
using System.Diagnostics;
using System.IO;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>Tells of creatures as they come.</summary>
internal interface IGenerationReport : IDisposable
{
    /// <summary>The next creature.</summary>
    void Add(GeneratedCreature creature);

    /// <summary>That was all. Not called when the work failed.</summary>
    void End();
}

/// <summary>All there is to tell, for one creature.</summary>
internal sealed class GenerationSummary(TextWriter output) : IGenerationReport
{
    /// <inheritdoc/>
    public void Add(GeneratedCreature creature) => CreatureText.Write(output, creature.Facts, creature.Files, creature.Times);

    /// <inheritdoc/>
    public void End()
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
    }
}

/// <summary>A line for each creature.</summary>
/// <param name="output">Takes the lines.</param>
/// <param name="live">Whether somebody watches them come.</param>
internal sealed class GenerationList(TextWriter output, bool live) : IGenerationReport
{
    private readonly long start = Stopwatch.GetTimestamp();
    private long count;

    /// <inheritdoc/>
    public void Add(GeneratedCreature creature)
    {
        CreatureFacts facts = creature.Facts;
        string name = "creature-" + facts.Specimen.Name;
        output.WriteLine($"{name,-16} {CreatureText.Kind(facts),-8} {CreatureText.Plan(facts),-12} {Units.Count(facts.Joints),3} joints {Units.Count(facts.Triangles),7} triangles {Units.Kilograms(facts.Mass),9}  {CreatureText.Body(facts)}");
        count++;
        if (live)
        {
            output.Flush();
        }
    }

    /// <inheritdoc/>
    public void End() => output.WriteLine($"{Units.Count(count)} creatures in {Units.Milliseconds(Stopwatch.GetElapsedTime(start).TotalMilliseconds)}");

    /// <inheritdoc/>
    public void Dispose()
    {
    }
}

/// <summary>One JSON object with a line for each creature. It is closed even when the work fails, so that what was done can be read.</summary>
internal sealed class GenerationJson : IGenerationReport
{
    private readonly TextWriter output;
    private bool any;

    /// <summary>Begins the object.</summary>
    public GenerationJson(TextWriter output)
    {
        this.output = output;
        output.Write("{\"creatures\":[");
    }

    /// <inheritdoc/>
    public void Add(GeneratedCreature creature)
    {
        output.Write(any ? ",\n" : "\n");
        any = true;
        output.Write(JsonText.Line(json =>
        {
            json.WriteStartObject();
            CreatureJson.WriteFacts(json, creature.Facts);
            json.WriteStartObject("files");
            foreach (CreatureFile file in creature.Files)
            {
                json.WriteString(file.Form, file.Path);
            }

            json.WriteEndObject();
            json.WriteEndObject();
        }));
    }

    /// <inheritdoc/>
    public void End()
    {
    }

    /// <inheritdoc/>
    public void Dispose() => output.Write(any ? "\n]}\n" : "]}\n");
}
