namespace CreatureGen.Anatomy.Legs;

/// <summary>Where a leg stands.</summary>
internal enum LimbPosture
{
    /// <summary>Under the body: it swings with its length.</summary>
    Under,

    /// <summary>Out to the side: it swings with its reach.</summary>
    Splayed,
}
