using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.Json;
using CreatureGen.Anatomy;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Working;
using CreatureGen.Gltf;
using CreatureGen.Inspection;
using CreatureGen.Rigging;

namespace CreatureGen.Console.Text;

/// <summary>A file and the creature in it as JSON. The names are a contract.</summary>
internal static class InspectionJson
{
    /// <summary>Writes all there is to tell.</summary>
    public static void Write(TextWriter output, InspectedFile inspected) => output.Write(JsonText.Document(json =>
    {
        json.WriteStartObject();
        WriteFile(json, inspected);
        json.WriteStartObject("creature");
        CreatureJson.WriteFacts(json, inspected.Facts);
        json.WriteEndObject();
        WriteSkeleton(json, inspected.Creature.Skeleton.Joints);
        WriteLimbs(json, inspected.Creature.Limbs, inspected.Creature.Skeleton.Joints);
        WriteChecks(json, inspected.Checks);
        WriteVerdict(json, inspected.Checks);
        if (inspected.Distance is double distance)
        {
            json.WriteNumber("speciesDistance", distance);
        }

        json.WriteEndObject();
    }));

    private static void WriteFile(Utf8JsonWriter json, InspectedFile inspected)
    {
        CreatureSource source = inspected.Source;
        json.WriteStartObject("file");
        json.WriteString("path", source.Path);
        json.WriteString("form", source.Form switch { SourceForm.Glb => "glb", SourceForm.Picture => "picture", _ => "blueprint" });
        json.WriteNumber("bytes", source.Bytes);
        if (source.Form == SourceForm.Glb)
        {
            json.WriteString("shading", WordList<Shading>.Instance[source.Export.Shading]);
            json.WriteBoolean("asWritten", inspected.State == FileState.AsWritten);
        }

        json.WriteEndObject();
    }

    private static void WriteSkeleton(Utf8JsonWriter json, IReadOnlyList<Joint> joints)
    {
        json.WriteStartArray("skeleton");
        foreach (Joint joint in joints)
        {
            json.WriteStartObject();
            json.WriteString("name", joint.Name);
            json.WriteString("role", WordList<JointRole>.Instance[joint.Role]);
            json.WriteString("side", WordList<Side>.Instance[joint.Side]);
            if (joint.Parent < 0)
            {
                json.WriteNull("parent");
            }
            else
            {
                json.WriteString("parent", joints[joint.Parent].Name);
            }

            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteLimbs(Utf8JsonWriter json, IReadOnlyList<LimbChain> limbs, IReadOnlyList<Joint> joints)
    {
        json.WriteStartArray("limbs");
        foreach (LimbChain limb in limbs)
        {
            json.WriteStartObject();
            json.WriteString("kind", WordList<LimbKind>.Instance[limb.Kind]);
            json.WriteString("side", WordList<Side>.Instance[limb.Side]);
            json.WriteNumber("pair", limb.Pair);
            json.WriteBoolean("stands", limb.Stands);
            json.WriteStartArray("joints");
            foreach (int joint in limb.Joints)
            {
                json.WriteStringValue(joints[joint].Name);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
    }

    private static void WriteVerdict(Utf8JsonWriter json, CheckResult checks)
    {
        json.WriteBoolean("sound", checks.Violations.Count == 0);
        json.WriteStartArray("problems");
        foreach (InvariantViolation violation in checks.Violations)
        {
            json.WriteStringValue(violation.Invariant + ": " + violation.Detail);
        }

        json.WriteEndArray();
    }

    private static void WriteChecks(Utf8JsonWriter json, CheckResult checks)
    {
        json.WriteStartArray("invariants");
        foreach (string name in checks.Names.Concat(checks.Violations.Select(violation => violation.Invariant)).Distinct())
        {
            InvariantViolation[] broken = checks.Violations.Where(violation => violation.Invariant == name).ToArray();
            json.WriteStartObject();
            json.WriteString("invariant", name);
            json.WriteBoolean("holds", broken.Length == 0);
            json.WriteStartArray("details");
            foreach (InvariantViolation violation in broken)
            {
                json.WriteStringValue(violation.Detail);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteNumber("selfIntersections", checks.Crossings.Body);
        json.WriteNumber("pieceIntersections", checks.Crossings.Pieces);
    }
}
