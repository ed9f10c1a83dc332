using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using System.Numerics;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Working;
using CreatureGen.Geometry;
using CreatureGen.Gltf;
using CreatureGen.Inspection;
using CreatureGen.Rigging;

namespace CreatureGen.Console.Text;

/// <summary>A file and the creature in it, for people.</summary>
internal static class InspectionText
{
    // Columns that terminals have at least.
    private const int LineWidth = 96;

    /// <summary>Writes all there is to tell.</summary>
    public static void Write(TextWriter output, InspectedFile inspected, Ink ink)
    {
        CreatureFacts facts = inspected.Facts;
        output.WriteLine($"{inspected.Source.Path}: {FileWords(inspected)}, {Units.Bytes(inspected.Source.Bytes)}");
        output.WriteLine();
        CreatureText.WriteFacts(output, facts);
        CreatureText.Row(output, "materials", string.Join(", ", facts.Materials.Select(part => $"{WordList<MaterialKind>.Instance[part.Material]} {Units.Count(part.Triangles)} triangles")));
        CreatureText.Row(output, "bounds", $"{Corner(facts.Min)} to {Corner(facts.Max)}, metres");
        output.WriteLine();
        output.WriteLine(ink.Heading("Joints"));
        WriteTree(output, inspected.Creature.Skeleton.Joints);
        output.WriteLine();
        output.WriteLine(ink.Heading("Invariants"));
        WriteChecks(output, inspected.Checks, ink);
        if (inspected.Distance is double distance)
        {
            output.WriteLine();
            output.WriteLine(string.Create(CultureInfo.InvariantCulture, $"species distance {distance:F3} (0 the same; brothers and sisters 0.1 to 0.25; strangers 0.5 and more)"));
        }
    }

    private static string FileWords(InspectedFile inspected)
    {
        string shading = WordList<Shading>.Instance[inspected.Source.Export.Shading];
        return inspected.State switch
        {
            FileState.Blueprint => "a blueprint",
            FileState.AsWritten => $"a creature as GLB, {shading} shading, just as this version writes it",
            _ => $"a creature as GLB, {shading} shading, altered or written by another version (what follows is of its blueprint, built anew)",
        };
    }

    private static string Corner(Vector3 corner) => $"({Units.Metres(corner.X)}, {Units.Metres(corner.Y)}, {Units.Metres(corner.Z)})";

    /// <summary>Each chain of joints on a line, under the joint that it hangs on.</summary>
    private static void WriteTree(TextWriter output, IReadOnlyList<Joint> joints)
    {
        ILookup<int, int> children = Enumerable.Range(0, joints.Count).ToLookup(joint => joints[joint].Parent);
        WriteChain(0, 1);

        void WriteChain(int joint, int depth)
        {
            string indent = new(' ', depth * 2);
            string line = indent + joints[joint].Name;
            while (children[joint].Count() == 1)
            {
                joint = children[joint].First();
                string next = " > " + joints[joint].Name;
                if (line.Length + next.Length > LineWidth)
                {
                    output.WriteLine(line);
                    line = indent + " ";
                }

                line += next;
            }

            output.WriteLine(line);
            foreach (int child in children[joint])
            {
                WriteChain(child, depth + 1);
            }
        }
    }

    private static void WriteChecks(TextWriter output, CheckResult checks, Ink ink)
    {
        int width = checks.Names.Select(name => name.Length).DefaultIfEmpty(0).Max();
        foreach (string name in checks.Names.Concat(checks.Violations.Select(violation => violation.Invariant)).Distinct())
        {
            InvariantViolation[] broken = checks.Violations.Where(violation => violation.Invariant == name).ToArray();
            output.WriteLine($"  {name.PadRight(width)}  {(broken.Length == 0 ? ink.Good("holds") : ink.Bad("broken"))}");
            foreach (InvariantViolation violation in broken)
            {
                output.WriteLine("    " + violation.Detail);
            }
        }

        output.WriteLine();
        output.WriteLine(FormattableString.Invariant($"The surface crosses itself in {checks.Crossings.Body} pairs of triangles, single pieces that are set into it in {checks.Crossings.Pieces}."));
    }
}
