using CreatureGen.Console.Files;
using CreatureGen.Creatures;

namespace CreatureGen.Console.Working;

/// <summary>How a file stands to the creature in it.</summary>
internal enum FileState
{
    /// <summary>A blueprint: it is the creature's plan and nothing else.</summary>
    Blueprint,

    /// <summary>A GLB file, byte for byte as it would be written now.</summary>
    AsWritten,

    /// <summary>A GLB file that was written by another version, or altered since.</summary>
    Altered,
}

/// <summary>A file and all that is known of the creature in it; how far it is from another, if that was asked.</summary>
internal sealed record InspectedFile(CreatureSource Source, FileState State, Creature Creature, CreatureFacts Facts, CheckResult Checks, double? Distance);
