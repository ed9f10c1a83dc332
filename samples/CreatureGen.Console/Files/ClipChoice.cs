namespace CreatureGen.Console.Files;

/// <summary>Whether a file holds the creature's motion.</summary>
internal enum ClipChoice
{
    /// <summary>It holds the creature alone.</summary>
    None,

    /// <summary>It holds everything that the creature does.</summary>
    All,
}
