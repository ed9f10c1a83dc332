namespace CreatureGen.Motion;

/// <summary>What an act brings to its target.</summary>
public enum ActTool
{
    /// <summary>Nothing: the act has no target.</summary>
    None,

    /// <summary>The mouth, between the tips of the jaws.</summary>
    Mouth,

    /// <summary>The tips of horns, antlers or tusks; else the brow.</summary>
    Brow,

    /// <summary>The foremost foot of the act's side.</summary>
    ForeFoot,

    /// <summary>The rearmost foot of the act's side.</summary>
    HindFoot,

    /// <summary>The hand of the act's side.</summary>
    Hand,

    /// <summary>The tip of the tail.</summary>
    Tail,
}
