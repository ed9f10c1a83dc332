namespace CreatureGen.Console.Files;

/// <summary>What holds for files that have got their names when the machine itself fails.</summary>
internal enum Durability
{
    /// <summary>They are on the disk. Waiting for it takes longer than most creatures do.</summary>
    OnDisk,

    /// <summary>They may be lost, and somebody will look: the next run of a batch compares hashes.</summary>
    LookedAtLater,
}
