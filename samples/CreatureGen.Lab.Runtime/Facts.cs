using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text;
using CreatureGen.Blueprints;
using CreatureGen.Creatures;
using CreatureGen.Inspection;
using CreatureGen.Repairs;

namespace CreatureGen.Lab.Runtime;

/// <summary>What the page tells of a creature, as JSON.</summary>
internal static class Facts
{
    public static string Of(int slot, Actor actor, IReadOnlyList<RepairChange> changes, IReadOnlyList<InvariantViolation> violations)
    {
        Creature creature = actor.Creature;
        CreatureBlueprint design = actor.Design;
        Abilities can = actor.Abilities;
        var text = new StringBuilder("{");
        Number(text, "slot", slot);
        Word(text, "seed", design.Seed.ToString(CultureInfo.InvariantCulture));
        Word(text, "kind", Name(design.Kind.ToString()));
        Word(text, "plan", Name(design.Plan.ToString()));
        Word(text, "body", design.Body.Blend.First);
        Words(text, "bodies", design.Body.Blend.Bodies.Select(body => body.Name));
        Word(text, "medium", Name(can.Medium.ToString()));
        Number(text, "generation", design.Lineage?.Generation ?? 0);
        Number(text, "legs", design.Legs.Count);
        Number(text, "vertices", creature.Mesh.Positions.Length);
        Number(text, "triangles", creature.Mesh.Triangles.Length / 3);
        Number(text, "joints", creature.Skeleton.Count);
        Number(text, "mass", creature.Mass.Mass);
        Number(text, "length", can.Length);
        Number(text, "height", can.Height);
        Number(text, "pace", can.Medium == Medium.Air || can.Pace == 0f ? can.FlightSpeed : can.Pace);
        Words(text, "parts", PartBox.All.Where(part => part.Has(design)).Select(part => part.Name));
        Words(text, "traits", Traits.All.Where(trait => trait.Applies(design)).Select(trait => trait.Name));
        Words(text, "changes", changes.Select(change => change.ToString()));
        Words(text, "reasons", changes.Select(change => change.Reason).Distinct());
        Words(text, "violations", violations.Select(violation => violation.Detail));
        return text.Append("\"end\":0}").ToString();
    }

    /// <summary>What repair made of a blueprint, and why.</summary>
    public static string OfRepair(RepairReport report)
    {
        var text = new StringBuilder("{");
        Word(text, "blueprint", BlueprintJson.Write(report.Blueprint));
        Words(text, "parts", PartBox.All.Where(part => part.Has(report.Blueprint)).Select(part => part.Name));
        Words(text, "reasons", report.Changes.Select(change => change.Reason).Distinct());
        return text.Append("\"end\":0}").ToString();
    }

    /// <summary>The palette of parts, for the page to draw.</summary>
    public static string OfParts() => "[" + string.Join(',', PartBox.All.Select(part => "\"" + part.Name + "\"")) + "]";

    /// <summary>What is known of a creature before it is built.</summary>
    public static string AtAGlance(CreatureBlueprint design)
    {
        var text = new StringBuilder("{");
        Word(text, "kind", Name(design.Kind.ToString()));
        Word(text, "plan", Name(design.Plan.ToString()));
        Word(text, "body", design.Body.Blend.First);
        Number(text, "scale", design.Scale);
        return text.Append("\"end\":0}").ToString();
    }

    /// <summary>The sliders, for the page to draw.</summary>
    public static string OfTraits()
    {
        var text = new StringBuilder("[");
        foreach (Trait trait in Traits.All)
        {
            text.Append(text.Length > 1 ? "," : "").Append('{');
            Word(text, "name", trait.Name);
            Number(text, "least", trait.Min);
            Number(text, "most", trait.Max);
            Number(text, "own", trait.Own);
            text.Append("\"end\":0}");
        }

        return text.Append(']').ToString();
    }

    private static string Name(string name) => char.ToLowerInvariant(name[0]) + name[1..];

    private static void Number(StringBuilder text, string name, double value) => text.Append(CultureInfo.InvariantCulture, $"\"{name}\":{value:0.#####},");

    private static void Word(StringBuilder text, string name, string value) => Quote(text.Append('"').Append(name).Append("\":"), value).Append(',');

    private static void Words(StringBuilder text, string name, IEnumerable<string> values)
    {
        text.Append('"').Append(name).Append("\":[");
        string separator = "";
        foreach (string value in values)
        {
            Quote(text.Append(separator), value);
            separator = ",";
        }

        text.Append("],");
    }

    private static StringBuilder Quote(StringBuilder text, string value)
    {
        text.Append('"');
        foreach (char c in value)
        {
            _ = c is '"' or '\\' ? text.Append('\\').Append(c) : c < ' ' ? text.Append(CultureInfo.InvariantCulture, $"\\u{(int)c:x4}") : text.Append(c);
        }

        return text.Append('"');
    }
}
