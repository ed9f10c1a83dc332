using System.Collections.Generic;
using CreatureGen.Console.Arguments;

namespace CreatureGen.Console.Working;

/// <summary>What came of one seed and individual.</summary>
internal abstract record GenerationResult;

/// <summary>What is left of a creature when its files are written.</summary>
internal sealed record GeneratedCreature(CreatureFacts Facts, IReadOnlyList<ClipFacts> Clips, IReadOnlyList<CreatureFile> Files, StageTimes Times) : GenerationResult;

/// <summary>Its files were there already.</summary>
/// <param name="Specimen">Of which seed and individual.</param>
internal sealed record KeptCreature(Specimen Specimen) : GenerationResult;

/// <summary>There is no creature, and no file of it.</summary>
/// <param name="Specimen">Of which seed and individual.</param>
/// <param name="Reason">Why, in a line.</param>
internal sealed record MissingCreature(Specimen Specimen, string Reason) : GenerationResult;
