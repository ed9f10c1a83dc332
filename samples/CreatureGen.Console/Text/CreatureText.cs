using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using CreatureGen.Anatomy;
using CreatureGen.Blueprints;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;
using CreatureGen.Repairs;
using CreatureGen.Rigging;

namespace CreatureGen.Console.Text;

/// <summary>A creature in words.</summary>
internal static class CreatureText
{
    private const int LabelWidth = 11;

    /// <summary>Tells what a creature is, how long it took and where it is.</summary>
    public static void Write(TextWriter output, CreatureFacts facts, IReadOnlyList<CreatureFile> files, StageTimes times)
    {
        WriteFacts(output, facts);
        Row(output, "time", Units.Milliseconds(times.All.Sum(stage => stage.Milliseconds)) + ": " + string.Join(", ", times.All.Select(stage => $"{stage.Stage} {Units.Milliseconds(stage.Milliseconds)[..^3]}")));
        for (int i = 0; i < files.Count; i++)
        {
            Row(output, i == 0 ? "files" : "", $"{files[i].Path}  ({Units.Bytes(files[i].Bytes)})");
        }
    }

    /// <summary>Tells what a repair changed.</summary>
    public static void WriteChanges(TextWriter output, IReadOnlyList<RepairChange> changes)
    {
        for (int i = 0; i < changes.Count; i++)
        {
            Row(output, i == 0 ? "repaired" : "", changes[i].ToString());
        }
    }

    /// <summary>Tells what a creature is.</summary>
    public static void WriteFacts(TextWriter output, CreatureFacts facts)
    {
        output.WriteLine("creature " + facts.Specimen.Name);
        Row(output, "kind", $"{Kind(facts)}, {Plan(facts)}");
        Row(output, "body", Body(facts));
        Row(output, "limbs", facts.Limbs.Count == 0 ? "none" : string.Join(", ", facts.Limbs.Select(limb => Count(limb.Kind, limb.Count))));
        Row(output, "joints", Units.Count(facts.Joints));
        Row(output, "vertices", Units.Count(facts.Vertices));
        Row(output, "triangles", Units.Count(facts.Triangles));
        Row(output, "size", $"{Units.Metres(facts.Size.X)} wide x {Units.Metres(facts.Size.Y)} high x {Units.Metres(facts.Size.Z)} long, metres");
        Row(output, "mass", Units.Kilograms(facts.Mass));
        Row(output, "speed", Units.Metres(facts.Speed) + " m/s");
    }

    /// <summary>A line with its label, at least a space from it.</summary>
    public static void Row(TextWriter output, string label, string text) => output.WriteLine("  " + (label + " ").PadRight(LabelWidth) + text);

    /// <summary>How a creature moves.</summary>
    public static string Kind(CreatureFacts facts) => WordList<LocomotionKind>.Instance[facts.Kind];

    /// <summary>How a creature carries its body.</summary>
    public static string Plan(CreatureFacts facts) => WordList<BodyPlan>.Instance[facts.Plan];

    /// <summary>What a creature's body is mixed from.</summary>
    public static string Body(CreatureFacts facts) => string.Join(", ", facts.Body.Where(part => part.Part >= 0.005).Select(part => $"{part.Name} {Units.Percent(part.Part)}"));

    /// <summary>What a creature looks like, in few words: the animal that its torso has most of, and whose face it has if that is another's.</summary>
    public static string Looks(BodyBlend blend)
    {
        IReadOnlyList<double> torso = blend.TorsoFractions;
        string body = blend.Bodies[Enumerable.Range(0, torso.Count).MaxBy(i => torso[i])].Name;
        return body == blend.Face ? body : $"{body}, face of {blend.Face}";
    }

    private static string Count(LimbKind kind, int count)
    {
        string name = kind switch
        {
            LimbKind.Leg => "leg",
            LimbKind.Arm => "arm",
            LimbKind.Wing => "wing",
            LimbKind.InsectWing => "insect wing",
            LimbKind.Pectoral => "pectoral fin",
            LimbKind.Dorsal => "dorsal fin",
            LimbKind.Ventral => "ventral fin",
            LimbKind.Ear => "ear",
            LimbKind.Antenna => "antenna",
            LimbKind.Disc => "disc row",
            _ => WordList<LimbKind>.Instance[kind],
        };
        string plural = kind == LimbKind.Antenna ? "antennae" : name + "s";
        return FormattableString.Invariant($"{count} {(count == 1 ? name : plural)}");
    }
}
