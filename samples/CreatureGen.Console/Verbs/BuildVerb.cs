using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Gltf;

namespace CreatureGen.Console.Verbs;

/// <summary>Builds a creature anew from its blueprint.</summary>
internal sealed class BuildVerb : IVerb
{
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
        ],
        [CommonOptions.OutFile, .. ExportOptions.Syntax]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        string path = surroundings.Locate(arguments.Required(CommonOptions.OutFile.Name));
        CreatureSource source = CreatureSource.Read(arguments.Operand, surroundings);
        FileSet.RequireWritable(path, surroundings);
        var times = new StageTimes();
        Creature creature = CreatureAssembler.Assemble(source.Blueprint, times);
        byte[] glb = CreatureFiles.Glb(creature, ExportOptions.Read(arguments, source.Export), ExportOptions.ReadClips(arguments, source.Clips));
        times.Finished("glb");
        FileSet.Write(path, stream => stream.Write(glb), surroundings);
        times.Finished("files");
        CreatureText.Write(surroundings.Telling(path), CreatureFacts.Of(creature), [new CreatureFile("glb", path, glb.Length)], times);
        return ExitCode.Done;
    }
}
