using System.Collections.Generic;
using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Gltf;
using CreatureGen.Inspection;
using CreatureGen.Repairs;

namespace CreatureGen.Console.Verbs;

/// <summary>Builds a creature anew from its blueprint, and writes it if it keeps all promises.</summary>
internal sealed class BuildVerb : IVerb
{
    private static readonly OptionSyntax repair = new("--repair", null, "change the blueprint where its creature would be broken, and tell each change");

    private static readonly OptionSyntax force = new("--force", null, "write the creature even if it is broken");

    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "build",
        "BLUEPRINT.json|FILE.glb",
        "write the creature of a blueprint, or build the one in a GLB file anew",
        [
            new("build creature-101.json --out edited.glb", "build a blueprint that was edited"),
            new("build creature-101.glb --out again.glb", "build the creature in a file anew: the same bytes"),
            new("build - --out - > creature-101.glb", "from the standard input to the standard output"),
            new("build creature-101.glb --flat --out flat.glb", "the same creature with flat shading"),
            new("build picture.png --out found.glb", "the creature that a picture of the creature lab holds"),
            new("build edited.json --repair --out edited.glb", "legs, stance and parts made to fit what was edited"),
        ],
        [CommonOptions.OutFile, repair, force, .. ExportOptions.Syntax, CommonOptions.Quiet]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string path = surroundings.Locate(arguments.Required(CommonOptions.OutFile.Name));
        if (arguments.Has(repair.Name) && arguments.Has(force.Name))
        {
            throw arguments.Wrong("--repair and --force at once; expected one of them");
        }

        string from = arguments.Operand;
        CreatureSource source = arguments.Has(repair.Name) ? CreatureSource.ReadDraft(from, surroundings) : CreatureSource.Read(from, surroundings);
        FileSet.RequireWritable(path, surroundings);
        var times = new StageTimes();
        RepairReport? report = arguments.Has(repair.Name) ? BlueprintRepair.Repair(source.Blueprint) : null;
        Creature creature = report?.Creature ?? CreatureAssembler.Assemble(source.Blueprint, times);
        IReadOnlyList<InvariantViolation> violations = surroundings.Checks.Inspect(creature);
        times.Finished(report is null ? "inspection" : "repair");
        if (violations.Count > 0 && !arguments.Has(force.Name))
        {
            return Refuse(surroundings, from, violations, report);
        }

        byte[] glb = CreatureFiles.Glb(creature, ExportOptions.Read(arguments, source.Export), ExportOptions.ReadClips(arguments, source.Clips));
        times.Finished("glb");
        FileSet.Write(path, stream => stream.Write(glb), surroundings);
        times.Finished("files");
        Remark(surroundings, violations);
        CreatureText.Write(surroundings.Telling(path), CreatureFacts.Of(creature), [CreatureFile.Of("glb", path, glb)], times);
        CreatureText.WriteChanges(surroundings.Telling(path), report?.Changes ?? []);
        return ExitCode.Done;
    }

    private static int Refuse(Surroundings surroundings, string path, IReadOnlyList<InvariantViolation> violations, RepairReport? report)
    {
        string advice = report is null ? "--repair changes it until it is sound, --force writes it all the same" : "and no repair was found";
        surroundings.Error.WriteLine($"{Application.Name}: the creature of '{path}' would be broken; {advice}:");
        foreach (InvariantViolation violation in violations)
        {
            surroundings.Error.WriteLine($"  {violation.Invariant}: {violation.Detail}");
        }

        return ExitCode.CheckFailed;
    }

    private static void Remark(Surroundings surroundings, IReadOnlyList<InvariantViolation> violations)
    {
        foreach (InvariantViolation violation in violations)
        {
            surroundings.Error.WriteLine($"{Application.Name}: written although broken: {violation.Invariant}: {violation.Detail}");
        }
    }
}
