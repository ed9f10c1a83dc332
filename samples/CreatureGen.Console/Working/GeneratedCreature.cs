using System.Collections.Generic;

namespace CreatureGen.Console.Working;

/// <summary>What is left of a creature when its files are written.</summary>
internal sealed record GeneratedCreature(CreatureFacts Facts, IReadOnlyList<CreatureFile> Files, StageTimes Times);
