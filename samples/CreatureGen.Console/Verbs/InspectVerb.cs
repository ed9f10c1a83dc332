using CreatureGen.Console.Arguments;
using CreatureGen.Console.Files;
using CreatureGen.Console.Text;
using CreatureGen.Console.Working;
using CreatureGen.Creatures;
using CreatureGen.Genetics;

namespace CreatureGen.Console.Verbs;

/// <summary>Tells what is in a file.</summary>
internal sealed class InspectVerb : IVerb
{
    /// <inheritdoc/>
    public VerbSyntax Syntax { get; } = new(
        "inspect",
        "FILE [OTHER]",
        "tell what the creature in a .glb or blueprint .json is, and check its invariants",
        [
            new("inspect creature-101.glb", "what it is: kind, limbs, joints, sizes, checks"),
            new("inspect creature-101.json --json", "the same as JSON"),
            new("inspect mother.glb child.glb", "the first, and how far the two are apart as species"),
        ],
        [CommonOptions.Json]);

    /// <inheritdoc/>
    public int Run(ParsedArguments arguments, Surroundings surroundings)
    {
        CreatureSource source = CreatureSource.Read(arguments.Operand, surroundings);
        Creature creature = CreatureAssembler.Assemble(source.Blueprint);
        CheckResult result = CheckResult.Of(creature, surroundings.Checks);
        FileState state = source.Form != SourceForm.Glb ? FileState.Blueprint : source.IsWhatWouldBeWritten(creature) ? FileState.AsWritten : FileState.Altered;
        double? distance = arguments.SecondOperand is string other ? SpeciesDistance.Between(source.Blueprint, Parent.Read(other, surroundings).Blueprint) : null;
        var inspected = new InspectedFile(source, state, creature, CreatureFacts.Of(creature), result, distance);
        if (arguments.Has(CommonOptions.Json.Name))
        {
            InspectionJson.Write(surroundings.Out, inspected);
        }
        else
        {
            InspectionText.Write(surroundings.Out, inspected, Ink.For(surroundings, surroundings.OutIsTerminal));
        }

        return result.Violations.Count == 0 ? ExitCode.Done : ExitCode.CheckFailed;
    }
}
