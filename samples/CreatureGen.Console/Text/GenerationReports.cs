using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;

namespace CreatureGen.Console.Text;

/// <summary>Tells of creatures as they come.</summary>
internal interface IGenerationReport : IDisposable
{
    /// <summary>The next creature, or that there is none.</summary>
    void Add(GenerationResult result);

    /// <summary>That was all. Not called when the work failed.</summary>
    void End();
}

/// <summary>All there is to tell, for one creature.</summary>
internal sealed class GenerationSummary(TextWriter output) : IGenerationReport
{
    /// <inheritdoc/>
    public void Add(GenerationResult result)
    {
        var creature = (GeneratedCreature)result;
        CreatureText.Write(output, creature.Facts, creature.Files, creature.Times);
    }

    /// <inheritdoc/>
    public void End()
    {
    }

    /// <inheritdoc/>
    public void Dispose()
    {
    }
}

/// <summary>A line for each creature, and a complaint for each that is missing.</summary>
internal sealed class GenerationList(Surroundings surroundings) : IGenerationReport
{
    private readonly long start = Stopwatch.GetTimestamp();
    private long count;
    private long missing;
    private long kept;

    /// <inheritdoc/>
    public void Add(GenerationResult result)
    {
        if (result is MissingCreature none)
        {
            Complaint.Tell(surroundings, none.Reason);
            missing++;
        }
        else if (result is GeneratedCreature creature)
        {
            Tell(creature);
            count++;
        }
        else
        {
            kept++;
        }
    }

    /// <inheritdoc/>
    public void End()
    {
        string there = kept == 0 ? "" : $", {Units.Count(kept)} there already";
        string without = missing == 0 ? "" : $", {Units.Count(missing)} missing";
        surroundings.Out.WriteLine($"{Units.Count(count)} creatures in {Units.Milliseconds(Stopwatch.GetElapsedTime(start).TotalMilliseconds)}{there}{without}");
    }

    /// <inheritdoc/>
    public void Dispose()
    {
    }

    private void Tell(GeneratedCreature creature)
    {
        CreatureFacts facts = creature.Facts;
        string name = "creature-" + facts.Specimen.Name;
        surroundings.Out.WriteLine($"{name,-16} {CreatureText.Kind(facts),-8} {CreatureText.Plan(facts),-12} {Units.Count(facts.Joints),3} joints {Units.Count(facts.Triangles),7} triangles {Units.Kilograms(facts.Mass),9}  {CreatureText.Body(facts)}");
        if (surroundings.OutIsTerminal)
        {
            surroundings.Out.Flush();
        }
    }
}

/// <summary>One JSON object with a line for each creature and, if some are missing or were there already, one for each of those. It is closed even when the work fails, so that what was done can be read.</summary>
internal sealed class GenerationJson : IGenerationReport
{
    private readonly TextWriter output;
    private readonly List<MissingCreature> missing = [];
    private readonly List<KeptCreature> kept = [];
    private bool any;

    /// <summary>Begins the object.</summary>
    public GenerationJson(TextWriter output)
    {
        this.output = output;
        output.Write("{\"creatures\":[");
    }

    /// <inheritdoc/>
    public void Add(GenerationResult result)
    {
        if (result is not GeneratedCreature creature)
        {
            if (result is KeptCreature there)
            {
                kept.Add(there);
            }
            else
            {
                missing.Add((MissingCreature)result);
            }

            return;
        }

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
    public void Dispose()
    {
        output.Write(any ? "\n]" : "]");
        if (missing.Count > 0)
        {
            output.Write(",\"missing\":[\n" + string.Join(",\n", missing.Select(Line)) + "\n]");
        }

        if (kept.Count > 0)
        {
            output.Write(",\"kept\":" + JsonText.Line(json =>
            {
                json.WriteStartArray();
                foreach (KeptCreature creature in kept)
                {
                    json.WriteStringValue(creature.Specimen.Name);
                }

                json.WriteEndArray();
            }));
        }

        output.Write("}\n");
    }

    private static string Line(MissingCreature creature) => JsonText.Line(json =>
    {
        json.WriteStartObject();
        json.WriteString("creature", creature.Specimen.Name);
        json.WriteString("reason", creature.Reason);
        json.WriteEndObject();
    });
}
