namespace CreatureGen.Motion;

/// <summary>What the feet do in an act.</summary>
public enum ActFooting
{
    /// <summary>They go on as they are asked: it is done at a walk too.</summary>
    Free,

    /// <summary>They stand: a creature that goes stops first, and goes on afterwards as it is asked.</summary>
    Standing,
}
